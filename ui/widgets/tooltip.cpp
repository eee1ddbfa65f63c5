#include "ui/widgets/tooltip.h"

#include <imgui.h>

#include "ui/widgets/wrapped_text.h"

namespace ui {

void show_tooltip(std::string_view words)
{
    ImGui::BeginTooltip();
    wrapped_text(words, 25.0F * ImGui::GetFontSize());
    ImGui::EndTooltip();
}

} // namespace ui
