#include "apps/euler/window/gallery_panel.h"

#include <imgui.h>

#include "apps/euler/session/gallery_commands.h"

namespace euler {

void gallery_panel(Workspace& workspace, const CommandTable& commands)
{
    for (const std::string& id : gallery_command_ids()) {
        const auto& command = *commands.find(id);
        if (ImGui::Selectable((label(command, workspace, workspace.session.tr()) + "###" + id).c_str()))
            run(command, workspace);
    }
}

} // namespace euler
