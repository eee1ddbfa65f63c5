#pragma once

#include <Eigen/Core>
#include <optional>
#include <string_view>

#include "femoop/model/quantity/units.h"
#include "ui/text/display_units.h"

namespace drawing {

/// A place that a person typed while drawing, lengths in the unit that is shown or with one of their own (`600 cm,3`):
///
///     6,4      x and y
///     @3,2     so far from the last point
///     4<30     a length and an angle from +x, counter-clockwise, from the last point; in degrees, or with a unit
///              of its own: `4<30°`, `4<30 deg`, `4<0.5 rad`
///     4        a length, towards the pointer
///
/// Where the numbers have decimal commas a semicolon stands between them: `6,5;4`, `@3,25;2`, and `4,5<30`. Where they
/// are shown with commas, and drawing has begun, `4,5` is a length.
struct DrawingHand {
    std::optional<Eigen::Vector2d> from;               ///< where drawing began
    Eigen::Vector2d pointer = Eigen::Vector2d::Zero(); ///< the place that it is drawn to
    femoop::Units file{};                              ///< whose lengths places are in
    ui::DisplayUnits shown{};
};

/// Nothing for what is none of these, or needs a place where drawing began and there is none.
std::optional<Eigen::Vector2d> place_typed(std::string_view text, const DrawingHand& hand);

/// A length alone, in the unit that is shown or with one of its own; in the file's unit.
std::optional<double> length_typed(std::string_view text, const DrawingHand& hand);
/// Whether the text is one number, where a comma may be the decimal mark and a line has begun.
bool is_one_number(std::string_view text, bool has_begun, const ui::DisplayUnits& shown);

} // namespace drawing
