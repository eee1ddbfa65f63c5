#include "apps/euler/window/gallery_panel.h"

#include <imgui.h>

#include "apps/euler/session/gallery_commands.h"

namespace euler {

void gallery_panel(Desk& desk, const CommandTable& commands)
{
    for (const std::string& id : gallery_command_ids()) {
        const auto& command = *commands.find(id);
        if (ImGui::Selectable((label(command, desk, desk.session.tr()) + "###" + id).c_str())) run(command, desk);
    }
}

} // namespace euler
