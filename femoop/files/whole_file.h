#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <system_error>

namespace files {

/// Writes a file whole or not at all, whatever happens meanwhile: the text goes to a new file in the same folder, to
/// the disk, and then takes the other's name and permissions. A link stays one and what it leads to is replaced, or
/// made where nothing is there. A file that is write-protected is left alone. What is no regular file (/dev/stdout, a
/// pipe) is written to directly. \returns what hindered it; then the old file is as it was and nothing is left behind
std::error_code write_whole_file(const std::filesystem::path& path, std::string_view text);

/// What a file holds, or what hindered reading it.
struct WholeFile {
    std::string text{}; ///< empty where something hindered
    std::error_code hindrance{};
};

inline constexpr std::uintmax_t usual_most_bytes = std::uintmax_t{1} << 30U;

/// Reads a file to its end. Only a regular file is read, and what another program pipes into this one, by the name
/// /dev/stdin: a device has no end, and into another pipe nobody may write. What is none of these is
/// operation_not_supported, what is longer file_too_large.
WholeFile read_whole_file(const std::filesystem::path& path, std::uintmax_t most_bytes = usual_most_bytes);

} // namespace files
