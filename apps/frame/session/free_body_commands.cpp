#include "apps/frame/session/free_body_commands.h"

#include <variant>

#include "apps/frame/document/selected_members.h"
#include "apps/frame/session/shown_method.h"
#include "femoop/io/free_body/free_body_text.h"

namespace frame {

using ui::Key;
using ui::Reason;
using ui::translatable;

namespace {

Reason needs_cut(const Workspace& workspace)
{
    if (workspace.session.free_body.has_cut()) return std::nullopt;
    return translatable("no cut is drawn; press B and draw a line across members");
}

Reason needs_free_body(const Workspace& workspace)
{
    if (workspace.session.free_body.is_on(workspace.session.model())) return std::nullopt;
    return translatable("no free body is shown; press B and click a member or a node");
}

Reason needs_ritter_points(const Workspace& workspace)
{
    if (workspace.session.free_body.has_ritter_points()) return std::nullopt;
    return translatable("no cut through three bars of a plane truss is drawn; press B and draw a line across them");
}

std::optional<femoop::NodeId> selected_node(const Session& session)
{
    const std::optional<Part> part = session.selection.only();
    if (!part || !std::holds_alternative<femoop::NodeId>(*part)) return std::nullopt;
    return std::get<femoop::NodeId>(*part);
}

Reason why_not_lift(const Workspace& workspace)
{
    const Session& session = workspace.session;
    if (auto reason = why_no_free_body(workspace)) return reason;
    if (selected_node(session) || !selected_members(session.selection).empty()) return std::nullopt;
    return translatable("no node and no member is selected");
}

void lift_selected(Workspace& workspace)
{
    Session& session = workspace.session;
    close_other_methods(workspace, ShownMethod::FreeBody);
    if (const auto node = selected_node(session)) session.free_body.lift(session.model(), *node);
    else session.free_body.lift(session.model(), selected_members(session.selection));
    session.selection.clear();
    workspace.tool_controller.select(ToolKind::FreeBody);
}

} // namespace

// Of an envelope there is none: its numbers stand in no one equilibrium.
Reason why_no_free_body(const Workspace& workspace)
{
    if (workspace.session.view.is_envelope) return translatable("an envelope is of several cases; choose one");
    return workspace.session.why_no_results();
}

const drawing::FreeBodyPicture* lifted_body(const Session& session)
{
    const femoop::Results* const results = session.shown_results();
    if (results == nullptr || session.view.is_envelope) return nullptr;
    return session.free_body.picture(session.model(), *results, session.generation(), session.view);
}

void notify_uncut(Session& session)
{
    const std::vector<femoop::MemberId> across = session.free_body.take_across();
    if (across.empty()) return;
    const std::string reason = femoop::free_body::uncut_sentence(across, session.model(), session.tr());
    session.notify({translatable("No free body: {reason}."), {{"reason", reason}}});
}

void add_free_body_commands(CommandTable& table)
{
    Menu menu(table, methods_menu);
    menu.step({"view.free_body.selected", translatable("Free body of what is selected"), {{Key::B, ui::shift}}},
              lift_selected, why_not_lift);
    menu.step(
        {"view.free_body.turn", translatable("The other side of the cut"), {{Key::V, {}}}},
        [](Workspace& workspace) { workspace.session.free_body.turn_cut(); }, needs_cut);
    menu.step(
        {"view.free_body.ritter", translatable("Moments about the next Ritter point"), {{Key::Z, {}}}},
        [](Workspace& workspace) { workspace.session.free_body.to_next_ritter_point(); }, needs_ritter_points);
    menu.step(
        {"view.free_body.close", translatable("Close the free body")},
        [](Workspace& workspace) { workspace.session.free_body.clear(); }, needs_free_body);
}

} // namespace frame
