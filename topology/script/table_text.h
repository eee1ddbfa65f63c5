#pragma once

#include <cstddef>
#include <string>

#include "topology/halfedge/solid.h"

namespace topology {

/// Where a solid stands among the others of a model: its number and those beside it, 0 for none.
struct SolidPlace {
    std::size_t number = 1, older = 0, newer = 0;
};

/// The tables of the half-edge structure as the lecture prints them, a line for each entity that lives:
///
///    V = 1 (H = 1) N = 0 P = 2
///    H = 1 (V = 1, E = 1, L = 1) N = 2 P = 2
///    E = 1 (H1 = 2, H2 = 1) N = 0 P = 0
///    L = 1 (H = 2, F = 1) N = 0 P = 0
///    F = 1 (S = 1, LOUT = 0 / LOOPS = 1) N = 0 P = 0
///    S = 1 (V = 1, F = 1, E = 1) N = 0 P = 0
///
/// Numbers count from 1 in the order of making, 0 means none. N is the next older entity of the list and P the next
/// newer one; of a half-edge they are next and prev, of a loop they stay within its face. H1 is an edge's plus half, H2
/// its minus half. LOUT is 0 while the face's outer loop bounds nothing: while both sides of each of its edges lie in
/// it. LOOPS, V, F and E name the oldest of the list. Source   L. F. Martha and A. M. A. Pereira, Geometric and Solid
/// Modeling, lecture on the half-edge structure
std::string table_text(const Solid& solid, const SolidPlace& place = {});

} // namespace topology
