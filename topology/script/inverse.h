#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "topology/script/script_runner.h"

namespace topology {

/// The lines of a script that take the last operators of a solid back, the last one's first: "kev s1 v1 v2" after
/// "mev s1 f1 v1 v2 1 0 0". They leave the same structure under the same names; the numbers of what they make again are
/// new ones, while undo restores the old. A KEF that moved rings takes several lines. So does a KEV of the inner end of
/// a strut, and a KEF whose face was left with a closed edge alone: a strut is held there meanwhile.
///
/// \pre the journal has so many steps
std::vector<std::string> inverse_lines(const NamedSolid& after, std::size_t n_operators = 1);

} // namespace topology
