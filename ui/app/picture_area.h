#pragma once

#include <functional>
#include <string>

#include "ui/text/catalogue.h"

namespace ui {

/// Where the picture is drawn, on the theme's own background, above a bar of a height [px].
void picture_area(float bar, const std::function<void()>& picture);
/// The bar below the picture: the player's buttons.
void bar_below_picture(float height, const std::function<void()>& content);

/// The line at the window's foot.
void status_bar(const std::string& text);

} // namespace ui
