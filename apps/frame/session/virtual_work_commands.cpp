#include "apps/frame/session/virtual_work_commands.h"

#include <algorithm>
#include <variant>

#include "apps/frame/session/shown_method.h"
#include "femoop/geometry/member_geometry.h"

namespace frame {

using ui::Key;
using ui::Reason;
using ui::translatable;

namespace {

Reason needs_virtual_work(const Workspace& workspace)
{
    if (workspace.session.virtual_work.is_on(workspace.session.model())) return std::nullopt;
    return translatable("no virtual work is shown; press Shift+P and click a node or a member");
}

void choose_next_displacement(Workspace& workspace)
{
    AskedWork& asked = workspace.session.virtual_work;
    const femoop::Model& model = workspace.session.model();
    const std::vector<femoop::MovingEffect> choices = asked.choices(model);
    const auto now = std::ranges::find(choices, *asked.displacement(model));
    asked.choose(now + 1 != choices.end() ? *(now + 1) : choices.front());
}

void ask_for_selected(Session& session)
{
    const femoop::Model& model = session.model();
    const std::optional<Part> part = session.selection.only();
    if (!part) return;
    if (const auto* const node = std::get_if<femoop::NodeId>(&*part)) session.virtual_work.ask(model, *node);
    if (const auto* const member = std::get_if<femoop::MemberId>(&*part)) {
        const double length = femoop::geometry_of(model, model[*member]).length;
        session.virtual_work.ask(model, drawing::Cut{*member, 0.5 * length});
    }
}

} // namespace

Reason why_no_virtual_work(const Workspace& workspace)
{
    if (workspace.session.view.is_envelope) return translatable("an envelope is of several cases; choose one");
    return workspace.session.why_no_results();
}

void begin_virtual_work(Workspace& workspace)
{
    Session& session = workspace.session;
    close_other_methods(workspace, ShownMethod::VirtualWork);
    ask_for_selected(session);
    if (session.notice && session.notice->seconds_left) session.notice.reset(); // such as that none is shown
    session.selection.clear();
    session.pin.reset();
    session.draw_state.camera.reset(); // it has half the sheet
    workspace.tool_controller.select(ToolKind::VirtualWork);
}

const drawing::WorkPicture* shown_work(const Session& session)
{
    const bool is_seen = !session.hidden && session.shown_results() != nullptr && !session.view.is_envelope &&
                         !session.truss.is_on() && !session.influence.is_on(session.model());
    if (!is_seen || !session.virtual_work.is_on(session.model())) return nullptr;
    return session.virtual_work.picture(session.model(), session.solution(), session.generation(), session.view);
}

void add_virtual_work_commands(CommandTable& table)
{
    Menu menu(table, methods_menu);
    menu.step(
        {"view.virtual_work.next", translatable("The next displacement of the place"), {{Key::P, ui::ctrl_shift}}},
        choose_next_displacement, needs_virtual_work);
    menu.step(
        {"view.virtual_work.close", translatable("Close the virtual work")},
        [](Workspace& workspace) { workspace.session.virtual_work.clear(); }, needs_virtual_work);
}

} // namespace frame
