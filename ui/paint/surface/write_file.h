#pragma once

#include <filesystem>
#include <string_view>

namespace ui {

/// Writes a picture's file whole or not at all, through links, and with the permissions of the file that it replaces.
/// \throws std::system_error naming the file; an old file is then as it was and nothing is left behind
void write_file(const std::filesystem::path& path, std::string_view bytes);

} // namespace ui
