#pragma once

#include <string_view>

namespace ui {

/// A sentence beside the pointer, in as many lines as it needs. For an item that is hovered.
void show_tooltip(std::string_view words);

} // namespace ui
