#include "apps/frame/session/truss_commands.h"

namespace frame {

using ui::Key;
using ui::Reason;
using ui::translatable;

namespace {

void look_at_diagram(Workspace& workspace, bool is_on)
{
    Session& session = workspace.session;
    session.draw_state.camera.reset(); // it has half the sheet
    if (!is_on) return session.cremona.close();
    session.influence.clear();
    session.cremona.show();
}

Reason why_no_diagram(const Workspace& workspace)
{
    if (workspace.session.model().analysis == femoop::AnalysisKind::Truss2d) return std::nullopt;
    return translatable("a Cremona diagram is that of a plane truss");
}

} // namespace

const CremonaPicture* shown_diagram(const Session& session)
{
    if (session.influence.is_on(session.model())) return nullptr;
    return session.cremona.picture(session.model(), session.shown_results(), session.generation(), session.view);
}

void add_truss_commands(CommandTable& table)
{
    Menu(table, translatable("View"))
        .toggle(
            {"view.cremona", translatable("Cremona diagram"), {{Key::O, {}}}},
            [](const Workspace& workspace) { return workspace.session.cremona.is_on(); }, look_at_diagram,
            why_no_diagram);
}

} // namespace frame
