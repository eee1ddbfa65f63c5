#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "apps/cli/console.h"
#include "femoop/io/results/results_csv.h"
#include "ui/text/catalogue.h"

namespace cli {

/// Writes a file whole or not at all (femoop/files/whole_file.h).
/// \throws UsageError saying what hinders: a folder that does not exist, a folder of that name, no permission, a full
/// disk
void write_file(const std::filesystem::path& path, std::string_view text, const ui::Catalogue& tr);

/// Says before any work is done that `path` cannot be written. \throws UsageError
void require_writable(const std::filesystem::path& path, const ui::Catalogue& tr);

/// Makes the folder if it is missing. \throws UsageError
void make_folder(const std::filesystem::path& folder, const ui::Catalogue& tr);

/// Writes the tables into the folder, which is made if it is missing, and says so on stderr. \throws UsageError
void write_tables(const std::filesystem::path& folder, const std::vector<femoop::CsvFile>& tables,
                  const Console& console);

} // namespace cli
