#pragma once

#include <optional>
#include <string>

#include "apps/cli/console.h"
#include "femoop/io/any_model.h"
#include "femoop/io/model_file.h"
#include "femoop/model/model.h"

namespace cli {

/// The model in a file and everything wrong with it; the file "-" is standard input.
femoop::ModelReading examine(const std::string& file, const ui::Catalogue& tr);

/// The same of a file of any kind of model.
femoop::AnyReading examine_any(const std::string& file, const ui::Catalogue& tr);

/// A sound model; warnings and errors go to stderr. Nothing if there was an error.
std::optional<femoop::Model> load_model(const std::string& file, const Console& console);

/// All of standard input. \throws UsageError if it cannot be read
std::string standard_input(const ui::Catalogue& tr);

/// How messages call the file: its path, or "standard input".
std::string display_name(const std::string& file, const ui::Catalogue& tr);

} // namespace cli
