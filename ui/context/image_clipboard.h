#pragma once

#include <filesystem>
#include <optional>

#include "ui/text/message.h"

namespace ui {

/// Puts a PNG file on the clipboard of the X display, where it stays after the program has gone. GLFW's clipboard holds
/// text alone, so xclip (a Debian package) does it.
/// \returns why it could not
std::optional<Message> copy_png(const std::filesystem::path& png);

} // namespace ui
