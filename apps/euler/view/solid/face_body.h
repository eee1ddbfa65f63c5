#pragma once

#include "apps/euler/view/solid/half_edge_paths.h"

#include <map>
#include <vector>

namespace euler {

/// A face in space, as it is drawn.
///
/// A face is what its loops say, so while a solid is under way it may be bent, run along both sides of a strut, or have
/// no area at all. A flat face is one piece, with its rings as holes; a bent one is stretched over its loops as
/// triangles; one without area has no piece.
struct FaceBody {
    topology::FaceId face;
    topology::Vector normal{}; ///< unit, to the outside; zero of a face without area
    double inner_radius = 0.0; ///< about that of the largest circle inside; 0 without area
    topology::Point middle;    ///< of its corners
    topology::Vector shift{};  ///< of the exploded view
    /// Each an outline and its holes, as they run seen from outside, not shifted.
    std::vector<std::vector<std::vector<topology::Point>>> pieces{};
};

using Rims = std::map<topology::FaceId, std::vector<topology::Point>>; ///< counter-clockwise

class FaceBodies {
public:
    FaceBodies(const topology::Solid& solid, const HalfEdgePaths& paths);

    const FaceBody& operator[](topology::FaceId f) const { return bodies_[places_[f.index]]; }
    const std::vector<FaceBody>& all() const { return bodies_; } ///< in the order in which the faces were made

    /// Moves the faces of every shell apart. `how_far` 0 to 1.
    void explode(const topology::Solid& solid, double how_far, double extent);

    /// Of a drawing in the plane of x and y: every face lies left of its half-edges, and those outside are all around,
    /// as far as their rims.
    void lay_flat(const Rims& outside);

private:
    std::vector<FaceBody> bodies_;
    std::vector<std::size_t> places_; ///< by face
};

} // namespace euler
