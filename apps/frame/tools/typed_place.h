#pragma once

#include <Eigen/Core>
#include <optional>
#include <string_view>

#include "apps/drawing/place_typed.h"
#include "apps/frame/tools/working_plane.h"
#include "femoop/model/quantity/units.h"
#include "ui/text/display_units.h"

namespace frame {

using drawing::DrawingHand;
using drawing::place_typed;

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
