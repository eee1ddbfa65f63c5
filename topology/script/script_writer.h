#pragma once

#include <cstddef>
#include <string>

#include "topology/script/script_runner.h"

namespace topology {

/// The journal of a solid as a script that makes it, under its names: a line for each operator.
/// \pre the journal began with the empty solid, which did not lose its last shell since
std::string journal_script(const NamedSolid& solid);
/// The lines of its last operators alone.   \pre the journal has so many steps
std::string journal_script(const NamedSolid& solid, std::size_t n_operators);

/// A script that makes a solid like this one under the same names, whatever way it was made: by inversion.
std::string construction_script(const NamedSolid& solid);

} // namespace topology
