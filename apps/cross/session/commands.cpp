#include "apps/cross/session/commands.h"

#include <array>

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
using ui::translatable;

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

std::optional<Phrase> why_no_end(const Desk& desk, Side side)
{
    if (end_node(desk.session.document().model, side)) return std::nullopt;
    return Phrase(translatable("several members meet at this end"));
}

void add_structure_commands(CommandTable& table)
{
    struct EndEntry {
        Side side;
        std::string_view id, label;
    };
    for (const EndEntry& entry :
         {EndEntry{Side::Left, "edit.left_end", translatable("Left end: pinned, fixed, free")},
          EndEntry{Side::Right, "edit.right_end", translatable("Right end: pinned, fixed, free")}})
        table.add({.id = entry.id,
                   .menu = edit_menu,
                   .label = entry.label,
                   .run =
                       [side = entry.side](Desk& desk) {
                           const femoop::Model& model = desk.session.document().model;
                           desk.session.change(with_next_support(model, *end_node(model, side)),
                                               translatable("Change an end"));
                       },
                   .why_not = [side = entry.side](const Desk& desk) { return why_no_end(desk, side); }});
    table.add({.id = "edit.add_span",
               .menu = edit_menu,
               .label = translatable("Add a span"),
               .run =
                   [](Desk& desk) {
                       if (auto next = with_span_added(desk.session.document().model))
                           desk.session.change(std::move(*next), translatable("Add a span"));
                   },
               .why_not = [](const Desk& desk) { return why_no_end(desk, Side::Right); }});
    table.add({.id = "edit.remove_span",
               .menu = edit_menu,
               .label = translatable("Remove the last span"),
               .run =
                   [](Desk& desk) {
                       if (auto next = with_span_removed(desk.session.document().model))
                           desk.session.change(std::move(*next), translatable("Remove the last span"));
                   },
               .why_not = [](const Desk& desk) -> std::optional<Phrase> {
                   if (with_span_removed(desk.session.document().model)) return std::nullopt;
                   return Phrase(translatable("there is no span that could go"));
               }});
}

std::optional<Phrase> why_no_load(const Session& session)
{
    if (session.paper() != nullptr) return Phrase(translatable("an exercise is of one structure; end it first"));
    if (!session.solution().task) return Phrase(translatable("this structure cannot be distributed"));
    return std::nullopt;
}

void add_load_commands(CommandTable& table)
{
    struct LoadEntry {
        Tool tool;
        std::string_view id, label;
        ui::Chord chord;
    };
    for (const LoadEntry& entry :
         {LoadEntry{
              Tool::UniformLoad, "edit.uniform_load", translatable("Add a uniform load: click a member"), {Key::Q, {}}},
          LoadEntry{Tool::PointLoad,
                    "edit.point_load",
                    translatable("Add a force: click a member or a node"),
                    {Key::Q, {.shift = true}}}})
        table.add({.id = entry.id,
                   .menu = edit_menu,
                   .label = entry.label,
                   .shortcuts = {entry.chord},
                   .run = [tool = entry.tool](
                              Desk& desk) { desk.session.tool = desk.session.tool == tool ? Tool::None : tool; },
                   .why_not = [](const Desk& desk) { return why_no_load(desk.session); },
                   .is_on = [tool = entry.tool](const Desk& desk) { return desk.session.tool == tool; }});
    table.add({.id = "edit.no_tool",
               .menu = edit_menu,
               .label = translatable("Put the load away"),
               .shortcuts = {{Key::Escape, {}}},
               .run = [](Desk& desk) { desk.session.tool = Tool::None; },
               .why_not = [](const Desk& desk) -> std::optional<Phrase> {
                   if (desk.session.tool != Tool::None) return std::nullopt;
                   return Phrase(translatable("no load is in hand"));
               }});
    table.add({.id = "edit.in_frame",
               .menu = edit_menu,
               .label = translatable("Edit in the frame app"),
               .run = [](Desk& desk) {
                   desk.handed.push_back({.program = "frame", .document = write_document(desk.session.document())});
                   desk.tell(translatable("the structure is edited in a window of its own, as a copy"));
               }});
}

/// Something that a session does, or says why it cannot.
struct WorkEntry {
    std::string_view id, label;
    Key key;
    std::optional<Phrase> (*run)(Session&);
    std::optional<Phrase> (*why_not)(const Session&);
};

std::optional<Phrase> why_no_start(const Session& session)
{
    if (const auto reason = session.why_no_turn()) return reason;
    if (session.play() != nullptr && session.play()->length() > 0) return std::nullopt;
    return Phrase(translatable("every joint is locked: this is the start"));
}

std::optional<Phrase> why_no_branch(const Session& session)
{
    if (session.play() != nullptr && session.play()->branches().size() > 1) return std::nullopt;
    return Phrase(translatable("there is one way only; go back and click another joint"));
}

std::optional<Phrase> next_branch(Session& session)
{
    const auto ends = session.play()->branches();
    std::size_t next = 0;
    for (std::size_t i = 0; i < ends.size(); ++i)
        if (ends[i] == session.play()->place()) next = (i + 1) % ends.size();
    session.go_to_branch(ends[next]);
    return std::nullopt;
}

constexpr std::array work_entries{
    WorkEntry{"work.restart", translatable("Lock every joint again"), Key::Home,
              [](Session& s) -> std::optional<Phrase> {
                  s.restart();
                  return std::nullopt;
              },
              why_no_start},
    WorkEntry{"work.back", translatable("Step back"), Key::Left, [](Session& s) { return s.back(); }, why_no_start},
    WorkEntry{"work.step", translatable("Balance the next joint"), Key::Right, [](Session& s) { return s.step(); },
              [](const Session& s) { return s.why_no_step(); }},
    WorkEntry{"work.finish", translatable("Go through to the end"), Key::End, [](Session& s) { return s.finish(); },
              [](const Session& s) { return s.why_no_step(); }},
    WorkEntry{"work.all_at_once", translatable("Balance all joints at once"), Key::A,
              [](Session& s) { return s.balance(std::nullopt); }, [](const Session& s) { return s.why_no_turn(); }},
    WorkEntry{"work.branch", translatable("To the next branch"), Key::B, next_branch, why_no_branch},
};

std::optional<Phrase> why_one_stage(const Session& session)
{
    if (session.n_stages() > 1) return std::nullopt;
    return Phrase(translatable("the structure cannot sway: it has one sheet"));
}

void add_work_commands(CommandTable& table)
{
    for (const WorkEntry& entry : work_entries)
        table.add({.id = entry.id,
                   .menu = work_menu,
                   .label = entry.label,
                   .shortcuts = {{entry.key, {}}},
                   .run =
                       [run = entry.run](Desk& desk) {
                           if (const auto reason = run(desk.session)) desk.session.tell(*reason);
                       },
                   .why_not = [why = entry.why_not](const Desk& desk) { return why(desk.session); }});
    table.add({.id = "work.play",
               .menu = work_menu,
               .label = translatable("Play"),
               .shortcuts = {{Key::Space, {}}},
               .run = [](Desk& desk) { desk.session.is_playing = !desk.session.is_playing; },
               .why_not = [](const Desk& desk) -> std::optional<Phrase> {
                   return desk.session.is_playing ? std::nullopt : desk.session.why_no_step();
               },
               .is_on = [](const Desk& desk) { return desk.session.is_playing; }});
    table.add({.id = "work.next_sheet",
               .menu = work_menu,
               .label = translatable("To the next sheet"),
               .shortcuts = {{Key::S, {}}},
               .run =
                   [](Desk& desk) {
                       Session& session = desk.session;
                       const std::size_t stage = session.paper() != nullptr ? session.paper_stage()
                                                                            : session.document().stage;
                       session.set_stage((stage + 1) % session.n_stages());
                   },
               .why_not = [](const Desk& desk) { return why_one_stage(desk.session); }});
}

struct OrderEntry {
    fc::Order order;
    std::string_view id, label;
};
constexpr std::array orders{
    OrderEntry{fc::Order::Largest, "method.largest", translatable("Largest unbalance first")},
    OrderEntry{fc::Order::LeftToRight, "method.left_to_right", translatable("From left to right")},
    OrderEntry{fc::Order::AllAtOnce, "method.all_at_once", translatable("All joints at once")},
};

void change_method(Desk& desk, const std::function<void(Method&)>& change)
{
    Method method = desk.session.document().method;
    change(method);
    desk.session.set_method(method, translatable("Change the method"));
}

/// A structure that lost its symmetry can still be worked as a whole.
std::optional<Phrase> why_not_by_halves(const Session& session)
{
    if (session.paper() != nullptr) return Phrase(translatable("an exercise is of the whole structure; end it first"));
    const auto& task = session.solution().task;
    if (!task) return Phrase(translatable("this structure cannot be distributed"));
    if (task->by_halves || session.document().method.extent == fc::Extent::Half) return std::nullopt;
    return Phrase("{reason}", {{"reason", fault_text(*task->why_not_by_halves, session.tr())}});
}

void add_method_commands(CommandTable& table)
{
    for (const OrderEntry& entry : orders)
        table.add({.id = entry.id,
                   .menu = method_menu,
                   .label = entry.label,
                   .run = [order = entry.order](
                              Desk& desk) { change_method(desk, [&](Method& method) { method.order = order; }); },
                   .is_on = [order = entry.order](
                                const Desk& desk) { return desk.session.document().method.order == order; }});
    table.add({.id = "method.listed",
               .menu = method_menu,
               .label = translatable("An order of one's own"),
               .run = [](Desk& desk) { choose_own_order(desk.session); },
               .why_not = [](const Desk& desk) -> std::optional<Phrase> {
                   const auto& task = desk.session.solution().task;
                   if (task && !task->problem.balanced_joints().empty()) return std::nullopt;
                   return Phrase(translatable("there is no joint to balance"));
               },
               .is_on = [](const Desk& desk) { return desk.session.document().method.order == fc::Order::Listed; }});
    table.add(
        {.id = "method.modified",
         .menu = method_menu,
         .label = translatable("3EI/L for pinned ends"),
         .shortcuts = {{Key::M, {}}},
         .run =
             [](Desk& desk) {
                 change_method(desk, [](Method& method) {
                     method.far_ends = method.far_ends == fc::FarEnds::Plain ? fc::FarEnds::Modified
                                                                             : fc::FarEnds::Plain;
                 });
             },
         .is_on = [](const Desk& desk) { return desk.session.document().method.far_ends != fc::FarEnds::Plain; }});
    table.add(
        {.id = "method.released_once",
         .menu = method_menu,
         .label = translatable("3EI/L, pinned ends released once on the sheet"),
         .run =
             [](Desk& desk) {
                 change_method(desk, [](Method& method) {
                     method.far_ends = method.far_ends == fc::FarEnds::ReleasedOnSheet ? fc::FarEnds::Modified
                                                                                       : fc::FarEnds::ReleasedOnSheet;
                 });
             },
         .is_on =
             [](const Desk& desk) { return desk.session.document().method.far_ends == fc::FarEnds::ReleasedOnSheet; }});
    table.add({.id = "method.symmetry",
               .menu = method_menu,
               .label = translatable("Half of it, by symmetry"),
               .shortcuts = {{Key::H, {}}},
               .run =
                   [](Desk& desk) {
                       change_method(desk, [](Method& method) {
                           method.extent = method.extent == fc::Extent::Half ? fc::Extent::Whole : fc::Extent::Half;
                       });
                   },
               .why_not = [](const Desk& desk) { return why_not_by_halves(desk.session); },
               .is_on = [](const Desk& desk) { return desk.session.document().method.extent == fc::Extent::Half; }});
    table.add({.id = "method.next_case",
               .menu = method_menu,
               .label = translatable("To the next load case"),
               .shortcuts = {{Key::C, {}}},
               .run =
                   [](Desk& desk) {
                       const std::size_t n = desk.session.document().model.n_cases();
                       change_method(desk, [&](Method& method) {
                           method.load_case = femoop::CaseId((method.load_case.index + 1) % n);
                       });
                   },
               .why_not = [](const Desk& desk) -> std::optional<Phrase> {
                   if (desk.session.document().model.n_cases() > 1) return std::nullopt;
                   return translatable("the file has one load case");
               }});
}

void add_show_commands(CommandTable& table)
{
    for (const TopicEntry& entry : topic_entries)
        table.add({.id = entry.id,
                   .menu = show_menu,
                   .label = entry.label,
                   .run = [topic = entry.topic](Desk& desk) { desk.topic = topic; },
                   .is_on = [topic = entry.topic](const Desk& desk) { return desk.topic == topic; }});
    table.add({.id = "show.tension_side",
               .menu = show_menu,
               .label = translatable("Signs by the tension side"),
               .shortcuts = {{Key::T, {}}},
               .run =
                   [](Desk& desk) {
                       Signs& signs = desk.session.look.signs;
                       signs = signs == Signs::TensionSide ? Signs::JointRotation : Signs::TensionSide;
                   },
               .is_on = [](const Desk& desk) { return desk.session.look.signs == Signs::TensionSide; }});
    table.add({.id = "show.fractions",
               .menu = show_menu,
               .label = translatable("Numbers as fractions"),
               .shortcuts = {{Key::F, {}}},
               .run = [](Desk& desk) { desk.session.look.fractions = !desk.session.look.fractions; },
               .is_on = [](const Desk& desk) { return desk.session.look.fractions; }});
    table.add({.id = "show.shears",
               .menu = show_menu,
               .label = translatable("Shears and reactions"),
               .shortcuts = {{Key::V, {}}},
               .run = [](Desk& desk) { desk.session.look.shears = !desk.session.look.shears; },
               .is_on = [](const Desk& desk) { return desk.session.look.shears; }});
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
    add_view_commands(table);
    ui::standard::add_help(table);
    return table;
}

} // namespace cross
