#pragma once

#include "ui/paint/geometry.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace euler {

/// Nodes in the plane, some held fast, joined by springs that pull to no length.
///
/// At rest every free node stands in the middle of its neighbours, those on stiffer springs counting more. Where the
/// net is a planar graph that no two nodes cut apart, and a face of it is held fast as a convex polygon, no springs
/// cross and all faces are convex.
///
/// Source   [Tutte1963]
struct SpringNet {
    struct Spring {
        std::size_t a, b;
        double stiffness;
    };
    std::vector<std::optional<ui::Point>> held; ///< by node; nothing of a free one
    std::vector<Spring> springs;

    std::size_t add_node() { return add_held(std::nullopt); }
    std::size_t add_held(std::optional<ui::Point> at)
    {
        held.push_back(at);
        return held.size() - 1;
    }
    void add_spring(std::size_t a, std::size_t b, double stiffness = 1.0)
    {
        if (a != b) springs.push_back({a, b, stiffness});
    }
};

/// Where the nodes rest; those that no spring joins to a held one stay at the origin.
///
/// Nodes are taken out of the net one by one, the one with the fewest springs first: springs between its neighbours
/// take over its pull. Then they are put back in turn. This is Gaussian elimination; of a planar net few springs come
/// up on the way, so that thousands of nodes take a fraction of a second.
std::vector<ui::Point> at_rest(const SpringNet& net);

} // namespace euler
