#pragma once

#include <filesystem>
#include <string_view>

namespace ui {

/// Writes a picture's file. \throws std::runtime_error naming the file, with a remedy, unless every byte is written; a
/// file that was not there is then not left behind in part
void write_file(const std::filesystem::path& path, std::string_view bytes);

} // namespace ui
