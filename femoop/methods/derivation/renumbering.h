#pragma once

#include <cstddef>

#include "femoop/analysis/trace.h"

namespace femoop::derivation {

/// How far the entries of a symmetric matrix reach from its diagonal, which is what a band or a skyline has to keep.
struct Reach {
    std::size_t half_bandwidth = 0; ///< of a row, at most: from its first entry to the diagonal, both counted
    std::size_t profile = 0;        ///< the sum of the same over all rows
};

/// K as it is numbered on paper, node after node, and with its nodes in reverse Cuthill-McKee order.
struct Renumbering {
    Reach on_paper, renumbered;
};

/// Source  [GeorgeLiu1981, ch. 4]
Renumbering renumbering_of(const SystemTrace& system);

} // namespace femoop::derivation
