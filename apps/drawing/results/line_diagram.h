#pragma once

#include "apps/drawing/results/line_function.h"
#include "apps/drawing/sketch/scene.h"

#include "femoop/model/moving_load.h"

#include <functional>
#include <string>

namespace drawing {

/// Share of a diagram's largest value below which a value is written as zero: it is rounding.
inline constexpr double written_as_zero = 2e-5;

/// How the ordinates of a function are drawn on a line of the structure.
struct LineDiagram {
    SymbolFrame frame; ///< x along the line from its start, y to where positive values are drawn, square to x or not
    ui::Role role = ui::Role::BendingMoment;
    double largest = 0.0;                      ///< absolute value among all lines of the diagram, > 0
    double pixels_per_unit = 0.0;              ///< of the ordinates, > 0
    bool has_signs = true;                     ///< the side alone does not tell the sign: + and - stand in the areas
    std::function<std::string(double)> text{}; ///< of a value
    /// Which number of the results stands at a place, where it is one.
    std::function<femoop::MovingEffect(double x, double value)> number{};
};

/// Filled and hatched ordinates with values at ends, jumps, kinks and extremes (Show::Values), and at equal steps
/// (Show::StepValues). Nothing where all is rounding beside the largest value.
void draw(const Scene& scene, const LineFunction& function, const LineDiagram& look);

} // namespace drawing
