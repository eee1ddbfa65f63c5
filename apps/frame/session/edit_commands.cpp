#include "apps/frame/session/edit_commands.h"

#include <array>
#include <vector>

#include "apps/frame/document/drawing.h"
#include "apps/frame/session/clipboard_commands.h"
#include "apps/frame/session/in_plane.h"
#include "apps/frame/session/predict_commands.h"
#include "femoop/edit/place.h"

namespace frame {

using ui::Key;
using ui::translatable;

namespace {

using Reason = std::optional<ui::Phrase>;

constexpr std::string_view draw_menu = translatable("Draw");
constexpr std::string_view edit_menu = translatable("Edit");

constexpr std::array tool_entries{
    ToolEntry{ToolKind::Select, "draw.select", translatable("Select and move"), Key::Q},
    ToolEntry{ToolKind::Member, "draw.member", translatable("Member"), Key::M},
    ToolEntry{ToolKind::Node, "draw.node", translatable("Node"), Key::N},
    ToolEntry{ToolKind::Support, "draw.support", translatable("Support"), Key::S},
    ToolEntry{ToolKind::Load, "draw.load", translatable("Load"), Key::L},
    ToolEntry{ToolKind::Hinge, "draw.hinge", translatable("Hinge"), Key::J},
    ToolEntry{ToolKind::Dimension, "draw.dimension", translatable("Dimension line"), Key::D},
    ToolEntry{ToolKind::Delete, "draw.delete", translatable("Delete"), Key::X},
    ToolEntry{ToolKind::Predict, "draw.predict", translatable("Predict the moments"), Key::K},
};

Reason why_not_take(const Desk& desk, ToolKind tool)
{
    if (tool == ToolKind::Predict) return why_not_predict(desk);
    if (tool != ToolKind::Dimension || is_in_plane(desk)) return std::nullopt;
    return translatable("dimension lines stand in plane structures alone");
}

Reason needs_selection(const Desk& desk)
{
    if (!desk.session.selection.is_empty()) return std::nullopt;
    return translatable("nothing is selected");
}

Reason needs_plane_selection(const Desk& desk)
{
    if (const Reason reason = needs_selection(desk)) return reason;
    if (is_in_plane(desk)) return std::nullopt;
    return translatable("a structure in space is not moved with the mouse; change its numbers instead");
}

std::vector<Part> selected(const Desk& desk)
{
    const auto parts = desk.session.selection.parts();
    return {parts.begin(), parts.end()};
}

ui::Phrase about_selection(const Desk& desk, std::string_view one, std::string_view many)
{
    const std::optional<Part> part = desk.session.selection.only();
    return part ? ui::Phrase(one, {{"part", title(desk.session.document(), *part)}}) : ui::Phrase(many);
}

Reason needs_something_to_delete(const Desk& desk)
{
    return is_predicting(desk) ? std::nullopt : needs_selection(desk);
}

void delete_selection(Desk& desk)
{
    if (is_predicting(desk)) return desk.session.prediction.clear();
    desk.session.change({about_selection(desk, translatable("Delete: {part}"), translatable("Delete the selection")),
                         [parts = selected(desk)](Document& document) { remove(document, parts); }});
}

void nudge(Desk& desk, double x, double y)
{
    const double step = desk.hand.settings().grid;
    desk.session.change({about_selection(desk, translatable("Move: {part}"), translatable("Move the selection")),
                         [=, parts = selected(desk)](Document& document) {
                             const femoop::Model before = document.model;
                             place(document, parts, femoop::moved_by({x * step, y * step, 0.0}));
                             join(document, before);
                         }});
}

struct Nudge {
    std::string_view id, label;
    Key key;
    double x, y;
};
constexpr std::array nudges{
    Nudge{"edit.nudge_left", translatable("Move to the left"), Key::Left, -1.0, 0.0},
    Nudge{"edit.nudge_right", translatable("Move to the right"), Key::Right, 1.0, 0.0},
    Nudge{"edit.nudge_up", translatable("Move up"), Key::Up, 0.0, 1.0},
    Nudge{"edit.nudge_down", translatable("Move down"), Key::Down, 0.0, -1.0},
};

void add_history_commands(CommandTable& table)
{
    const auto with_label = [](std::string_view verb, const std::optional<ui::Phrase>& step) {
        return step ? ui::Phrase(verb, {{"step", *step}}) : ui::Phrase();
    };
    table.add({.id = "edit.undo",
               .menu = edit_menu,
               .label = translatable("Undo"),
               .shortcuts = {{Key::Z, ui::ctrl}},
               .run = [](Desk& desk) { desk.session.undo(); },
               .why_not = [](const Desk& desk) -> Reason {
                   if (desk.session.history().can_undo()) return std::nullopt;
                   return translatable("nothing was changed yet");
               },
               .live_label = [=](const Desk& desk) -> ui::Phrase {
                   const auto step = desk.session.history().undo_label();
                   return step ? with_label(translatable("Undo: {step}"), step) : ui::Phrase(translatable("Undo"));
               }});
    table.add({.id = "edit.redo",
               .menu = edit_menu,
               .label = translatable("Redo"),
               .shortcuts = {{Key::Z, ui::ctrl_shift}, {Key::Y, ui::ctrl}},
               .run = [](Desk& desk) { desk.session.redo(); },
               .why_not = [](const Desk& desk) -> Reason {
                   if (desk.session.history().can_redo()) return std::nullopt;
                   return translatable("nothing was undone");
               },
               .live_label = [=](const Desk& desk) -> ui::Phrase {
                   const auto step = desk.session.history().redo_label();
                   return step ? with_label(translatable("Redo: {step}"), step) : ui::Phrase(translatable("Redo"));
               }});
}

void add_selection_commands(CommandTable& table)
{
    table.add({.id = "edit.select_all",
               .menu = edit_menu,
               .label = translatable("Select everything"),
               .shortcuts = {{Key::A, ui::ctrl}},
               .run = [](Desk& desk) { desk.session.selection = everything(desk.session.model()); }});
    table.add({.id = "edit.select_similar",
               .menu = edit_menu,
               .label = translatable("Select what is alike"),
               .shortcuts = {{Key::A, ui::ctrl_shift}},
               .run =
                   [](Desk& desk) {
                       Session& session = desk.session;
                       session.selection = similar(session.model(), session.selection);
                   },
               .why_not = needs_selection});
    table.add({.id = "edit.deselect",
               .menu = edit_menu,
               .label = translatable("Give up, select nothing"),
               .shortcuts = {{Key::Escape, {}}},
               .run = [](Desk& desk) {
                   if (desk.transform) return cancel_transform(desk);
                   if (is_predicting(desk) && !desk.hand.is_sketching()) return desk.session.prediction.clear();
                   if (desk.hand.escape()) return;
                   desk.session.selection.clear();
                   desk.session.pin.reset();
                   desk.session.notice.reset();
               }});
    table.add({.id = "edit.menu",
               .menu = edit_menu,
               .label = translatable("Menu of the selection"),
               .shortcuts = {{Key::F10, ui::shift}},
               .run = [](Desk& desk) { desk.requests.push_back(Request::ContextMenu); }});
    table.add({.id = "edit.delete",
               .menu = edit_menu,
               .label = translatable("Delete the selection"),
               .shortcuts = {{Key::Delete, {}}, {Key::Backspace, {}}},
               .run = delete_selection,
               .why_not = needs_something_to_delete});
}

struct TransformEntry {
    Transform::Kind kind;
    std::string_view id, label;
    Key key;
};
constexpr std::array transforms{
    TransformEntry{Transform::Kind::Move, "edit.move", translatable("Move by numbers…"), Key::M},
    TransformEntry{Transform::Kind::Copy, "edit.copy", translatable("Copy, in a row too…"), Key::D},
    TransformEntry{Transform::Kind::Rotate, "edit.rotate", translatable("Rotate…"), Key::R},
    TransformEntry{Transform::Kind::Mirror, "edit.mirror", translatable("Mirror…"), Key::I},
    TransformEntry{Transform::Kind::Scale, "edit.scale", translatable("Scale…"), Key::E},
};

void add_transform_commands(CommandTable& table)
{
    for (const TransformEntry& entry : transforms) {
        table.add({.id = entry.id,
                   .menu = edit_menu,
                   .label = entry.label,
                   .shortcuts = {{entry.key, ui::ctrl}},
                   .run = [kind = entry.kind](Desk& desk) { begin_transform(desk, kind); },
                   .why_not = needs_plane_selection});
    }
    table.add({.id = "edit.accept",
               .label = translatable("Accept"),
               .shortcuts = {{Key::Enter, {}}},
               .run = accept_transform,
               .why_not = [](const Desk& desk) -> Reason {
                   if (desk.transform) return std::nullopt;
                   return translatable("nothing is under way");
               }});
}

} // namespace

void begin_transform(Desk& desk, Transform::Kind kind)
{
    cancel_transform(desk);
    desk.hand.take(ToolKind::Select);
    desk.transform = transform_of(kind, desk.session.model(), desk.session.selection);
    change_transform(desk);
}

std::optional<ui::Phrase> change_transform(Desk& desk)
{
    Session& session = desk.session;
    return session.change(desk.transform->change(session.history().settled().model));
}

void accept_transform(Desk& desk)
{
    if (!desk.transform) return;
    desk.session.settle();
    desk.transform.reset();
}

void cancel_transform(Desk& desk)
{
    if (!desk.transform) return;
    desk.session.cancel();
    desk.transform.reset();
}

namespace {

// What places are drawn to while the hand draws or drags.
struct SnapSwitch {
    std::string_view id, label;
    Key key;
    bool ToolSettings::*is_on;
};
constexpr std::array snap_switches{
    SnapSwitch{"draw.grid", translatable("Snap to the grid"), Key::F7, &ToolSettings::draws_to_grid},
    SnapSwitch{"draw.snap", translatable("Snap to nodes and lines"), Key::F9, &ToolSettings::draws_to_parts},
};

void add_snap_commands(CommandTable& table)
{
    for (const SnapSwitch& entry : snap_switches) {
        table.add({.id = entry.id,
                   .menu = draw_menu,
                   .label = entry.label,
                   .shortcuts = {{entry.key, {}}},
                   .run =
                       [is_on = entry.is_on](Desk& desk) {
                           ToolSettings& settings = desk.hand.settings();
                           settings.*is_on = !(settings.*is_on);
                       },
                   .is_on = [is_on = entry.is_on](const Desk& desk) { return desk.hand.settings().*is_on; }});
    }
}

} // namespace

void add_tool_commands(CommandTable& table)
{
    for (const ToolEntry& entry : tool_entries) {
        table.add({.id = entry.id,
                   .menu = draw_menu,
                   .label = entry.label,
                   .shortcuts = {{entry.key, {}}},
                   .run =
                       [tool = entry.tool](Desk& desk) {
                           if (tool == ToolKind::Predict) begin_to_predict(desk);
                           else desk.hand.take(tool);
                       },
                   .why_not = [tool = entry.tool](const Desk& desk) { return why_not_take(desk, tool); },
                   .is_on = [tool = entry.tool](const Desk& desk) { return desk.hand.kind() == tool; }});
    }
    add_snap_commands(table);
}

void add_edit_commands(CommandTable& table)
{
    add_history_commands(table);
    table.add({.id = "edit.template",
               .menu = draw_menu,
               .label = translatable("Typical structures…"),
               .shortcuts = {{Key::T, {}}},
               .run = [](Desk& desk) { desk.typical.open(desk.session); }});
    table.add({.id = "edit.section",
               .menu = edit_menu,
               .label = translatable("Section…"),
               .shortcuts = {{Key::C, {}}},
               .run = [](Desk& desk) { desk.section.open(desk.session); }});
    table.add({.id = "edit.new_section",
               .menu = edit_menu,
               .label = translatable("New section…"),
               .shortcuts = {{Key::C, ui::shift}},
               .run = [](Desk& desk) { desk.section.open_new(desk.session); }});
    add_clipboard_commands(table);
    add_selection_commands(table);
    add_transform_commands(table);
    for (const Nudge& entry : nudges) {
        table.add({.id = entry.id,
                   .menu = edit_menu,
                   .label = entry.label,
                   .shortcuts = {{entry.key, {}}},
                   .run = [x = entry.x, y = entry.y](Desk& desk) { nudge(desk, x, y); },
                   .why_not = needs_plane_selection});
    }
}

std::span<const ToolEntry> tools() { return tool_entries; }

} // namespace frame
