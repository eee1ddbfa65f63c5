#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace ui {

/// Text that is broken into lines at this place of the window, 0 being its right border. It may be of any length: Dear
/// ImGui draws what it is given in one piece of at most 16384 letters, so each line is handed over by itself, and one
/// that is longer than anybody reads is shortened.
void wrapped_text(std::string_view utf8, float wrap_at = 0.0F);

/// The text broken after blanks into lines of at most this width in pixels, as the label of a button or a box; a longer
/// word keeps a line to itself.
std::string in_lines(std::string_view utf8, float width);
/// Undone: what was broken after a blank is one line again.
std::string in_one_line(std::string_view lines);

/// The label of a tick box or a round button, known by the id, in as many lines as it needs beside it.
std::string label_beside_box(std::string_view name, std::string_view id);

/// A button that shows the name in as many lines as it needs and is known by the id.
bool wrapped_button(std::string_view name, std::string_view id);

/// A list that is as wide as its panel and shows the chosen name whole: one that is too long stands in lines, on a
/// button with an arrow that opens the list below it. It is as high as the longest of the names asks for, so that what
/// stands below rests whichever is chosen. \returns whether the list is open; then `ImGui::EndCombo` ends it
bool begin_wrapped_combo(std::string_view chosen, const std::vector<std::string>& names, const char* id);

/// What comes next stands beside what came last, in a new line where it has no room.
void beside_if_room(float width, float gap);

} // namespace ui
