#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "femoop/analysis/trace.h"

namespace femoop::derivation {

/// What elimination of a symmetric matrix in one order has to keep.
struct Reach {
    std::size_t half_bandwidth = 0; ///< of a row, at most: from its first entry to the diagonal, both counted
    std::size_t profile = 0;        ///< the sum of the same over all rows
    std::size_t factor = 0;         ///< entries of L, the diagonal and the zeros that are filled in among them
};

/// The matrix that is solved as it is numbered on paper, node after node, and as the solver eliminates.
struct Renumbering {
    Reach given, solved;
    SolverKind solver{};
    Ordering ordering{};
    std::vector<std::int32_t> place; ///< of each unknown in the order of elimination, from 0

    bool is_same_order() const;
    /// Does the solver's order keep no less and no more?
    bool is_no_gain() const;
};

/// Source  [GeorgeLiu1981, ch. 4]
Renumbering renumbering_of(const SystemTrace& system);

/// The system that is solved, without what ties leave out, on paper and with its unknowns in the order of elimination.
SystemTrace as_given(const SystemTrace& system);
SystemTrace as_eliminated(const SystemTrace& system);

} // namespace femoop::derivation
