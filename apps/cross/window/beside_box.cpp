#include "apps/cross/window/beside_box.h"

#include <imgui.h>

#include "ui/widgets/item_label.h"
#include "ui/widgets/wrapped_text.h"

namespace cross {

std::string beside_box(std::string_view name, std::string_view id)
{
    const float box = ImGui::GetFrameHeight() + ImGui::GetStyle().ItemInnerSpacing.x;
    return ui::item_label(ui::in_lines(name, ImGui::GetContentRegionAvail().x - box), id);
}

} // namespace cross
