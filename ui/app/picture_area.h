#pragma once

#include <functional>
#include <string>

#include "ui/text/catalogue.h"

namespace ui {

/// Where the picture is drawn, on the theme's own background, above a bar of a height [px].
void picture_area(float bar, const std::function<void()>& picture);
/// A bar of buttons above the picture or below it.
void button_bar(const char* id, float height, const std::function<void()>& content);

/// The line at the window's foot.
void status_bar(const std::string& text);

} // namespace ui
