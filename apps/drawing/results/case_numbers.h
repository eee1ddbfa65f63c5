#pragma once

#include "femoop/result/results.h"
#include "ui/text/display_units.h"

#include <map>
#include <string>

namespace drawing {

/// Writes the numbers of one load case: what is nothing but rounding beside the largest of its kind is 0, and minus is
/// a true minus sign.
class CaseNumbers {
public:
    CaseNumbers(const femoop::CaseResult& result, const ui::DisplayUnits& units);

    std::string number(double value, ui::Measure measure) const;
    std::string text(double value, ui::Measure measure) const; ///< with its unit

private:
    double without_rounding(double value, ui::Measure measure) const;

    ui::DisplayUnits units_;
    std::map<ui::Measure, double> least_; ///< below which there is rounding alone
};

/// The same for several cases: what is rounding alone differs from one to the other.
class NumbersOfCases {
public:
    NumbersOfCases(femoop::Results results, ui::DisplayUnits units);

    const CaseNumbers& operator[](femoop::CaseId load_case);

private:
    femoop::Results results_;
    ui::DisplayUnits units_;
    std::map<femoop::CaseId, CaseNumbers> numbers_; ///< each when first asked for
};

} // namespace drawing
