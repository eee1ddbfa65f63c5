#include "apps/frame/window/description_window.h"

#include <imgui.h>

#include "apps/frame/window/no_results.h"
#include "ui/widgets/text_window.h"

namespace frame {

void description_window(Workspace& workspace, bool& is_open)
{
    const ui::Catalogue& tr = workspace.tr();
    ui::text_window(tr("Model and results in words"), description(workspace.session), tr, is_open, [&] {
        if (workspace.session.hidden) ImGui::SameLine();
        offer_to_reveal(workspace);
    });
}

} // namespace frame
