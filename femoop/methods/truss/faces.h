#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "femoop/methods/truss/truss.h"

namespace femoop::truss {

/// One way along a bar.
struct Way {
    MemberId bar;
    bool is_back = false; ///< from its second joint to its first

    friend bool operator==(const Way&, const Way&) = default;
};

NodeId begin_of(const Truss& truss, const Way& way);
NodeId end_of(const Truss& truss, const Way& way);

/// The regions into which the bars of a planar truss divide the plane.
struct Faces {
    std::vector<std::vector<Way>> loops; ///< around each, which lies to the left: clockwise around the outer one
    std::vector<std::array<std::size_t, 2>> left_of; ///< of every bar, to its left on its way and on its way back
    std::size_t outer = 0;

    std::size_t left(const Way& way) const { return left_of[way.bar.index][way.is_back ? 1 : 0]; }
};

/// Two bars that cross or lie on one another, a bar that passes a joint, or a part that no bar joins to the rest.
std::optional<Refusal> why_not_planar(const Truss& truss);

/// Walks around every face, at each joint from one bar to the next one clockwise. \pre planar
Faces faces_of(const Truss& truss);

} // namespace femoop::truss
