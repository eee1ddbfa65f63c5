#pragma once

#include "apps/euler/view/shapes/outline.h"
#include "apps/euler/view/solid/view_transform.h"
#include "ui/paint/geometry.h"

#include <optional>
#include <span>
#include <vector>

namespace euler {

/// How near to the eye a plane is at each place of the sheet, in pixels as all depths here.
struct DepthPlane {
    ui::Point at;
    double nearness = 0.0; ///< there
    ui::Point slope;

    double operator()(ui::Point p) const { return nearness + ui::dot(slope, p - at); }
};
/// Nothing where the plane is seen edge on.
std::optional<DepthPlane> depth_plane(const topology::Point& at, const topology::Vector& normal,
                                      const ViewTransform& transform);

/// A flat piece of a face as it is seen.
struct SeenPiece {
    Region area;
    std::optional<DepthPlane> plane;
    bool is_back = false;
    double nearness = 0.0; ///< mean
    ui::Box bounds{};
};

/// The pieces from the farthest to the nearest, by index: where two overlap on the sheet, the one in front comes later.
///
/// Two pieces are compared where they are farthest apart in depth, which is at a corner of what they share: a corner of
/// one inside the other, or where two sides cross. So any area will do, convex or not, with holes or without. Pieces
/// that cover one another in a circle are taken by their mean depth, and so are all where there are more than
/// `most_compared`.
std::vector<std::size_t> back_to_front(std::span<const SeenPiece> pieces);
inline constexpr std::size_t most_compared = 500;

/// Tells whether a place in space is behind a piece, that is, farther from the eye than some piece that covers it.
///
/// The sheet is divided into cells, each of which knows the pieces that reach into it. \pre the pieces outlive it
class CoverMap {
public:
    explicit CoverMap(std::span<const SeenPiece> pieces);

    bool is_covered(ui::Point at, double nearness) const;

private:
    struct Cell {
        std::size_t column, row;
    };
    Cell cell(ui::Point p) const; ///< the nearest one of a point beside the map

    std::span<const SeenPiece> pieces_;
    ui::Box bounds_{};
    std::vector<std::vector<std::size_t>> cells_; ///< row by row: which pieces reach into each
};

} // namespace euler
