#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "apps/cli/console.h"
#include "topology/script/script_runner.h"

namespace cli {

/// Is this a file of solids, by its extension: .eul, .obj or .off?
bool is_solid_file(const std::filesystem::path& path);

/// The text of a file; "-" is standard input. \throws UsageError
std::string text_of(const std::string& file, const ui::Catalogue& tr);

/// The solids that a script leaves or a mesh bounds; a mesh's is named s1, its vertices v1 ..., its faces f1 ...
/// \throws UsageError naming the file and the line
std::vector<topology::NamedSolid> load_solids(const std::string& file, const ui::Catalogue& tr);

/// As a script that makes them, or as one mesh, by the extension. \throws UsageError
void save_solids(const std::string& file, const std::vector<topology::NamedSolid>& solids, const ui::Catalogue& tr);

} // namespace cli
