#pragma once

#include <string>

#include "ui/text/catalogue.h"
#include "ui/text/number_format.h"
#include "ui/widgets/number_field.h"

namespace frame {

/// A factor of the picture's, such as the size of symbols.
struct FactorSlider {
    const char* id;
    std::string name;
    double usual = 1.0;              ///< which a double click brings back
    double least = 0.1, most = 10.0; ///< on the slider, over powers of ten
    double least_typed = 0.01, most_typed = 100.0;
};

/// What the row of a factor is written with.
struct FactorLook {
    ui::NumberFields& fields;
    const ui::Catalogue& tr;
    ui::NumberFormat format;
};

/// Its name and number in one line, the slider below:
///
///     drag                                         the factor
///     Ctrl and a click, or a click on the number   a field for the factor in the slider's place; what is no factor
///                                                  stays there with the reason
///     double click                                 the usual factor
/// \returns whether the factor was changed by the slider, which gives it any number of digits
bool show(const FactorSlider& slider, const FactorLook& look, double& factor);

} // namespace frame
