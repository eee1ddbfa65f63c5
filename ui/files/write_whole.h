#pragma once

#include <filesystem>
#include <string_view>
#include <system_error>

namespace ui {

/// Writes a file whole or not at all. \returns what hindered it
using WriteWhole = std::error_code (*)(const std::filesystem::path& path, std::string_view text);

} // namespace ui
