#include "ui/widgets/modal_turn.h"

#include <imgui.h>

namespace ui {

bool has_turn(const char* id) { return ImGui::IsPopupOpen(id) || !ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId); }

} // namespace ui
