#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <system_error>

#include "ui/text/catalogue.h"
#include "ui/text/phrase.h"

namespace ui {

// What an app says of a file: in one wording, whichever app it is.
Phrase not_opened(const std::filesystem::path& path, const Phrase& reason);
Phrase not_saved(const std::filesystem::path& path, const std::error_code& hindrance);
Phrase saved(const std::filesystem::path& path);
Phrase not_written(const std::filesystem::path& path, const std::string& reason); ///< an export

/// "beam.json", or the word for a document without a file.
std::string file_name(const std::optional<std::filesystem::path>& path, const Catalogue& tr);

} // namespace ui
