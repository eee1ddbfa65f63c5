#include "apps/cross/session/commands.h"

#include <algorithm>
#include <array>
#include <functional>

#include "apps/cross/document/file.h"
#include "apps/cross/session/beam_edit.h"
#include "apps/cross/session/exercise_commands.h"
#include "apps/cross/session/own_order.h"
#include "apps/cross/view/numbers.h"
#include "ui/workspace/file_commands.h"

namespace cross {

namespace fc = femoop::cross;
using ui::Key;
using ui::Message;
using ui::Reason;
using ui::translatable;
using Menu = ui::MenuBuilder<Workspace>;

namespace {

using ui::standard::edit_menu;
constexpr std::string_view work_menu = translatable("Work");
constexpr std::string_view method_menu = translatable("Method");
constexpr std::string_view show_menu = translatable("Show");

constexpr std::array topic_entries{
    TopicEntry{Topic::Sheet, "show.sheet", translatable("Table")},
    TopicEntry{Topic::Comparison, "show.comparison", translatable("Comparison")},
    TopicEntry{Topic::Sways, "show.sways", translatable("Sways")},
    TopicEntry{Topic::Convergence, "show.convergence", translatable("Convergence")},
    TopicEntry{Topic::Kani, "show.kani", "Kani"},
    TopicEntry{Topic::Equations, "show.equations", translatable("Equations")},
    TopicEntry{Topic::Exercises, "show.exercises", translatable("Exercises")},
};

Reason why_no_end(const Workspace& workspace, Side side)
{
    if (end_of_spans(workspace.session.document().model, side)) return std::nullopt;
    return Message(translatable("no span ends alone at this side"));
}

void add_end(Menu& menu, ui::CommandName name, Side side)
{
    const auto run = [side](Workspace& workspace) {
        const femoop::Model& model = workspace.session.document().model;
        workspace.session.change(with_next_support(model, *end_of_spans(model, side)), translatable("Change an end"));
    };
    menu.step(std::move(name), run, [side](const Workspace& workspace) { return why_no_end(workspace, side); });
}

void add_span(Workspace& workspace)
{
    if (auto next = with_span_added(workspace.session.document().model))
        workspace.session.change(std::move(*next), translatable("Add a span"));
}

void remove_span(Workspace& workspace)
{
    if (auto next = with_span_removed(workspace.session.document().model))
        workspace.session.change(std::move(*next), translatable("Remove the last span"));
}

Reason why_not_add_span(const Workspace& workspace)
{
    if (with_span_added(workspace.session.document().model)) return std::nullopt;
    return Message(translatable("no span ends alone at this side"));
}

Reason why_not_remove_span(const Workspace& workspace)
{
    if (with_span_removed(workspace.session.document().model)) return std::nullopt;
    return Message(translatable("there is no span that could go"));
}

void add_structure_commands(CommandTable& table)
{
    Menu menu(table, edit_menu);
    add_end(menu, {"edit.left_end", translatable("Left end: pinned, fixed, free")}, Side::Left);
    add_end(menu, {"edit.right_end", translatable("Right end: pinned, fixed, free")}, Side::Right);
    menu.step({"edit.add_span", translatable("Add a span")}, add_span, why_not_add_span);
    menu.step({"edit.remove_span", translatable("Remove the last span")}, remove_span, why_not_remove_span);
}

Reason why_no_load(const Workspace& workspace)
{
    if (workspace.session.worksheet() != nullptr)
        return Message(translatable("an exercise is of one structure; end it first"));
    if (!workspace.session.solution().task) return Message(translatable("this structure cannot be distributed"));
    return std::nullopt;
}

Reason why_no_tool(const Workspace& workspace)
{
    if (workspace.session.tool != Tool::None) return std::nullopt;
    return Message(translatable("no load is in hand"));
}

void edit_in_frame(Workspace& workspace)
{
    workspace.handed.push_back({.program = "frame", .document = write_document(workspace.session.document())});
    workspace.notify(translatable("the structure is edited in a window of its own, as a copy"));
}

constexpr std::array load_tools{
    ui::Choice<Tool>{
        Tool::UniformLoad, "edit.uniform_load", translatable("Add a uniform load: click a member"), {{Key::Q, {}}}},
    ui::Choice<Tool>{Tool::PointLoad,
                     "edit.point_load",
                     translatable("Add a force: click a member or a node"),
                     {{Key::Q, ui::shift}}},
};

void add_load_commands(CommandTable& table)
{
    Menu menu(table, edit_menu);
    menu.choices(
        load_tools, [](const Workspace& workspace) { return workspace.session.tool; },
        [](Workspace& workspace, Tool tool) {
            workspace.session.tool = workspace.session.tool == tool ? Tool::None : tool;
        },
        why_no_load);
    menu.step(
        {"edit.no_tool", translatable("Put the load away"), {{Key::Escape, {}}}},
        [](Workspace& workspace) { workspace.session.tool = Tool::None; }, why_no_tool);
    menu.step({"edit.in_frame", translatable("Edit in the frame app")}, edit_in_frame);
}

Reason why_no_turn(const Workspace& workspace) { return workspace.session.why_no_turn(); }
Reason why_no_step(const Workspace& workspace) { return workspace.session.why_no_step(); }

Reason why_no_start(const Workspace& workspace)
{
    if (const auto reason = why_no_turn(workspace)) return reason;
    if (workspace.session.turn_tree() != nullptr && workspace.session.turn_tree()->length() > 0) return std::nullopt;
    return Message(translatable("every joint is locked: this is the start"));
}

Reason why_no_branch(const Workspace& workspace)
{
    if (workspace.session.turn_tree() != nullptr && workspace.session.turn_tree()->branches().size() > 1)
        return std::nullopt;
    return Message(translatable("there is one way only; go back and click another joint"));
}

void next_branch(Workspace& workspace)
{
    const auto ends = workspace.session.turn_tree()->branches();
    std::size_t next = 0;
    for (std::size_t i = 0; i < ends.size(); ++i)
        if (ends[i] == workspace.session.turn_tree()->place()) next = (i + 1) % ends.size();
    workspace.session.go_to_branch(ends[next]);
}

Reason why_one_stage(const Workspace& workspace)
{
    if (workspace.session.n_stages() > 1) return std::nullopt;
    return Message(translatable("the structure cannot sway: it has one sheet"));
}

void next_sheet(Workspace& workspace)
{
    Session& session = workspace.session;
    const std::size_t stage = session.worksheet() != nullptr ? session.worksheet_stage() : session.document().stage;
    session.set_stage((stage + 1) % session.n_stages());
}

/// Does it, and reports where that was refused.
std::function<void(Workspace&)> reporting(Reason (*run)(Session&))
{
    return [run](Workspace& workspace) {
        if (const auto reason = run(workspace.session)) workspace.session.notify(*reason);
    };
}

void add_work_commands(CommandTable& table)
{
    Menu menu(table, work_menu);
    menu.step(
        {"work.restart", translatable("Lock every joint again"), {{Key::Home, {}}}},
        [](Workspace& workspace) { workspace.session.restart(); }, why_no_start);
    menu.step({"work.back", translatable("Step back"), {{Key::Left, {}}}},
              reporting([](Session& s) { return s.back(); }), why_no_start);
    menu.step({"work.step", translatable("Balance the next joint"), {{Key::Right, {}}}},
              reporting([](Session& s) { return s.step(); }), why_no_step);
    menu.step({"work.finish", translatable("Go through to the end"), {{Key::End, {}}}},
              reporting([](Session& s) { return s.finish(); }), why_no_step);
    menu.step({"work.all_at_once", translatable("Balance all joints at once"), {{Key::A, {}}}},
              reporting([](Session& s) { return s.balance(std::nullopt); }), why_no_turn);
    menu.step({"work.branch", translatable("To the next branch"), {{Key::B, {}}}}, next_branch, why_no_branch);
    menu.toggle(
        {"work.play", translatable("Play"), {{Key::Space, {}}}},
        [](auto& workspace) -> auto& { return workspace.session.is_playing; },
        [](const Workspace& workspace) {
            return workspace.session.is_playing ? std::nullopt : workspace.session.why_no_step();
        });
    menu.step({"work.next_sheet", translatable("To the next sheet"), {{Key::S, {}}}}, next_sheet, why_one_stage);
}

constexpr std::array orders{
    ui::Choice<fc::Order>{fc::Order::Largest, "method.largest", translatable("Largest unbalance first")},
    ui::Choice<fc::Order>{fc::Order::LeftToRight, "method.left_to_right", translatable("From left to right")},
    ui::Choice<fc::Order>{fc::Order::AllAtOnce, "method.all_at_once", translatable("All joints at once")},
};

const Method& method_of(const Workspace& workspace) { return workspace.session.document().method; }

void change_method(Workspace& workspace, const std::function<void(Method&)>& change,
                   std::string_view label = translatable("Change the method"))
{
    Method method = method_of(workspace);
    change(method);
    workspace.session.set_method(method, label);
}

Reason why_no_joint(const Workspace& workspace)
{
    const auto& task = workspace.session.solution().task;
    if (task && !task->problem.balanced_joints().empty()) return std::nullopt;
    return translatable("there is no joint to balance");
}

/// A structure that lost its symmetry can still be worked as a whole.
Reason why_not_by_halves(const Workspace& workspace)
{
    const Session& session = workspace.session;
    if (session.worksheet() != nullptr)
        return Message(translatable("an exercise is of the whole structure; end it first"));
    const auto& task = session.solution().task;
    if (!task) return Message(translatable("this structure cannot be distributed"));
    if (task->by_halves || method_of(workspace).extent == fc::Extent::Half) return std::nullopt;
    return Message("{reason}", {{"reason", fault_text(*task->why_not_by_halves, session.tr())}});
}

Reason why_one_case(const Workspace& workspace)
{
    if (workspace.session.document().model.n_cases() > 1) return std::nullopt;
    return translatable("the file has one load case");
}

void next_case(Workspace& workspace)
{
    const std::size_t n = workspace.session.document().model.n_cases();
    change_method(workspace,
                  [n](Method& method) { method.load_case = femoop::CaseId((method.load_case.index + 1) % n); });
}

/// Far ends that are pinned: `on` where the toggle is on, else `off`.
auto turn_far_ends(fc::FarEnds on, fc::FarEnds off)
{
    return [on, off](Workspace& workspace, bool is_on) {
        change_method(workspace, [=](Method& method) { method.far_ends = is_on ? on : off; });
    };
}

void add_method_commands(CommandTable& table)
{
    Menu menu(table, method_menu);
    menu.choices(
        orders, [](const Workspace& workspace) { return method_of(workspace).order; },
        [](Workspace& workspace, fc::Order order) {
            change_method(workspace, [=](Method& method) { method.order = order; });
        });
    menu.step(
            {"method.listed", translatable("An order of one's own")},
            [](Workspace& workspace) { choose_own_order(workspace.session); }, why_no_joint)
        .is_on = [](const Workspace& workspace) { return method_of(workspace).order == fc::Order::Listed; };
    menu.toggle(
        {"method.modified", translatable("3EI/L for pinned ends"), {{Key::M, {}}}},
        [](const Workspace& workspace) { return method_of(workspace).far_ends != fc::FarEnds::Plain; },
        turn_far_ends(fc::FarEnds::Modified, fc::FarEnds::Plain));
    menu.toggle(
        {"method.released_once", translatable("3EI/L, pinned ends released once on the sheet")},
        [](const Workspace& workspace) { return method_of(workspace).far_ends == fc::FarEnds::ReleasedOnSheet; },
        turn_far_ends(fc::FarEnds::ReleasedOnSheet, fc::FarEnds::Modified));
    menu.toggle(
        {"method.symmetry", translatable("Half of it, by symmetry"), {{Key::H, {}}}},
        [](const Workspace& workspace) { return method_of(workspace).extent == fc::Extent::Half; },
        [](Workspace& workspace, bool is_half) {
            change_method(workspace,
                          [=](Method& method) { method.extent = is_half ? fc::Extent::Half : fc::Extent::Whole; });
        },
        why_not_by_halves);
    menu.step({"method.next_case", translatable("To the next load case"), {{Key::C, {}}}}, next_case, why_one_case);
}

void add_show_commands(CommandTable& table)
{
    Menu menu(table, show_menu);
    menu.choices(
        topic_entries, [](auto& workspace) -> auto& { return workspace.topic; });
    menu.toggle(
        {"show.tension_side", translatable("Signs by the tension side"), {{Key::T, {}}}},
        [](const Workspace& workspace) { return workspace.session.look.signs == Signs::TensionSide; },
        [](Workspace& workspace, bool is_on) {
            workspace.session.look.signs = is_on ? Signs::TensionSide : Signs::JointRotation;
        });
    menu.toggle(
        {"show.fractions", translatable("Numbers as fractions"), {{Key::F, {}}}},
        [](auto& workspace) -> auto& { return workspace.session.look.fractions; });
    menu.toggle(
        {"show.shears", translatable("Shears and reactions"), {{Key::V, {}}}},
        [](auto& workspace) -> auto& { return workspace.session.look.shears; });
}

// ---- what a scenario gives ----

Reason balance(Workspace& workspace, const ui::Argument& name)
{
    const auto joint = joint_named(workspace.session, name.text);
    return joint ? workspace.session.balance(*joint) : name.wanted("a joint that can be balanced");
}

Reason set_case(Workspace& workspace, const ui::Argument& name)
{
    const auto found = workspace.session.document().model.find_case(name.text);
    if (!found) return name.wanted("a load case or combination");
    change_method(
        workspace, [&](Method& method) { method.load_case = *found; }, translatable("Choose a load case"));
    return std::nullopt;
}

/// A command with a number that is not negative.
CommandTable::RunWith with_number(void (*run)(Workspace&, double))
{
    return [run](Workspace& workspace, const ui::Argument& argument) -> Reason {
        const auto number = argument.number();
        if (!number || *number < 0.0) return argument.wanted("a number");
        run(workspace, *number);
        return std::nullopt;
    };
}

void add_arguments(CommandTable& table)
{
    table.with_argument("work.balance", balance);
    table.with_argument("work.jump", with_number([](Workspace& workspace, double n) {
                            workspace.session.jump(static_cast<std::size_t>(n));
                        }));
    table.with_argument("work.sheet", with_number([](Workspace& workspace, double n) {
                            workspace.session.set_stage(static_cast<std::size_t>(n));
                        }));
    table.with_argument("method.order", [](Workspace& workspace, const ui::Argument& argument) {
        return take_own_order(workspace.session, argument.text);
    });
    table.with_argument("method.case", set_case);
    table.with_argument("method.digits", with_number([](Workspace& workspace, double n) {
                            change_method(workspace,
                                          [n](Method& method) { method.digits = std::min(16, static_cast<int>(n)); });
                        }));
    table.with_argument("method.tolerance", with_number([](Workspace& workspace, double n) {
                            change_method(workspace, [n](Method& method) { method.tolerance = n; });
                        }));
}

void add_view_commands(CommandTable& table)
{
    ui::standard::add_panels(table);
    ui::standard::add_zoom(table, translatable("Show the whole structure"), {{Key::Digit0, {}}});
    ui::standard::add_projector(table);
    ui::standard::add_offer(table);
    ui::standard::add_themes(table);
    ui::standard::add_export_scales(table);
    ui::standard::add_languages(table);
}

} // namespace

std::span<const TopicEntry> topics() { return topic_entries; }

std::optional<fc::JointId> joint_named(const Session& session, std::string_view name)
{
    const auto node = session.document().model.find_node(name);
    const auto& task = session.solution().task;
    return node && task ? task->problem.joint_at(*node) : std::nullopt;
}

CommandTable command_table()
{
    CommandTable table;
    ui::standard::add_file_commands(table, {.exported = translatable("Export picture, table or report…"),
                                            .described = translatable("Sheet in words")});
    ui::standard::add_undo_and_redo(table);
    add_structure_commands(table);
    add_load_commands(table);
    add_work_commands(table);
    add_method_commands(table);
    add_show_commands(table);
    add_exercise_commands(table);
    add_arguments(table);
    add_view_commands(table);
    ui::standard::add_help(table);
    return table;
}

} // namespace cross
