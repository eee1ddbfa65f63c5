#pragma once

#include <filesystem>
#include <stdexcept>
#include <string_view>

namespace ui {

/// `what()` names the file, with a remedy.
class NotWritten : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// Writes a picture's file whole or not at all, through links, and with the permissions of the file that it replaces.
/// \throws NotWritten; an old file is then as it was and nothing is left behind
void write_file(const std::filesystem::path& path, std::string_view bytes);

} // namespace ui
