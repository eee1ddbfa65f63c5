#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <span>

#include "apps/drawing/cut.h"
#include "apps/drawing/grid.h"
#include "femoop/model/model.h"

namespace frame {

/// What a place that is pointed at was drawn to, the strongest first.
enum class SnapKind : std::uint8_t {
    Node,          ///< or the place where drawing began
    Intersection,  ///< of two members that cross without a node
    Midpoint,      ///< of a member
    Perpendicular, ///< the foot on a member of a line from the place where drawing began
    OnMember,      ///< at a round distance from its start
    Grid,
    Ray, ///< a multiple of 15 degrees from the place where drawing began; level and upright at a round coordinate, and
         ///< as strong as the grid, else at a round length
    Free ///< nothing: the place is rounded, so that its numbers are short
};

/// A place in the plane of a model, in its unit of length, and what it was drawn to.
struct Snap {
    Eigen::Vector2d place = Eigen::Vector2d::Zero();
    SnapKind kind = SnapKind::Free;

    friend bool operator==(const Snap&, const Snap&) = default;
};

struct SnapOptions {
    double reach = 0.1;                    ///< how near the pointer must be to what it is drawn to [length]
    double grid = 1.0;                     ///< distance of the grid's lines [length]; 0: there is none
    double fine = 0.1;                     ///< to which places are rounded that nothing draws [length]; 0: to nothing
    std::optional<Eigen::Vector2d> from{}; ///< where drawing began
    std::span<const femoop::NodeId> moving{}; ///< are being dragged: neither they nor their members draw to themselves
    bool to_parts = true;                     ///< and to rays; else to the grid alone
    bool is_off = false;                      ///< the place is where the pointer is
};

/// The place that is meant by the pointer's place. Of what lies within reach the strongest kind wins, of one kind the
/// nearest.
/// \pre a plane model (truss2d, frame2d, grillage)
Snap snap(const femoop::Model& model, const Eigen::Vector2d& pointer, const SnapOptions& options);

/// The same in a model in space.
struct SnapInSpace {
    Eigen::Vector3d place = Eigen::Vector3d::Zero();
    SnapKind kind = SnapKind::Free;
};

struct SnapInSpaceOptions {
    double reach = 0.1; ///< along the member [length]
    double fine = 0.1;  ///< to which its round distances are rounded [length]
    std::optional<Eigen::Vector3d> from{};
    bool is_off = false; ///< the place is where the pointer is
};

/// The place on a member that is meant by the one at which the pointer is seen on it.
SnapInSpace snap_on_member(const femoop::Model& model, const drawing::Cut& pointed, const SnapInSpaceOptions& options);

/// Where a node of a plane model is.
Eigen::Vector2d place_of(const femoop::Model& model, femoop::NodeId node);

using drawing::round_grid;

} // namespace frame
