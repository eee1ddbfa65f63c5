#pragma once

#include "femoop/model/ids.h"

#include <span>
#include <string>

namespace drawing {

struct Scene;

/// What is written at a node besides its name: the numbers that its degrees of freedom have in the equations.
struct NodeNumbers {
    femoop::NodeId node;
    std::string text;
    bool is_lit = false; ///< it is spoken of now
};

void draw_node_numbers(const Scene& scene, std::span<const NodeNumbers> numbers);

} // namespace drawing
