#include "apps/frame/session/funicular_commands.h"

#include "apps/frame/document/selected_members.h"
#include "apps/frame/session/shown_method.h"

namespace frame {

using ui::Key;
using ui::Reason;
using ui::translatable;

namespace {

Reason needs_funicular(const Workspace& workspace)
{
    if (workspace.session.funicular.is_on(workspace.session.model())) return std::nullopt;
    return translatable("no funicular is shown; select an arch or a beam and press Shift+F");
}

Reason needs_crown(const Workspace& workspace)
{
    if (Reason reason = needs_funicular(workspace)) return reason;
    if (workspace.session.funicular.has_crown()) return std::nullopt;
    return translatable("the chain is straight and has no hinge that the funicular could pass through");
}

// Loads are read of a model that could be solved, or that only moves.
bool is_understood(const Session& session)
{
    return session.solution().results || !session.solution().mechanisms.empty();
}

} // namespace

Reason why_no_funicular(const Workspace& workspace)
{
    const Session& session = workspace.session;
    if (session.model().analysis != femoop::AnalysisKind::Frame2d)
        return translatable("a funicular is drawn in a plane frame");
    if (session.model().members.empty()) return translatable("the model has no members");
    if (session.view.is_envelope) return translatable("an envelope is of several cases; choose one");
    if (is_understood(session) && !session.hidden) return std::nullopt;
    return session.why_no_results();
}

void begin_funicular(Workspace& workspace)
{
    Session& session = workspace.session;
    close_other_methods(workspace, ShownMethod::Funicular);
    session.funicular.ask(session.model(), selected_members(session.selection));
    session.selection.clear();
    session.pin.reset();
    session.draw_state.camera.reset(); // it has half the sheet
    workspace.tool_controller.select(ToolKind::Funicular);
    const bool is_told_at_foot = session.solution().results.has_value(); // else the motion is
    if (shown_funicular(session) == nullptr && !is_told_at_foot)
        session.notify({translatable("No funicular: {reason}."), {{"reason", session.funicular.why_none()}}});
}

const FunicularPicture* shown_funicular(const Session& session)
{
    const bool is_seen = !session.hidden && !session.view.is_envelope && is_understood(session) &&
                         !session.influence.is_on(session.model());
    return is_seen ? session.funicular.picture(session.model(), session.generation(), session.view) : nullptr;
}

void add_funicular_commands(CommandTable& table)
{
    Menu menu(table, methods_menu);
    menu.step(
        {"view.funicular.hinge", translatable("The funicular through the hinge"), {{Key::J, ui::shift}}},
        [](Workspace& workspace) { workspace.session.funicular.lead_through_crown(); }, needs_crown);
    menu.step(
        {"view.funicular.close", translatable("Close the funicular")},
        [](Workspace& workspace) {
            workspace.session.funicular.clear();
            if (workspace.tool_controller.kind() == ToolKind::Funicular)
                workspace.tool_controller.select(ToolKind::Select);
        },
        needs_funicular);
}

} // namespace frame
