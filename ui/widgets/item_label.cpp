#include "ui/widgets/item_label.h"

namespace ui {

// A carriage return takes no room and is not drawn; between two number signs they are no mark.
std::string shown_whole(std::string_view name)
{
    std::string label;
    for (const char c : name) label += c == '#' ? "#\r" : std::string(1, c);
    return label;
}

std::string item_label(std::string_view name, std::string_view id)
{
    return shown_whole(name).append("###").append(id);
}

} // namespace ui
