#pragma once

#include <string>
#include <vector>

#include "femoop/model/model.h"
#include "femoop/result/curve.h"
#include "ui/text/display_units.h"

namespace drawing {

/// A result along a stretch of a member, as a formula in the units shown: "−42.68 + 50.6 x − 6 x²".
struct ExpressionLine {
    double from = 0.0, to = 0.0; ///< in the model's unit of length
    std::string formula;
};

/// The formulas of a component from load point to load point, x from the member's first end. Coefficients that are
/// nothing but rounding beside `least`, the smallest value that counts, are left out.
std::vector<ExpressionLine> expression_lines(const femoop::Curve& curve, femoop::MemberComponent component,
                                             const ui::DisplayUnits& units, double least);

} // namespace drawing
