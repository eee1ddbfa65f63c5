#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "topology/script/script_runner.h"

namespace cli {

/// The solids of a script that have not been taken away.
std::vector<topology::NamedSolid> living_solids(const topology::ScriptRunner& runner);

/// What `cremona euler --json` prints: {"solids": {NAME: {"V", "E", "F", "L", "S", "G", "euler", "valid", "loops"}},
/// "steps": n}
std::string euler_json(const std::vector<topology::NamedSolid>& solids, std::size_t n_steps);

} // namespace cli
