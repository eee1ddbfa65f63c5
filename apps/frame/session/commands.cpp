#include "apps/frame/session/commands.h"

#include "apps/frame/session/case_commands.h"
#include "apps/frame/session/edit_commands.h"
#include "apps/frame/session/kind_commands.h"
#include "apps/frame/session/load_commands.h"
#include "apps/frame/session/new_commands.h"
#include "apps/frame/session/other_programs.h"
#include "apps/frame/session/plane_commands.h"
#include "apps/frame/session/predict_commands.h"
#include "apps/frame/session/property_commands.h"
#include "apps/frame/session/set_commands.h"
#include "apps/frame/session/solver_commands.h"
#include "apps/frame/session/table_commands.h"
#include "apps/frame/session/tabs.h"
#include "apps/frame/session/view_commands.h"
#include "ui/desk/standard_commands.h"

#include <array>
#include <utility>

namespace frame {

using ui::Chord;
using ui::Key;
using ui::Phrase;
using ui::translatable;
using Entry = ui::Command<Desk>;

namespace {

using Reason = std::optional<Phrase>;

constexpr std::string_view show_menu = translatable("Show");
using ui::standard::file_menu;
using ui::standard::view_menu;

// A command that asks this app's window for something.
std::function<void(Desk&)> asks(Request request)
{
    return [request](Desk& desk) { desk.requests.push_back(request); };
}

void add_document_commands(CommandTable& table)
{
    add_new_commands(table);
    ui::standard::add_open<Desk>(table, ui::asks(ui::Request::OpenDialog));
    ui::standard::add_recent(table);
    ui::standard::add_save(table);
}

void add_export_commands(CommandTable& table)
{
    ui::standard::add_export(table, translatable("Export picture, results or report…"));
    table.add({.id = "file.report_matrices",
               .menu = file_menu,
               .label = translatable("Matrices in the report"),
               .run = [](Desk& desk) { desk.session.reports_matrices = !desk.session.reports_matrices; },
               .is_on = [](const Desk& desk) { return desk.session.reports_matrices; }});
    ui::standard::add_copy_and_describe(table, translatable("Model and results in words"));
}

void add_tab_commands(CommandTable& table)
{
    table.add({.id = "file.close",
               .menu = file_menu,
               .label = translatable("Close"),
               .shortcuts = {{Key::W, ui::ctrl}},
               .run = asks(Request::CloseTab)});
    table.add({.id = "file.next_tab",
               .menu = file_menu,
               .label = translatable("Next tab"),
               .shortcuts = {{Key::Tab, ui::ctrl}},
               .run = [](Desk& desk) { show_tab(desk, (desk.tab + 1) % n_tabs(desk)); },
               .why_not = [](const Desk& desk) -> Reason {
                   if (n_tabs(desk) > 1) return std::nullopt;
                   return translatable("no other document is open");
               }});
    ui::standard::add_quit<Desk>(table, ui::asks(ui::Request::Quit));
}

struct Toggle {
    Show item;
    std::string_view id;
    std::string_view label;
    std::optional<Key> key;
};
constexpr std::array toggles{
    Toggle{Show::Loads, "view.show.loads", translatable("Loads"), Key::L},
    Toggle{Show::Reactions, "view.show.reactions", translatable("Reactions"), Key::R},
    Toggle{Show::N, "view.show.N", translatable("Normal force N"), Key::N},
    Toggle{Show::V, "view.show.V", translatable("Shear force V"), Key::V},
    Toggle{Show::M, "view.show.M", translatable("Bending moment M"), Key::M},
    Toggle{Show::T, "view.show.T", translatable("Torsion T"), Key::T},
    Toggle{Show::Deformed, "view.show.deformed", translatable("Deformed shape"), Key::D},
    Toggle{Show::Values, "view.show.values", translatable("Values"), std::nullopt},
    Toggle{Show::StepValues, "view.show.step_values", translatable("Values at equal steps"), std::nullopt},
    Toggle{Show::NodeNames, "view.show.node_names", translatable("Names of nodes"), std::nullopt},
    Toggle{Show::MemberNames, "view.show.member_names", translatable("Names of members"), std::nullopt},
    Toggle{Show::Dimensions, "view.show.dimensions", translatable("Dimensions"), std::nullopt},
    Toggle{Show::DrawnDimensions, "view.show.drawn_dimensions", translatable("Drawn dimensions"), std::nullopt},
    Toggle{Show::LocalAxes, "view.show.local_axes", translatable("Local axes"), std::nullopt},
    Toggle{Show::Legend, "view.show.legend", translatable("Legend"), std::nullopt},
};

void flip(ShowSet& set, Show item)
{
    if (set.contains(item)) set.erase(item);
    else set.insert(item);
}

void add_show_commands(CommandTable& table)
{
    for (const Toggle& toggle : toggles) {
        std::vector<Chord> keys;
        if (toggle.key) keys.push_back({*toggle.key, ui::shift});
        table.add({.id = toggle.id,
                   .menu = show_menu,
                   .label = toggle.label,
                   .shortcuts = std::move(keys),
                   .run = [item = toggle.item](Desk& desk) { flip(desk.session.view.show, item); },
                   .is_on = [item = toggle.item](const Desk& desk) { return desk.session.view.show.contains(item); }});
    }
}

// Keeps the present solution to compare later ones with it; drops the one that is kept.
void keep_or_drop_reference(Session& session)
{
    std::shared_ptr<const ReferenceResults>& kept = session.reference;
    if (kept) kept.reset();
    else
        kept = std::make_shared<const ReferenceResults>(ReferenceResults{session.model(), *session.solution().results});
}

Reason needs_cases(const Desk& desk)
{
    if (desk.session.model().n_cases() > 1) return std::nullopt;
    return translatable("the model has no other load case");
}

void add_camera_commands(CommandTable& table)
{
    ui::standard::add_zoom(table, translatable("Show the whole model"), {{Key::F, {}}, {Key::Home, {}}});
    table.add({.id = "view.animate",
               .menu = view_menu,
               .label = translatable("Animate"),
               .shortcuts = {{Key::A, {}}},
               .run =
                   [](Desk& desk) {
                       desk.session.is_animated = !desk.session.is_animated;
                       if (desk.session.is_animated) desk.session.view.show.insert(Show::Deformed);
                   },
               .why_not = [](const Desk& desk) -> Reason {
                   if (desk.session.is_animated) return std::nullopt;
                   return desk.session.why_no_results();
               },
               .is_on = [](const Desk& desk) { return desk.session.is_animated; }});
    table.add({.id = "view.envelope",
               .menu = view_menu,
               .label = translatable("Envelope"),
               .shortcuts = {{Key::E, {}}},
               .run = [](Desk& desk) { desk.session.view.is_envelope = !desk.session.view.is_envelope; },
               .why_not = [](const Desk& desk) -> Reason {
                   if (desk.session.view.is_envelope) return std::nullopt;
                   return needs_cases(desk);
               },
               .is_on = [](const Desk& desk) { return desk.session.view.is_envelope; }});
    table.add({.id = "view.compare",
               .menu = view_menu,
               .label = translatable("Compare with the present results"),
               .shortcuts = {{Key::G, {}}},
               .run = [](Desk& desk) { keep_or_drop_reference(desk.session); },
               .why_not = [](const Desk& desk) -> Reason {
                   if (desk.session.reference || desk.session.solution().results) return std::nullopt;
                   return translatable("the model has no results");
               },
               .is_on = [](const Desk& desk) { return desk.session.reference != nullptr; }});
    ui::standard::add_projector(table);
    table.add({.id = "view.moment_side",
               .menu = view_menu,
               .label = translatable("Moments on the tension side"),
               .run =
                   [](Desk& desk) {
                       MomentSide& side = desk.session.view.moment_side;
                       side = side == MomentSide::Tension ? MomentSide::Compression : MomentSide::Tension;
                   },
               .is_on = [](const Desk& desk) { return desk.session.view.moment_side == MomentSide::Tension; }});
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

struct UnitEntry {
    ui::UnitSystem system;
    std::string_view id, label;
};
constexpr std::array unit_entries{
    UnitEntry{ui::UnitSystem::File, "view.units.file", translatable("Units of the file")},
    UnitEntry{ui::UnitSystem::Si, "view.units.si", translatable("N, m, MPa")},
    UnitEntry{ui::UnitSystem::KnM, "view.units.kn-m", translatable("kN, m, MPa")},
    UnitEntry{ui::UnitSystem::KnCm, "view.units.kn-cm", translatable("kN, cm")},
    UnitEntry{ui::UnitSystem::Us, "view.units.us", translatable("kip, ft, ksi")},
};

struct DigitsEntry {
    int digits;
    std::string_view id, label;
};
constexpr std::array digits_entries{
    DigitsEntry{3, "view.digits.3", translatable("3 digits")},
    DigitsEntry{4, "view.digits.4", translatable("4 digits")},
    DigitsEntry{5, "view.digits.5", translatable("5 digits")},
    DigitsEntry{6, "view.digits.6", translatable("6 digits")},
    DigitsEntry{8, "view.digits.8", translatable("8 digits")},
};

void add_look_commands(CommandTable& table)
{
    ui::standard::add_themes(table);
    for (const UnitEntry& entry : unit_entries) {
        table.add(
            {.id = entry.id,
             .menu = translatable("Units"),
             .label = entry.label,
             .run = [system = entry.system](Desk& desk) { desk.session.view.units = system; },
             .is_on = [system = entry.system](const Desk& desk) { return desk.session.units().system() == system; }});
    }
    for (const DigitsEntry& entry : digits_entries) {
        table.add({.id = entry.id,
                   .menu = translatable("Units"),
                   .label = entry.label,
                   .run = [digits = entry.digits](Desk& desk) { desk.session.view.numbers.digits = digits; },
                   .is_on = [digits = entry.digits](
                                const Desk& desk) { return desk.session.view.numbers.digits == digits; }});
    }
    ui::standard::add_export_scales(table);
    ui::standard::add_languages(table);
}

} // namespace

CommandTable command_table()
{
    CommandTable table;
    add_document_commands(table);
    add_export_commands(table);
    add_method_commands(table);
    add_tab_commands(table);
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
    add_predict_commands(table);
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
    for (const Toggle& toggle : toggles) {
        if (toggle.item == item) return toggle.id;
    }
    return "";
}

} // namespace frame
