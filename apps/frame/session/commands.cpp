#include "apps/frame/session/commands.h"

#include "apps/frame/session/edit_commands.h"
#include "apps/frame/session/predict_commands.h"
#include "apps/frame/session/property_commands.h"
#include "apps/frame/session/set_commands.h"
#include "apps/frame/session/table_commands.h"
#include "apps/frame/session/tabs.h"
#include "apps/frame/session/view_commands.h"

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

constexpr std::string_view file_menu = translatable("File");
constexpr std::string_view show_menu = translatable("Show");
constexpr std::string_view view_menu = translatable("View");
constexpr std::string_view help_menu = translatable("Help");

// A command that asks the window for something.
std::function<void(Desk&)> asks(Request request)
{
    return [request](Desk& desk) { desk.requests.push_back(request); };
}

void add_file_commands(CommandTable& table)
{
    table.add({.id = "file.new",
               .menu = file_menu,
               .label = translatable("New"),
               .shortcuts = {{Key::N, ui::ctrl}},
               .run = new_document});
    table.add({.id = "file.open",
               .menu = file_menu,
               .label = translatable("Open…"),
               .shortcuts = {{Key::O, ui::ctrl}},
               .run = asks(Request::OpenDialog)});
    table.add({.id = "file.recent",
               .menu = file_menu,
               .label = translatable("Open one of the last files…"),
               .shortcuts = {{Key::O, ui::ctrl_shift}},
               .run = asks(Request::RecentList)});
    table.add({.id = "file.save",
               .menu = file_menu,
               .label = translatable("Save"),
               .shortcuts = {{Key::S, ui::ctrl}},
               .run = [](Desk& desk) {
                   if (desk.session.path()) desk.session.save(*desk.session.path());
                   else desk.requests.push_back(Request::SaveDialog);
               }});
    table.add({.id = "file.save_as",
               .menu = file_menu,
               .label = translatable("Save as…"),
               .shortcuts = {{Key::S, ui::ctrl_shift}},
               .run = asks(Request::SaveDialog)});
    table.add({.id = "file.export",
               .menu = file_menu,
               .label = translatable("Export picture, results or report…"),
               .shortcuts = {{Key::E, ui::ctrl_shift}},
               .run = asks(Request::ExportDialog)});
    table.add({.id = "file.report_matrices",
               .menu = file_menu,
               .label = translatable("Matrices in the report"),
               .run = [](Desk& desk) { desk.session.reports_matrices = !desk.session.reports_matrices; },
               .is_on = [](const Desk& desk) { return desk.session.reports_matrices; }});
    table.add({.id = "file.copy_picture",
               .menu = file_menu,
               .label = translatable("Copy picture"),
               .shortcuts = {{Key::C, ui::ctrl_shift}},
               .run = asks(Request::CopyPicture)});
    table.add({.id = "file.describe",
               .menu = file_menu,
               .label = translatable("Model and results in words"),
               .shortcuts = {{Key::D, ui::ctrl_shift}},
               .run = asks(Request::Description)});
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
    table.add({.id = "file.quit",
               .menu = file_menu,
               .label = translatable("Quit"),
               .shortcuts = {{Key::Q, ui::ctrl}},
               .run = asks(Request::Quit)});
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
void keep_or_drop_ghost(Session& session)
{
    std::shared_ptr<const Ghost>& ghost = session.view.ghost;
    if (ghost) ghost.reset();
    else ghost = std::make_shared<const Ghost>(Ghost{session.model(), *session.solution().results});
}

// Large type and the whole window for the picture, and back.
void project(Desk& desk)
{
    ui::ThemeName& theme = desk.session.view.theme;
    const bool is_projecting = theme == ui::ThemeName::Projector;
    theme = is_projecting ? ui::ThemeName::Light : ui::ThemeName::Projector;
    desk.has_panels = is_projecting;
}

Reason needs_cases(const Desk& desk)
{
    if (desk.session.model().n_cases() > 1) return std::nullopt;
    return translatable("the model has no other load case");
}

void add_camera_commands(CommandTable& table)
{
    table.add({.id = "view.fit",
               .menu = view_menu,
               .label = translatable("Show the whole model"),
               .shortcuts = {{Key::F, {}}, {Key::Home, {}}},
               .run = asks(Request::Fit)});
    table.add({.id = "view.zoom_in",
               .menu = view_menu,
               .label = translatable("Zoom in"),
               .shortcuts = {{Key::Plus, {}}, {Key::Plus, ui::shift}, {Key::Plus, ui::ctrl}},
               .run = asks(Request::ZoomIn)});
    table.add({.id = "view.zoom_out",
               .menu = view_menu,
               .label = translatable("Zoom out"),
               .shortcuts = {{Key::Minus, {}}, {Key::Minus, ui::ctrl}},
               .run = asks(Request::ZoomOut)});
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
               .run = [](Desk& desk) { keep_or_drop_ghost(desk.session); },
               .why_not = [](const Desk& desk) -> Reason {
                   if (desk.session.view.ghost || desk.session.solution().results) return std::nullopt;
                   return translatable("the model has no results");
               },
               .is_on = [](const Desk& desk) { return desk.session.view.ghost != nullptr; }});
    table.add({.id = "view.project",
               .menu = view_menu,
               .label = translatable("For the projector"),
               .shortcuts = {{Key::F5, {}}},
               .run = project,
               .is_on = [](const Desk& desk) { return desk.session.view.theme == ui::ThemeName::Projector; }});
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
    table.add({.id = "view.panels",
               .menu = view_menu,
               .label = translatable("Panels"),
               .shortcuts = {{Key::P, {}}},
               .run = [](Desk& desk) { desk.has_panels = !desk.has_panels; },
               .is_on = [](const Desk& desk) { return desk.has_panels; }});
    for (const TopicEntry& entry : topic_entries) {
        table.add({.id = entry.id,
                   .menu = view_menu,
                   .label = entry.label,
                   .run =
                       [topic = entry.topic](Desk& desk) {
                           desk.topic = topic;
                           desk.has_panels = true;
                       },
                   .is_on = [topic = entry.topic](const Desk& desk) { return desk.topic == topic; }});
    }
}

struct ThemeEntry {
    ui::ThemeName theme;
    std::string_view id, label;
};
constexpr std::array themes{
    ThemeEntry{ui::ThemeName::Light, "view.theme.light", translatable("Light theme")},
    ThemeEntry{ui::ThemeName::Dark, "view.theme.dark", translatable("Dark theme")},
    ThemeEntry{ui::ThemeName::Print, "view.theme.print", translatable("Print theme")},
    ThemeEntry{ui::ThemeName::Projector, "view.theme.projector", translatable("Projector theme")},
};

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

struct ScaleEntry {
    double scale;
    std::string_view id, label;
};
constexpr std::array scales{
    ScaleEntry{1.0, "file.export_scale.1", translatable("Export PNG at 1×")},
    ScaleEntry{2.0, "file.export_scale.2", translatable("Export PNG at 2×")},
    ScaleEntry{3.0, "file.export_scale.3", translatable("Export PNG at 3×")},
    ScaleEntry{4.0, "file.export_scale.4", translatable("Export PNG at 4×")},
};

void add_look_commands(CommandTable& table)
{
    for (const ThemeEntry& entry : themes) {
        table.add({.id = entry.id,
                   .menu = view_menu,
                   .label = entry.label,
                   .run = [name = entry.theme](Desk& desk) { desk.session.view.theme = name; },
                   .is_on = [name = entry.theme](const Desk& desk) { return desk.session.view.theme == name; }});
    }
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
    for (const ScaleEntry& entry : scales) {
        table.add({.id = entry.id,
                   .menu = view_menu,
                   .label = entry.label,
                   .run = [scale = entry.scale](Desk& desk) { desk.export_scale = scale; },
                   .is_on = [scale = entry.scale](const Desk& desk) { return desk.export_scale == scale; }});
    }
    const auto speaks = [](ui::Language language) {
        return [language](const Desk& desk) { return desk.session.view.tr.language() == language; };
    };
    const auto learn = [](ui::Language language) {
        return [language](Desk& desk) { desk.session.set_language(language); };
    };
    using enum ui::Language;
    constexpr std::string_view menu = translatable("Language");
    table.add(
        {.id = "view.language.en", .menu = menu, .label = "English", .run = learn(English), .is_on = speaks(English)});
    table.add({.id = "view.language.pt",
               .menu = menu,
               .label = "Português (Brasil)",
               .run = learn(Portuguese),
               .is_on = speaks(Portuguese)});
}

void add_help_commands(CommandTable& table)
{
    table.add({.id = "help.palette",
               .menu = help_menu,
               .label = translatable("Find a command…"),
               .shortcuts = {{Key::K, ui::ctrl}, {Key::F3, {}}},
               .run = asks(Request::Palette)});
    table.add({.id = "help.shortcuts",
               .menu = help_menu,
               .label = translatable("Keys"),
               .shortcuts = {{Key::F1, {}}},
               .run = asks(Request::ShortcutList)});
}

} // namespace

CommandTable command_table()
{
    CommandTable table;
    add_file_commands(table);
    add_edit_commands(table);
    add_property_commands(table);
    add_set_commands(table);
    add_tool_commands(table);
    add_show_commands(table);
    add_camera_commands(table);
    add_view_commands(table);
    add_predict_commands(table);
    add_panel_commands(table);
    add_table_commands(table);
    add_look_commands(table);
    add_help_commands(table);
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
