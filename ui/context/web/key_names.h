#pragma once

#include "ui/command/chord.h"

#include <optional>
#include <string_view>

namespace ui {

/// Keys by the names that browsers give them (KeyboardEvent.key): by what a key writes on this keyboard, so that Ctrl+Z
/// is where the Z is.
std::optional<Key> key_named(std::string_view name);
/// Whether the name is the character that the key writes.
bool is_one_character(std::string_view name);

/// What a browser keeps for itself: reload, its own tools, the size of the page, the way out of the canvas.
bool is_of_browser(std::string_view name, const Modifiers& modifiers);
/// Copy, cut and paste, of which the browser makes an event of the clipboard as well.
bool is_for_clipboard(std::string_view name, const Modifiers& modifiers);

} // namespace ui
