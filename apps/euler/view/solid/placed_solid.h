#pragma once

#include "apps/euler/view/solid/face_body.h"
#include "apps/euler/view/subject.h"

#include <memory>
#include <set>
#include <span>
#include <vector>

namespace euler {

/// A solid in its place, with all that its picture is made from.
class PlacedSolid {
public:
    /// In space, where its vertices say.
    PlacedSolid(std::size_t place, const Subject& subject, const ViewTransform& transform, double explosion);

    /// Drawn in the plane of x and y, seen from above, with every face left of its half-edges.
    struct Layout {
        std::vector<topology::Point> vertices; ///< by index
        Curves curves;                         ///< of edges that are not straight
        Rims outside;                          ///< of the faces that are all around: how far they are filled
        std::set<topology::FaceId> left_out;   ///< which are not drawn at all
    };
    PlacedSolid(std::size_t place, const Subject& subject, const ViewTransform& transform, Layout layout);

    PlacedSolid(const PlacedSolid&) = delete;
    PlacedSolid& operator=(const PlacedSolid&) = delete;

    bool is_left_out(topology::FaceId f) const { return left_out_.contains(f); }

    std::size_t place; ///< among the subjects
    const topology::Solid& solid;
    MarkTable marks;
    AnimatedPositions positions;
    HalfEdgePaths paths;
    FaceBodies bodies;

private:
    std::set<topology::FaceId> left_out_;
};
using PlacedSolids = std::vector<std::unique_ptr<PlacedSolid>>; ///< whose parts refer to one another

PlacedSolids placed_in_space(std::span<const Subject> subjects, const ViewTransform& transform, double explosion);

} // namespace euler
