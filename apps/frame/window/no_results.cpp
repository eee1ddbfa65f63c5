#include "apps/frame/window/no_results.h"

#include <imgui.h>

#include <algorithm>
#include <vector>

#include "apps/frame/session/predict_commands.h"
#include "ui/widgets/wrapped_text.h"

namespace frame {

bool explain_no_results(Workspace& workspace)
{
    const auto reason = workspace.session.why_no_results();
    if (!reason) return false;
    ui::wrapped_text(workspace.session.view.tr(*reason));
    offer_to_reveal(workspace);
    return true;
}

const femoop::Fault* why_not_solved(const Session& session)
{
    const BlankCase* const blank = session.shown_blank();
    const std::vector<femoop::Fault>& faults = blank != nullptr ? blank->faults : session.solution().faults;
    const auto error = std::ranges::find_if(faults, femoop::is_error);
    return session.shown_results() != nullptr || error == faults.end() ? nullptr : &*error;
}

void offer_to_reveal(Workspace& workspace)
{
    if (!workspace.session.hidden) return;
    const std::string label = workspace.session.view.tr("Reveal the results");
    if (ui::wrapped_button(label, "reveal")) hide_or_reveal(workspace);
}

} // namespace frame
