#pragma once

#include <string>

namespace ui {

/// A button of a question: a click answers, and so does Enter where the keyboard has chosen it.
bool answer_button(const std::string& label);

/// Tab and Shift+Tab go through the answers of the question that follow, as the arrows do, and the chosen one is framed
/// from the beginning.
void let_tab_choose_answer();

} // namespace ui
