#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "topology/script/script_runner.h"

namespace euler {

/// The place among runner.solids() of the living solid of this name.
std::optional<std::size_t> living_solid(const topology::ScriptRunner& runner, std::string_view name);

/// Names that nothing bears or bore: "s2", "v9", "f4".
std::string free_solid_name(const topology::ScriptRunner& runner);
std::string free_vertex_name(const topology::Names& names, const topology::Solid& solid);
std::string free_face_name(const topology::Names& names, const topology::Solid& solid);

} // namespace euler
