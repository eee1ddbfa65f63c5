#pragma once

#include <optional>

#include "femoop/plane/analysis/plane_results.h"

namespace femoop::plane {

/// N, V and M on a cut by the equilibrium of what lies on either side of it: from the forces at the nodes between the
/// elements that it crosses and the others, which balance all loads and reactions there, whatever the elements' stresses.
/// What is applied to the crossed elements themselves acts on the one side of the cut or on the other, which is not told.
///
/// Signs   those of CutForces
/// Source  nodal forces K u - f of elements balance [ZienkiewiczTaylor2000, ch. 1]
struct CutBalance {
    CutForces by_first,
        by_second;     ///< by the part behind x' and by that before it; equal where nothing is applied between
    CutForces applied; ///< between, as much as the balance may miss by it
    /// Of all together: the largest of N, V and M over the length of the cut, or a thousandth of all reactions.
    double size = 0.0;

    bool is_exact(const Cut& cut) const; ///< nothing is applied between
    CutForces mean() const;
};

/// Nothing where the cut does not part the body: one end lies in material, or both sides hang together around it.
std::optional<CutBalance> cut_balance(const PlaneResults& results, const PlaneCase& result, const Cut& cut);

/// By how much forces on the cut miss the balance at least: 0 between both parts' and as far from them as what is applied
/// there may take them, relative to its size, M over the cut's length.
CutForces missed(const CutForces& forces, const CutBalance& balance, const Cut& cut);

/// What is told of a cut whose stresses do not balance what lies beyond it.
struct CutWarning {
    double missed = 0.0; ///< the largest of what N, V and M miss, relative to the largest of them
    int digits = 0;      ///< of that one that hold
    CutForces balanced;  ///< by equilibrium
};
/// Nothing where they balance to within two hundredths, where the cut does not part the body, and where more is applied to
/// the crossed elements than they miss, so that the balance is no better known.
std::optional<CutWarning> cut_warning(const PlaneResults& results, const PlaneCase& result, const Cut& cut);

} // namespace femoop::plane
