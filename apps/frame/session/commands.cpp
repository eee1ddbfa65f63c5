#include "apps/frame/session/commands.h"

#include "apps/frame/session/case_commands.h"
#include "apps/frame/session/derivation_commands.h"
#include "apps/frame/session/edit_commands.h"
#include "apps/frame/session/free_body_commands.h"
#include "apps/frame/session/funicular_commands.h"
#include "apps/frame/session/influence_commands.h"
#include "apps/frame/session/kind_commands.h"
#include "apps/frame/session/load_commands.h"
#include "apps/frame/session/new_commands.h"
#include "apps/frame/session/other_programs.h"
#include "apps/frame/session/plane_commands.h"
#include "apps/frame/session/predict_commands.h"
#include "apps/frame/session/property_commands.h"
#include "apps/frame/session/set_commands.h"
#include "apps/frame/session/shown_method.h"
#include "apps/frame/session/solver_commands.h"
#include "apps/frame/session/table_commands.h"
#include "apps/frame/session/tabs.h"
#include "apps/frame/session/train_commands.h"
#include "apps/frame/session/truss_commands.h"
#include "apps/frame/session/view_commands.h"
#include "apps/frame/session/virtual_work_commands.h"
#include "femoop/analysis/linear_static.h"
#include "femoop/io/results/difference_text.h"
#include "ui/workspace/standard_commands.h"
#include "ui/workspace/unit_commands.h"

#include <array>
#include <utility>

namespace frame {

using ui::Key;
using ui::Reason;
using ui::shift;
using ui::translatable;

namespace {

using ui::standard::file_menu;
using ui::standard::view_menu;

Reason why_no_other_tab(const Workspace& workspace)
{
    if (n_tabs(workspace) > 1) return std::nullopt;
    return translatable("no other document is open");
}

void add_file_commands(CommandTable& table)
{
    Menu menu(table, file_menu);
    add_new_commands(table);
    ui::standard::add_open<Workspace>(table, ui::asks(ui::Request::OpenDialog));
    ui::standard::add_save(table);
    ui::standard::add_export(table, translatable("Export picture, results or report…"));
    menu.toggle(
        {"file.report_matrices", translatable("Matrices in the report")},
        [](auto& workspace) -> auto& { return workspace.session.reports_matrices; });
    ui::standard::add_copy_and_describe(table, translatable("Model and results in words"));
    menu.step({"file.close", translatable("Close"), {{Key::W, ui::ctrl}}}, leave_tab);
    menu.step(
        {"file.next_tab", translatable("Next tab"), {{Key::Tab, ui::ctrl}}},
        [](Workspace& workspace) { show_tab(workspace, (workspace.tab + 1) % n_tabs(workspace)); }, why_no_other_tab);
    menu.step(
        {"file.previous_tab", translatable("Previous tab"), {{Key::Tab, ui::ctrl_shift}}},
        [](Workspace& workspace) { show_tab(workspace, (workspace.tab + n_tabs(workspace) - 1) % n_tabs(workspace)); },
        why_no_other_tab);
    ui::standard::add_quit(table);
}

using Shown = ui::Choice<Show>;
constexpr std::array toggles{
    Shown{Show::Loads, "view.show.loads", translatable("Loads"), {{Key::L, shift}}},
    Shown{Show::Reactions, "view.show.reactions", translatable("Reactions"), {{Key::R, shift}}},
    Shown{Show::N, "view.show.N", translatable("Normal force N"), {{Key::N, shift}}},
    Shown{Show::V, "view.show.V", translatable("Shear force V"), {{Key::V, shift}}},
    Shown{Show::M, "view.show.M", translatable("Bending moment M"), {{Key::M, shift}}},
    Shown{Show::T, "view.show.T", translatable("Torsion T"), {{Key::T, shift}}},
    Shown{Show::Deformed, "view.show.deformed", translatable("Deformed shape"), {{Key::D, shift}}},
    Shown{Show::Thrust, "view.show.thrust", translatable("Line of thrust")},
    Shown{Show::Values, "view.show.values", translatable("Values")},
    Shown{Show::StepValues, "view.show.step_values", translatable("Values at equal steps")},
    Shown{Show::NodeNames, "view.show.node_names", translatable("Names of nodes")},
    Shown{Show::MemberNames, "view.show.member_names", translatable("Names of members")},
    Shown{Show::Dimensions, "view.show.dimensions", translatable("Dimensions")},
    Shown{Show::DrawnDimensions, "view.show.drawn_dimensions", translatable("Drawn dimensions")},
    Shown{Show::LocalAxes, "view.show.local_axes", translatable("Local axes")},
    Shown{Show::Counting, "view.show.counting", translatable("Degree of indeterminacy"), {{Key::G, shift}}},
    Shown{Show::Legend, "view.show.legend", translatable("Legend")},
};

void add_show_commands(CommandTable& table)
{
    Menu(table, translatable("Show"))
        .toggles(
            toggles,
            [](const Workspace& workspace, Show item) {
                const Session& session = workspace.session;
                return session.view.show.contains(item) || (session.hidden && session.hidden->contains(item));
            },
            [](Workspace& workspace, Show item, bool is_on) {
                Session& session = workspace.session;
                ShowSet& show = session.hidden && is_hideable(item) ? *session.hidden : session.view.show;
                is_on ? show.insert(item) : show.erase(item);
                if (item == Show::Counting && is_on) close_other_methods(workspace, ShownMethod::Counting);
                if (item == Show::Deformed) session.shows_deformed_to_animate = false; // it is asked for by itself
            });
}

// Keeps the present solution to compare later ones with it; drops the one that is kept.
void keep_reference(Workspace& workspace, bool is_kept)
{
    Session& session = workspace.session;
    session.reference.reset();
    if (is_kept)
        session.reference = std::make_shared<const ReferenceResults>(
            ReferenceResults{.model = session.model(), .results = *session.solution().results});
}

// Keeps the case that is shown to compare the others with it.
void keep_case(Workspace& workspace, bool is_kept)
{
    keep_reference(workspace, false);
    if (!is_kept) return;
    Session& session = workspace.session;
    session.reference = std::make_shared<const ReferenceResults>(
        ReferenceResults{.model = session.model(),
                         .results = *session.solution().results,
                         .load_case = session.view.load_case,
                         .name = session.model().case_name(session.view.load_case)});
}

std::optional<std::size_t> neighbour_tab(const Workspace& workspace)
{
    if (n_tabs(workspace) < 2) return std::nullopt;
    return workspace.tab > 0 ? workspace.tab - 1 : workspace.tab + 1;
}

Reason why_not_compare_tab(const Workspace& workspace)
{
    const auto place = neighbour_tab(workspace);
    if (!place) return translatable("no other document is open; open it in a tab first");
    if (!tab(workspace, *place).solution().results) return translatable("the document in the other tab has no results");
    if (tab(workspace, *place).model().analysis != workspace.session.model().analysis)
        return translatable("the document in the other tab is of another kind of structure");
    return std::nullopt;
}

// Numbers of another document are counted in the units of the present one.
ReferenceResults converted_results(const Session& other, const femoop::Units& units)
{
    if (other.model().units == units) return {.model = other.model(), .results = *other.solution().results};
    femoop::Model model = femoop::comparable(other.model(), units);
    femoop::Results results = femoop::analyse(model);
    return {.model = std::move(model), .results = std::move(results)};
}

void compare_tab(Workspace& workspace)
{
    const std::size_t place = *neighbour_tab(workspace);
    const Session& other = tab(workspace, place);
    try {
        ReferenceResults reference = converted_results(other, workspace.session.model().units);
        reference.name = tab_name(workspace, place);
        workspace.session.reference = std::make_shared<const ReferenceResults>(std::move(reference));
        workspace.topic = Topic::Results;
    } catch (const femoop::ModelError& error) { // numbers that the units of this document cannot hold
        workspace.session.notice = refusal_of(error.faults());
    }
}

Reason why_not_compare(const Workspace& workspace)
{
    if (workspace.session.reference) return std::nullopt;
    if (!workspace.session.solution().results) return translatable("the model has no results");
    if (workspace.session.model().n_cases() > 0) return std::nullopt;
    return translatable("the model has no load case; add one first");
}

Reason why_no_envelope(const Workspace& workspace)
{
    const bool is_shown = workspace.session.view.is_envelope && !workspace.session.shows_train_envelope();
    if (is_shown) return std::nullopt;
    if (shown_work(workspace.session) != nullptr)
        return translatable("virtual work is of one load case; close it with Esc first");
    if (workspace.session.model().n_cases() > 1) return std::nullopt;
    return translatable("the model has no other load case");
}

void animate(Workspace& workspace, bool is_on)
{
    Session& session = workspace.session;
    session.is_animated = is_on;
    if (is_on) session.shows_deformed_to_animate = !session.view.show.contains(Show::Deformed);
    if (is_on) session.view.show.insert(Show::Deformed);
    else if (std::exchange(session.shows_deformed_to_animate, false)) session.view.show.erase(Show::Deformed);
}

Reason why_not_animate(const Workspace& workspace)
{
    const Session& session = workspace.session;
    const bool waits = session.is_still && !session.shown_mechanisms().empty();
    return session.is_animated || waits ? std::nullopt : session.why_no_results();
}

void add_camera_commands(CommandTable& table)
{
    Menu menu(table, view_menu);
    ui::standard::add_zoom(table, translatable("Show the whole model"), {{Key::F, {}}, {Key::Home, {}}});
    menu.toggle(
        {"view.animate", translatable("Animate"), {{Key::A, {}}}},
        [](const Workspace& workspace) { return workspace.session.is_animated; }, animate, why_not_animate);
    menu.toggle(
        {"view.envelope", translatable("Envelope"), {{Key::E, {}}}},
        [](const Workspace& workspace) {
            return workspace.session.view.is_envelope && !workspace.session.shows_train_envelope();
        },
        [](Workspace& workspace, bool is_on) {
            workspace.session.train_envelope.turn(false);
            workspace.session.view.is_envelope = is_on;
        },
        why_no_envelope);
    menu.toggle(
        {"view.compare", translatable("Compare with the present results"), {{Key::G, {}}}},
        [](const Workspace& workspace) { return workspace.session.reference != nullptr; }, keep_reference,
        why_not_compare);
    menu.toggle(
        {"view.compare_case", translatable("Compare other cases with this one")},
        [](const Workspace& workspace) {
            return workspace.session.reference != nullptr && workspace.session.reference->load_case.has_value();
        },
        keep_case, why_not_compare);
    menu.step({"view.compare_tab", translatable("Compare with the document in the tab beside")}, compare_tab,
              why_not_compare_tab);
    ui::standard::add_projector(table);
    ui::standard::add_offer(table);
    menu.toggle(
        {"view.moment_side", translatable("Moments on the tension side")},
        [](const Workspace& workspace) { return workspace.session.view.moment_side == MomentSide::Tension; },
        [](Workspace& workspace, bool is_on) {
            workspace.session.view.moment_side = is_on ? MomentSide::Tension : MomentSide::Compression;
        });
}

constexpr std::array topic_entries{
    TopicEntry{Topic::Properties, "view.panel.properties", translatable("Properties")},
    TopicEntry{Topic::Results, "view.panel.results", translatable("Results")},
    TopicEntry{Topic::Problems, "view.panel.problems", translatable("Problems")},
    TopicEntry{Topic::History, "view.panel.history", translatable("History")},
};

void add_panel_commands(CommandTable& table)
{
    ui::standard::add_panels(table);
    ui::standard::add_topics(table, topic_entries);
}

void add_look_commands(CommandTable& table)
{
    ui::standard::add_themes(table);
    ui::standard::add_units(
        table, [](auto& workspace) -> auto& { return workspace.session.view; },
        [](Workspace& workspace) { workspace.requests.push_back(Request::UnitWindow); });
    ui::standard::add_export_scales(table);
    ui::standard::add_languages(table);
}

} // namespace

CommandTable command_table()
{
    CommandTable table;
    add_file_commands(table);
    add_edit_commands(table);
    add_kind_commands(table);
    add_property_commands(table);
    add_set_commands(table);
    add_tool_commands(table);
    add_plane_commands(table);
    add_case_commands(table);
    add_load_commands(table);
    add_show_commands(table);
    add_camera_commands(table);
    add_view_commands(table);
    add_method_tools(table);
    add_predict_commands(table);
    add_influence_commands(table);
    add_free_body_commands(table);
    add_funicular_commands(table);
    add_virtual_work_commands(table);
    add_train_commands(table);
    add_truss_commands(table);
    add_derivation_commands(table);
    add_method_commands(table);
    add_panel_commands(table);
    add_table_commands(table);
    add_solver_commands(table);
    add_look_commands(table);
    ui::standard::add_help(table);
    return table;
}

std::span<const TopicEntry> topics() { return topic_entries; }

std::string_view command_id(Show item)
{
    for (const Shown& toggle : toggles) {
        if (toggle.value == item) return toggle.id;
    }
    return "";
}

} // namespace frame
