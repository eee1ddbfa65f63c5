#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "ui/paint/style.h"
#include "ui/paint/text_measure.h"

namespace ui {

/// A text broken between words into lines of at most `width` logical pixels; a longer word has a line of its own. None
/// begins with a dot that parts two words, and a number stays with its unit, a sign with the term after it.
std::vector<std::string> wrapped_lines(const Fonts& fonts, std::string_view text, const TextStyle& style, double width);

} // namespace ui
