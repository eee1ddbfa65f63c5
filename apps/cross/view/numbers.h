#pragma once

#include <string>

#include "apps/cross/document/solution.h"
#include "apps/cross/view/look.h"
#include "ui/text/display_units.h"

namespace cross {

/// The units in which a document's numbers are shown, and the language's decimal mark.
ui::DisplayUnits units_of(const femoop::Model& model, const ui::Catalogue& tr);

/// What is wrong with a structure, in the reader's language.
std::string fault_text(const femoop::Fault& fault, const ui::Catalogue& tr);

/// How moments and factors are written on a sheet: so many decimals that the tolerance shows, or the significant digits
/// that the method rounds to, or fractions.
class Numbers {
public:
    /// \pre the solution has a task
    Numbers(const Document& document, const Solution& solution, const Look& look);

    /// In the sign convention that is looked by, without unit: "−48.00".
    std::string moment(const femoop::cross::End& end, double end_moment) const;
    std::string moment(double value) const;
    std::string factor(double value) const; ///< "0.471", "8/17"
    /// The same with so many decimals that the tolerance shows, whatever the method rounds to.
    Numbers unrounded() const;
    const ui::DisplayUnits& units() const { return units_; }
    std::string moment_unit() const { return units_.unit(ui::Measure::Moment).name; }

private:
    std::string written(double shown) const;

    ui::DisplayUnits units_;
    Signs signs_;
    bool fractions_;
    int digits_;
    int decimals_ = 2;
};

} // namespace cross
