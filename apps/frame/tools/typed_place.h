#pragma once

#include <Eigen/Core>
#include <optional>
#include <string_view>

#include "apps/frame/tools/working_plane.h"
#include "femoop/model/quantity/units.h"
#include "ui/text/display_units.h"

namespace frame {

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

/// A place typed while drawing in space: three coordinates, or what is typed in the plane, counted in the working
/// plane:
///
///     6,4,3      x, y and z
///     @0,0,3     so far from the last point
///     6,4        two coordinates in the working plane; @3,2 and 4<30 too, in a plane parallel to it
///     4          a length, towards the pointer
struct SpaceHand {
    std::optional<Eigen::Vector3d> from, pointer;
    WorkingPlane plane{};
    femoop::Units file{};
    ui::DisplayUnits shown{};
};
std::optional<Eigen::Vector3d> place_typed_in_space(std::string_view text, const SpaceHand& hand);

} // namespace frame
