#pragma once

#include <functional>
#include <string>

#include "ui/text/catalogue.h"

namespace ui {

/// A window over the picture with a text that can be copied, until it is closed.
/// \param title  of the window, translated   \param beside_copy  more buttons
void text_window(const std::string& title, const std::string& words, const Catalogue& tr, bool& is_open,
                 const std::function<void()>& beside_copy = {});

} // namespace ui
