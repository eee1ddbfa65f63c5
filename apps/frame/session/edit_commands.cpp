#include "apps/frame/session/edit_commands.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "apps/frame/document/drawing.h"
#include "apps/frame/session/clipboard_commands.h"
#include "apps/frame/session/free_body_commands.h"
#include "apps/frame/session/funicular_commands.h"
#include "apps/frame/session/in_plane.h"
#include "apps/frame/session/influence_commands.h"
#include "apps/frame/session/predict_commands.h"
#include "apps/frame/session/shown_method.h"
#include "apps/frame/session/virtual_work_commands.h"
#include "femoop/edit/place.h"
#include "ui/workspace/standard_commands.h"

namespace frame {

using ui::Key;
using ui::Reason;
using ui::translatable;

namespace {

using ui::standard::edit_menu;
constexpr std::string_view draw_menu = translatable("Draw");

constexpr std::array tool_entries{
    ToolEntry{ToolKind::Select, "draw.select", translatable("Select and move"), {{Key::Q, {}}}},
    ToolEntry{ToolKind::Member, "draw.member", translatable("Member"), {{Key::M, {}}}},
    ToolEntry{ToolKind::Node, "draw.node", translatable("Node"), {{Key::N, {}}}},
    ToolEntry{ToolKind::Support, "draw.support", translatable("Support"), {{Key::S, {}}}},
    ToolEntry{ToolKind::Load, "draw.load", translatable("Load"), {{Key::L, {}}}},
    ToolEntry{ToolKind::Hinge, "draw.hinge", translatable("Hinge"), {{Key::J, {}}}},
    ToolEntry{ToolKind::Dimension, "draw.dimension", translatable("Dimension line"), {{Key::D, {}}}},
    ToolEntry{ToolKind::Delete, "draw.delete", translatable("Delete"), {{Key::X, {}}}},
    ToolEntry{ToolKind::Predict, "draw.predict", translatable("Predict the moments"), {{Key::K, {}}}},
    ToolEntry{ToolKind::Influence, "draw.influence", translatable("Influence line"), {{Key::I, {}}}},
    ToolEntry{ToolKind::FreeBody, "draw.free_body", translatable("Free body"), {{Key::B, {}}}},
    ToolEntry{ToolKind::Funicular, "draw.funicular", translatable("Funicular"), {{Key::F, ui::shift}}},
    ToolEntry{ToolKind::VirtualWork, "draw.virtual_work", translatable("Virtual work"), {{Key::P, ui::shift}}},
};
constexpr std::size_t n_drawing_tools = 8; // the rest ask for methods
static_assert(tool_entries[n_drawing_tools].value == ToolKind::Predict);

Reason why_not_choose_tool(const Workspace& workspace, ToolKind tool)
{
    if (tool == ToolKind::Predict) return why_not_predict(workspace);
    if (tool == ToolKind::Influence) return why_no_influence_line(workspace);
    if (tool == ToolKind::FreeBody) return why_no_free_body(workspace);
    if (tool == ToolKind::Funicular) return why_no_funicular(workspace);
    if (tool == ToolKind::VirtualWork) return why_no_virtual_work(workspace);
    if (tool != ToolKind::Dimension || is_in_plane(workspace)) return std::nullopt;
    return translatable("dimension lines stand in plane structures alone");
}

Reason needs_selection(const Workspace& workspace)
{
    if (!workspace.session.selection.is_empty()) return std::nullopt;
    return translatable("nothing is selected");
}

std::vector<Part> selected(const Workspace& workspace)
{
    const auto parts = workspace.session.selection.parts();
    return {parts.begin(), parts.end()};
}

ui::Message about_selection(const Workspace& workspace, std::string_view one, std::string_view many)
{
    const std::optional<Part> part = workspace.session.selection.only();
    return part ? ui::Message(one, {{"part", title(workspace.session.document(), *part)}}) : ui::Message(many);
}

Reason needs_something_to_delete(const Workspace& workspace)
{
    return is_predicting(workspace) ? std::nullopt : needs_selection(workspace);
}

void delete_selection(Workspace& workspace)
{
    if (is_predicting(workspace)) return workspace.session.prediction.clear();
    workspace.session.change(
        {about_selection(workspace, translatable("Delete: {part}"), translatable("Delete the selection")),
         [parts = selected(workspace)](Document& document) { remove(document, parts); }});
}

// In space along the axes of the working plane.
void nudge(Workspace& workspace, double x, double y)
{
    const ToolSettings& settings = workspace.tool_controller.settings();
    const WorkingPlane plane = is_in_plane(workspace) ? WorkingPlane{} : settings.plane;
    const Eigen::Vector3d shift = settings.grid * plane.in_space({x, y}, 0.0);
    workspace.session.change(
        {about_selection(workspace, translatable("Move: {part}"), translatable("Move the selection")),
         [=, parts = selected(workspace)](Document& document) {
             const femoop::Model before = document.model;
             place(document, parts, femoop::moved_by(shift));
             join(document, before);
         }});
}

// What Esc does: the innermost of what is under way ends.
void give_up(Workspace& workspace)
{
    if (workspace.transform) return cancel_transform(workspace);
    if (std::exchange(workspace.refused_release, std::nullopt)) return;
    if (is_predicting(workspace) && !workspace.tool_controller.is_sketching())
        return workspace.session.prediction.clear();
    const ToolKind tool = workspace.tool_controller.kind();
    const bool shows_method = tool == ToolKind::Influence || tool == ToolKind::FreeBody ||
                              tool == ToolKind::Funicular || tool == ToolKind::VirtualWork;
    if (shows_method && workspace.tool_controller.tool().escape()) return; // a drag, not the method
    if (tool == ToolKind::Influence) workspace.session.influence.clear();
    if (tool == ToolKind::FreeBody) workspace.session.free_body.clear();
    if (tool == ToolKind::Funicular) workspace.session.funicular.clear();
    if (tool == ToolKind::VirtualWork) workspace.session.virtual_work.clear();
    if (workspace.tool_controller.escape()) return;
    if (workspace.session.truss.is_on()) return workspace.session.truss.close();
    if (workspace.session.view.show.contains(Show::Counting)) { // which keeps loads and results from sight
        workspace.session.view.show.erase(Show::Counting);
        return;
    }
    workspace.session.influence.clear();
    workspace.session.free_body.clear();
    workspace.session.funicular.clear();
    workspace.session.virtual_work.clear();
    workspace.session.selection.clear();
    workspace.session.pin.reset();
    workspace.session.notice.reset();
}

void select_similar(Workspace& workspace)
{
    Session& session = workspace.session;
    session.selection = similar(session.model(), session.selection);
}

void add_selection_commands(CommandTable& table)
{
    Menu menu(table, edit_menu);
    menu.step({"edit.select_all", translatable("Select everything"), {{Key::A, ui::ctrl}}},
              [](Workspace& workspace) { workspace.session.selection = everything(workspace.session.model()); });
    menu.step({"edit.select_similar", translatable("Select what is alike"), {{Key::A, ui::ctrl_shift}}}, select_similar,
              needs_selection);
    menu.step({"edit.deselect", translatable("Give up, select nothing"), {{Key::Escape, {}}}}, give_up);
    menu.step({"edit.menu", translatable("Menu of the selection"), {{Key::F10, ui::shift}}},
              [](Workspace& workspace) { workspace.requests.push_back(Request::ContextMenu); });
    menu.step({"edit.delete", translatable("Delete the selection"), {{Key::Delete, {}}, {Key::Backspace, {}}}},
              delete_selection, needs_something_to_delete);
}

void add_transform(Menu& menu, ui::CommandName name, Transform::Kind kind,
                   Reason (*why_not)(const Workspace&) = needs_selection)
{
    menu.step(
        std::move(name), [kind](Workspace& workspace) { begin_transform(workspace, kind); }, why_not);
}

Reason why_not_bend(const Workspace& workspace)
{
    const Session& session = workspace.session;
    if (is_truss(session.model().analysis)) return translatable("the bars of a truss stay straight");
    const auto is_member = [](const Part& part) { return std::holds_alternative<femoop::MemberId>(part); };
    if (std::ranges::any_of(session.selection.parts(), is_member)) return std::nullopt;
    return translatable("select members first");
}

Reason why_not_accept(const Workspace& workspace)
{
    if (workspace.transform) return std::nullopt;
    return translatable("nothing is under way");
}

void add_transform_commands(CommandTable& table)
{
    using Kind = Transform::Kind;
    Menu menu(table, edit_menu);
    add_transform(menu, {"edit.move", translatable("Move by numbers…"), {{Key::M, ui::ctrl}}}, Kind::Move);
    add_transform(menu, {"edit.copy", translatable("Copy, in a row too…"), {{Key::D, ui::ctrl}}}, Kind::Copy);
    add_transform(menu, {"edit.rotate", translatable("Rotate…"), {{Key::R, ui::ctrl}}}, Kind::Rotate);
    add_transform(menu, {"edit.mirror", translatable("Mirror…"), {{Key::I, ui::ctrl}}}, Kind::Mirror);
    add_transform(menu, {"edit.scale", translatable("Scale…"), {{Key::E, ui::ctrl}}}, Kind::Scale);
    add_transform(menu, {"edit.bend", translatable("Bend into an arch…"), {{Key::J, ui::ctrl}}}, Kind::Bend,
                  why_not_bend);
    Menu(table, {}).step({"edit.accept", translatable("Accept"), {{Key::Enter, {}}}}, accept_transform, why_not_accept);
}

void add_nudge(Menu& menu, ui::CommandName name, double x, double y)
{
    menu.step(
        std::move(name), [x, y](Workspace& workspace) { nudge(workspace, x, y); }, needs_selection);
}

void add_nudges(CommandTable& table)
{
    Menu menu(table, edit_menu);
    add_nudge(menu, {"edit.nudge_left", translatable("Move to the left"), {{Key::Left, {}}}}, -1.0, 0.0);
    add_nudge(menu, {"edit.nudge_right", translatable("Move to the right"), {{Key::Right, {}}}}, 1.0, 0.0);
    add_nudge(menu, {"edit.nudge_up", translatable("Move up"), {{Key::Up, {}}}}, 0.0, 1.0);
    add_nudge(menu, {"edit.nudge_down", translatable("Move down"), {{Key::Down, {}}}}, 0.0, -1.0);
}

} // namespace

void begin_transform(Workspace& workspace, Transform::Kind kind)
{
    cancel_transform(workspace);
    workspace.tool_controller.select(ToolKind::Select);
    workspace.transform = transform_of(kind, workspace.session.model(), workspace.session.selection);
    change_transform(workspace);
}

std::optional<ui::Message> change_transform(Workspace& workspace)
{
    Session& session = workspace.session;
    return session.change(workspace.transform->change(session.history().settled().model));
}

void accept_transform(Workspace& workspace)
{
    if (!workspace.transform) return;
    workspace.session.settle();
    workspace.transform.reset();
}

void cancel_transform(Workspace& workspace)
{
    if (!workspace.transform) return;
    workspace.session.cancel();
    workspace.transform.reset();
}

namespace {

// What places are drawn to while the hand draws or drags.
using SnapSwitch = ui::Choice<bool ToolSettings::*>;
constexpr std::array snap_switches{
    SnapSwitch{&ToolSettings::draws_to_grid, "draw.grid", translatable("Snap to the grid"), {{Key::F7, {}}}},
    SnapSwitch{&ToolSettings::draws_to_parts, "draw.snap", translatable("Snap to nodes and lines"), {{Key::F9, {}}}},
};

void choose_tool(Workspace& workspace, ToolKind tool)
{
    if (tool == ToolKind::Influence) close_other_methods(workspace, ShownMethod::InfluenceLine);
    if (tool == ToolKind::FreeBody) close_other_methods(workspace, ShownMethod::FreeBody);
    workspace.session.forget_notice();
    if (tool == ToolKind::Predict) begin_to_predict(workspace);
    else if (tool == ToolKind::Funicular) begin_funicular(workspace);
    else if (tool == ToolKind::VirtualWork) begin_virtual_work(workspace);
    else workspace.tool_controller.select(tool);
}

// What a scenario sets of a typical structure, a section, combinations and trains that are being made.
constexpr std::array typical_verbs{"template.choose", "template.set", "template.replace", "template.insert",
                                   "template.cancel"};
constexpr std::array section_verbs{"section.shape", "section.profile", "section.turned", "section.name",
                                   "section.set",   "section.new",     "section.accept", "section.cancel"};

constexpr std::array design_verbs{"design.code", "design.action", "design.state", "design.accept", "design.cancel"};

constexpr std::array train_verbs{"trains.choose",   "trains.take",        "trains.new",    "trains.copy",
                                 "trains.delete",   "trains.name",        "trains.axle",   "trains.distance",
                                 "trains.longest",  "trains.uniform",     "trains.impact", "trains.both",
                                 "trains.add_axle", "trains.delete_axle", "trains.accept", "trains.cancel"};

template <class Draft> CommandTable::RunWith run_command(Draft Workspace::*draft)
{
    return [draft](Workspace& workspace, const ui::Argument& argument) -> Reason {
        const std::string_view verb = argument.id.substr(argument.id.find('.') + 1);
        const auto mismatch = (workspace.*draft).run_command(workspace.session, verb, argument.text);
        return mismatch ? Reason(*mismatch) : std::nullopt;
    };
}

void add_tools(Menu& menu, std::span<const ToolEntry> entries)
{
    for (const ToolEntry& entry : entries)
        menu.choice(
            entry, [](const Workspace& workspace) { return workspace.tool_controller.kind(); }, choose_tool,
            [tool = entry.value](const Workspace& workspace) { return why_not_choose_tool(workspace, tool); });
}

} // namespace

void add_method_tools(CommandTable& table)
{
    Menu menu(table, methods_menu);
    add_tools(menu, std::span(tool_entries).subspan(n_drawing_tools));
}

void add_tool_commands(CommandTable& table)
{
    Menu menu(table, draw_menu);
    add_tools(menu, std::span(tool_entries).first(n_drawing_tools));
    menu.toggles(
        snap_switches, [](auto& workspace, auto item) -> auto& { return workspace.tool_controller.settings().*item; });
}

void add_edit_commands(CommandTable& table)
{
    ui::standard::add_undo_and_redo(table);
    Menu(table, draw_menu)
        .step({"edit.template", translatable("Typical structures…"), {{Key::T, {}}}},
              [](Workspace& workspace) { workspace.typical.open(workspace.session); });
    Menu menu(table, edit_menu);
    menu.step({"edit.section", translatable("Section…"), {{Key::C, {}}}},
              [](Workspace& workspace) { workspace.section.open(workspace.session); });
    menu.step({"edit.new_section", translatable("New section…"), {{Key::C, ui::shift}}},
              [](Workspace& workspace) { workspace.section.open_new(workspace.session); });
    add_clipboard_commands(table);
    add_selection_commands(table);
    add_transform_commands(table);
    add_nudges(table);
    for (const std::string_view id : typical_verbs) table.with_argument(id, run_command(&Workspace::typical));
    for (const std::string_view id : section_verbs) table.with_argument(id, run_command(&Workspace::section));
    for (const std::string_view id : design_verbs) table.with_argument(id, run_command(&Workspace::design));
    for (const std::string_view id : train_verbs) table.with_argument(id, run_command(&Workspace::trains));
}

std::span<const ToolEntry> tools() { return tool_entries; }

} // namespace frame
