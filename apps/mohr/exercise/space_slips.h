#pragma once

#include "apps/mohr/exercise/slips.h"

namespace mohr {

/// The mistakes of what is asked of the three principal stresses: invariants, their order, the largest shear, an
/// oblique plane, criteria.
std::vector<Slip> space_slips(Asked asked, const Exercise& exercise, const Numbers& numbers);

} // namespace mohr
