#pragma once

#include <string_view>
#include <vector>

#include "apps/plane/outline/curve.h"

namespace outline {

/// The curves of the data of an SVG path, one after the other: its straight runs, its arcs, and its Bezier pieces, which
/// are cubic, in chains.
/// Source  W3C, Scalable Vector Graphics 1.1, 8.3 (path data), F.6.5 (the centre of an elliptical arc)
/// \throws topology::LineError
std::vector<Curve> svg_path(std::string_view data);

/// Numbers separated by blanks or commas, as SVG writes them. \throws topology::LineError
std::vector<double> svg_numbers(std::string_view text);

/// The product of an attribute `transform`. \throws topology::LineError
Affine svg_transform(std::string_view text);

} // namespace outline
