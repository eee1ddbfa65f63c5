#pragma once

#include <filesystem>
#include <string_view>
#include <system_error>

namespace files {

/// Writes a file whole or not at all, whatever happens meanwhile: the text goes to a new file in the same folder, to
/// the disk, and then takes the other's name and permissions. A link stays one and what it leads to is replaced, or
/// made where nothing is there. A file that is write-protected is left alone. What is no regular file (/dev/stdout, a
/// pipe) is written to directly. \returns what hindered it; then the old file is as it was and nothing is left behind
std::error_code write_whole_file(const std::filesystem::path& path, std::string_view text);

} // namespace files
