#pragma once

#include <filesystem>
#include <string_view>

namespace ui {

/// Writes a picture's file. \throws std::runtime_error naming the file, with a remedy, unless every byte is written
void write_file(const std::filesystem::path& path, std::string_view bytes);

} // namespace ui
