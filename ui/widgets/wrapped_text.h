#pragma once

#include <string_view>

namespace ui {

/// Text that is broken into lines at this place of the window, 0 being its right border. It may be of any length: Dear
/// ImGui draws what it is given in one piece of at most 16384 letters, so each line is handed over by itself, and one
/// that is longer than anybody reads is shortened.
void wrapped_text(std::string_view utf8, float wrap_at = 0.0F);

} // namespace ui
