#pragma once

#include <string>

namespace ui {

/// A button of a question: a click answers, and so does Enter where the keyboard has chosen it.
bool answer_button(const std::string& label);

} // namespace ui
