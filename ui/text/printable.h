#pragma once

#include <string>

namespace ui {

/// A text for a terminal: control characters, which names of a file may have, would move its cursor or change its
/// colours, and format characters (U+202E and its kind) would turn the order of what is read or hide a part of it. Each
/// is written as JSON does, `\u001b`, beyond four digits in two halves, so that JSON stays what it was; ends of lines
/// and tabs stay.
std::string printable(std::string text);

} // namespace ui
