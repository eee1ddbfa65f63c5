#pragma once

#include "ui/paint/geometry.h"

#include <cstddef>
#include <span>
#include <vector>

namespace ui {

/// A corner of one of several loops, by their indices.
struct LoopCorner {
    std::size_t loop;
    std::size_t corner;
};

/// The outline of a region with holes as one walk: each hole is entered and left along the same line, a slit without
/// width.
///
///      o-------------o
///      |    o---o    |     The slit runs between the nearest two corners that see each other. Holes are walked against
///      |    |   |    |     the outer loop, whichever way they were given, so that areas by the winding rule are right
///      |    o---o    |     too.
///      |   /         |
///      o--/----------o
///
/// The first loop is the outer one; loops without corners are left out.
std::vector<LoopCorner> keyhole(std::span<const std::vector<Point>> loops);

} // namespace ui
