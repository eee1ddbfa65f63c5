#include "apps/frame/window/no_results.h"

#include <imgui.h>

#include "apps/frame/session/predict_commands.h"
#include "ui/widgets/wrapped_text.h"

namespace frame {

bool explain_no_results(Desk& desk)
{
    const auto reason = desk.session.why_no_results();
    if (!reason) return false;
    ui::wrapped_text(desk.session.view.tr(*reason));
    offer_to_reveal(desk);
    return true;
}

void offer_to_reveal(Desk& desk)
{
    if (!desk.session.hidden) return;
    const std::string label = desk.session.view.tr("Reveal the results");
    if (ImGui::Button((label + "###reveal").c_str())) hide_or_reveal(desk);
}

} // namespace frame
