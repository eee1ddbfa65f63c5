#pragma once

#include "ui/paint/geometry.h"

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace euler {

/// Nodes in the plane, some held fast, joined by equal springs that pull to no length.
///
/// At rest every free node stands in the middle of its neighbours. Where the net is a planar graph that no two nodes
/// cut apart, and a face of it is held fast as a convex polygon, no springs cross and all faces are convex. Source   W.
/// T. Tutte, "How to draw a graph", Proceedings of the London Mathematical Society, 1963
struct SpringNet {
    std::vector<std::optional<ui::Point>> held; ///< by node; nothing of a free one
    std::vector<std::pair<std::size_t, std::size_t>> springs;

    std::size_t add_node() { return add_held(std::nullopt); }
    std::size_t add_held(std::optional<ui::Point> at)
    {
        held.push_back(at);
        return held.size() - 1;
    }
    void add_spring(std::size_t a, std::size_t b)
    {
        if (a != b) springs.emplace_back(a, b);
    }
};

/// Where the nodes rest, by conjugate gradients; nodes that no spring holds stay at the origin.
std::vector<ui::Point> at_rest(const SpringNet& net);

} // namespace euler
