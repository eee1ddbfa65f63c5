#pragma once

#include <string>
#include <string_view>

namespace ui {

/// A label that Dear ImGui shows whole, whatever a person has named something: two number signs in a label begin an id,
/// which is not drawn.
std::string shown_whole(std::string_view name);
/// The label of a widget that shows the name and is known by the id.
std::string item_label(std::string_view name, std::string_view id);

} // namespace ui
