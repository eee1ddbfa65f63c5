#include "apps/cross/session/commands.h"

#include <algorithm>
#include <array>
#include <functional>

#include "apps/cross/document/file.h"
#include "apps/cross/session/beam_edit.h"
#include "apps/cross/session/exercise_commands.h"
#include "apps/cross/session/own_order.h"
#include "apps/cross/view/numbers.h"
#include "ui/desk/file_commands.h"

namespace cross {

namespace fc = femoop::cross;
using ui::Key;
using ui::Phrase;
using ui::Reason;
using ui::translatable;
using Menu = ui::MenuBuilder<Desk>;

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

Reason why_no_end(const Desk& desk, Side side)
{
    if (end_node(desk.session.document().model, side)) return std::nullopt;
    return Phrase(translatable("several members meet at this end"));
}

void add_end(Menu& menu, ui::CommandName name, Side side)
{
    const auto run = [side](Desk& desk) {
        const femoop::Model& model = desk.session.document().model;
        desk.session.change(with_next_support(model, *end_node(model, side)), translatable("Change an end"));
    };
    menu.step(std::move(name), run, [side](const Desk& desk) { return why_no_end(desk, side); });
}

void add_span(Desk& desk)
{
    if (auto next = with_span_added(desk.session.document().model))
        desk.session.change(std::move(*next), translatable("Add a span"));
}

void remove_span(Desk& desk)
{
    if (auto next = with_span_removed(desk.session.document().model))
        desk.session.change(std::move(*next), translatable("Remove the last span"));
}

Reason why_not_remove_span(const Desk& desk)
{
    if (with_span_removed(desk.session.document().model)) return std::nullopt;
    return Phrase(translatable("there is no span that could go"));
}

void add_structure_commands(CommandTable& table)
{
    Menu menu(table, edit_menu);
    add_end(menu, {"edit.left_end", translatable("Left end: pinned, fixed, free")}, Side::Left);
    add_end(menu, {"edit.right_end", translatable("Right end: pinned, fixed, free")}, Side::Right);
    menu.step({"edit.add_span", translatable("Add a span")}, add_span,
              [](const Desk& desk) { return why_no_end(desk, Side::Right); });
    menu.step({"edit.remove_span", translatable("Remove the last span")}, remove_span, why_not_remove_span);
}

Reason why_no_load(const Desk& desk)
{
    if (desk.session.paper() != nullptr) return Phrase(translatable("an exercise is of one structure; end it first"));
    if (!desk.session.solution().task) return Phrase(translatable("this structure cannot be distributed"));
    return std::nullopt;
}

Reason why_no_tool(const Desk& desk)
{
    if (desk.session.tool != Tool::None) return std::nullopt;
    return Phrase(translatable("no load is in hand"));
}

void edit_in_frame(Desk& desk)
{
    desk.handed.push_back({.program = "frame", .document = write_document(desk.session.document())});
    desk.tell(translatable("the structure is edited in a window of its own, as a copy"));
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
        load_tools, [](const Desk& desk) { return desk.session.tool; },
        [](Desk& desk, Tool tool) { desk.session.tool = desk.session.tool == tool ? Tool::None : tool; }, why_no_load);
    menu.step(
        {"edit.no_tool", translatable("Put the load away"), {{Key::Escape, {}}}},
        [](Desk& desk) { desk.session.tool = Tool::None; }, why_no_tool);
    menu.step({"edit.in_frame", translatable("Edit in the frame app")}, edit_in_frame);
}

Reason why_no_turn(const Desk& desk) { return desk.session.why_no_turn(); }
Reason why_no_step(const Desk& desk) { return desk.session.why_no_step(); }

Reason why_no_start(const Desk& desk)
{
    if (const auto reason = why_no_turn(desk)) return reason;
    if (desk.session.play() != nullptr && desk.session.play()->length() > 0) return std::nullopt;
    return Phrase(translatable("every joint is locked: this is the start"));
}

Reason why_no_branch(const Desk& desk)
{
    if (desk.session.play() != nullptr && desk.session.play()->branches().size() > 1) return std::nullopt;
    return Phrase(translatable("there is one way only; go back and click another joint"));
}

void next_branch(Desk& desk)
{
    const auto ends = desk.session.play()->branches();
    std::size_t next = 0;
    for (std::size_t i = 0; i < ends.size(); ++i)
        if (ends[i] == desk.session.play()->place()) next = (i + 1) % ends.size();
    desk.session.go_to_branch(ends[next]);
}

Reason why_one_stage(const Desk& desk)
{
    if (desk.session.n_stages() > 1) return std::nullopt;
    return Phrase(translatable("the structure cannot sway: it has one sheet"));
}

void next_sheet(Desk& desk)
{
    Session& session = desk.session;
    const std::size_t stage = session.paper() != nullptr ? session.paper_stage() : session.document().stage;
    session.set_stage((stage + 1) % session.n_stages());
}

/// Does it, and reports where that was refused.
std::function<void(Desk&)> reporting(Reason (*run)(Session&))
{
    return [run](Desk& desk) {
        if (const auto reason = run(desk.session)) desk.session.tell(*reason);
    };
}

void add_work_commands(CommandTable& table)
{
    Menu menu(table, work_menu);
    menu.step(
        {"work.restart", translatable("Lock every joint again"), {{Key::Home, {}}}},
        [](Desk& desk) { desk.session.restart(); }, why_no_start);
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
        [](auto& desk) -> auto& { return desk.session.is_playing; },
        [](const Desk& desk) { return desk.session.is_playing ? std::nullopt : desk.session.why_no_step(); });
    menu.step({"work.next_sheet", translatable("To the next sheet"), {{Key::S, {}}}}, next_sheet, why_one_stage);
}

constexpr std::array orders{
    ui::Choice<fc::Order>{fc::Order::Largest, "method.largest", translatable("Largest unbalance first")},
    ui::Choice<fc::Order>{fc::Order::LeftToRight, "method.left_to_right", translatable("From left to right")},
    ui::Choice<fc::Order>{fc::Order::AllAtOnce, "method.all_at_once", translatable("All joints at once")},
};

const Method& method_of(const Desk& desk) { return desk.session.document().method; }

void change_method(Desk& desk, const std::function<void(Method&)>& change,
                   std::string_view label = translatable("Change the method"))
{
    Method method = method_of(desk);
    change(method);
    desk.session.set_method(method, label);
}

Reason why_no_joint(const Desk& desk)
{
    const auto& task = desk.session.solution().task;
    if (task && !task->problem.balanced_joints().empty()) return std::nullopt;
    return translatable("there is no joint to balance");
}

/// A structure that lost its symmetry can still be worked as a whole.
Reason why_not_by_halves(const Desk& desk)
{
    const Session& session = desk.session;
    if (session.paper() != nullptr) return Phrase(translatable("an exercise is of the whole structure; end it first"));
    const auto& task = session.solution().task;
    if (!task) return Phrase(translatable("this structure cannot be distributed"));
    if (task->by_halves || method_of(desk).extent == fc::Extent::Half) return std::nullopt;
    return Phrase("{reason}", {{"reason", fault_text(*task->why_not_by_halves, session.tr())}});
}

Reason why_one_case(const Desk& desk)
{
    if (desk.session.document().model.n_cases() > 1) return std::nullopt;
    return translatable("the file has one load case");
}

void next_case(Desk& desk)
{
    const std::size_t n = desk.session.document().model.n_cases();
    change_method(desk, [n](Method& method) { method.load_case = femoop::CaseId((method.load_case.index + 1) % n); });
}

/// Far ends that are pinned: `on` where the toggle is on, else `off`.
auto turn_far_ends(fc::FarEnds on, fc::FarEnds off)
{
    return [on, off](Desk& desk, bool is_on) {
        change_method(desk, [=](Method& method) { method.far_ends = is_on ? on : off; });
    };
}

void add_method_commands(CommandTable& table)
{
    Menu menu(table, method_menu);
    menu.choices(
        orders, [](const Desk& desk) { return method_of(desk).order; },
        [](Desk& desk, fc::Order order) { change_method(desk, [=](Method& method) { method.order = order; }); });
    menu.step(
            {"method.listed", translatable("An order of one's own")},
            [](Desk& desk) { choose_own_order(desk.session); }, why_no_joint)
        .is_on = [](const Desk& desk) { return method_of(desk).order == fc::Order::Listed; };
    menu.toggle(
        {"method.modified", translatable("3EI/L for pinned ends"), {{Key::M, {}}}},
        [](const Desk& desk) { return method_of(desk).far_ends != fc::FarEnds::Plain; },
        turn_far_ends(fc::FarEnds::Modified, fc::FarEnds::Plain));
    menu.toggle(
        {"method.released_once", translatable("3EI/L, pinned ends released once on the sheet")},
        [](const Desk& desk) { return method_of(desk).far_ends == fc::FarEnds::ReleasedOnSheet; },
        turn_far_ends(fc::FarEnds::ReleasedOnSheet, fc::FarEnds::Modified));
    menu.toggle(
        {"method.symmetry", translatable("Half of it, by symmetry"), {{Key::H, {}}}},
        [](const Desk& desk) { return method_of(desk).extent == fc::Extent::Half; },
        [](Desk& desk, bool is_half) {
            change_method(desk,
                          [=](Method& method) { method.extent = is_half ? fc::Extent::Half : fc::Extent::Whole; });
        },
        why_not_by_halves);
    menu.step({"method.next_case", translatable("To the next load case"), {{Key::C, {}}}}, next_case, why_one_case);
}

void add_show_commands(CommandTable& table)
{
    Menu menu(table, show_menu);
    menu.choices(
        topic_entries, [](auto& desk) -> auto& { return desk.topic; });
    menu.toggle(
        {"show.tension_side", translatable("Signs by the tension side"), {{Key::T, {}}}},
        [](const Desk& desk) { return desk.session.look.signs == Signs::TensionSide; },
        [](Desk& desk, bool is_on) { desk.session.look.signs = is_on ? Signs::TensionSide : Signs::JointRotation; });
    menu.toggle(
        {"show.fractions", translatable("Numbers as fractions"), {{Key::F, {}}}},
        [](auto& desk) -> auto& { return desk.session.look.fractions; });
    menu.toggle(
        {"show.shears", translatable("Shears and reactions"), {{Key::V, {}}}},
        [](auto& desk) -> auto& { return desk.session.look.shears; });
}

// ---- what a scenario gives ----

Reason balance(Desk& desk, const ui::Argument& name)
{
    const auto joint = joint_named(desk.session, name.text);
    return joint ? desk.session.balance(*joint) : name.wanted("a joint that can be balanced");
}

Reason set_case(Desk& desk, const ui::Argument& name)
{
    const auto found = desk.session.document().model.find_case(name.text);
    if (!found) return name.wanted("a load case or combination");
    change_method(
        desk, [&](Method& method) { method.load_case = *found; }, translatable("Choose a load case"));
    return std::nullopt;
}

/// A command with a number that is not negative.
CommandTable::RunWith with_number(void (*run)(Desk&, double))
{
    return [run](Desk& desk, const ui::Argument& argument) -> Reason {
        const auto number = argument.number();
        if (!number || *number < 0.0) return argument.wanted("a number");
        run(desk, *number);
        return std::nullopt;
    };
}

void add_arguments(CommandTable& table)
{
    table.with_argument("work.balance", balance);
    table.with_argument("work.jump",
                        with_number([](Desk& desk, double n) { desk.session.jump(static_cast<std::size_t>(n)); }));
    table.with_argument("work.sheet",
                        with_number([](Desk& desk, double n) { desk.session.set_stage(static_cast<std::size_t>(n)); }));
    table.with_argument("method.order", [](Desk& desk, const ui::Argument& argument) {
        return take_own_order(desk.session, argument.text);
    });
    table.with_argument("method.case", set_case);
    table.with_argument("method.digits", with_number([](Desk& desk, double n) {
                            change_method(desk,
                                          [n](Method& method) { method.digits = std::min(16, static_cast<int>(n)); });
                        }));
    table.with_argument("method.tolerance", with_number([](Desk& desk, double n) {
                            change_method(desk, [n](Method& method) { method.tolerance = n; });
                        }));
}

void add_view_commands(CommandTable& table)
{
    ui::standard::add_panels(table);
    ui::standard::add_zoom(table, translatable("Show the whole structure"), {{Key::Digit0, {}}});
    ui::standard::add_projector(table);
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
