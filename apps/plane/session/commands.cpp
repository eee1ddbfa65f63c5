#include "apps/plane/session/commands.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "apps/plane/document/attributes.h"
#include "apps/plane/document/gallery/gallery.h"
#include "apps/plane/outline/outline.h"
#include "apps/plane/session/backdrop_commands.h"
#include "apps/plane/session/drawing_commands.h"
#include "apps/plane/session/mesher_commands.h"
#include "apps/plane/session/part_commands.h"
#include "ui/workspace/file_commands.h"
#include "ui/workspace/unit_commands.h"

namespace plane {

using ui::Key;
using ui::translatable;
using Menu = ui::MenuBuilder<Workspace>;

namespace {

constexpr std::array topic_entries{
    TopicEntry{Topic::Properties, "panel.properties", translatable("Properties")},
    TopicEntry{Topic::Model, "panel.model", translatable("Model")},
    TopicEntry{Topic::Problems, "panel.problems", translatable("Problems")},
};

constexpr std::array table_entries{
    TableEntry{TableKind::Points, "table.points", translatable("Points")},
    TableEntry{TableKind::Curves, "table.curves", translatable("Curves")},
    TableEntry{TableKind::Regions, "table.regions", translatable("Regions")},
    TableEntry{TableKind::Materials, "table.materials", translatable("Materials")},
    TableEntry{TableKind::Cases, "table.cases", translatable("Load cases")},
    TableEntry{TableKind::Combinations, "table.combinations", translatable("Combinations")},
    TableEntry{TableKind::Reactions, "table.reactions", translatable("Reactions")},
    TableEntry{TableKind::Modes, "table.modes", translatable("Natural modes")},
};

/// What a table tells is found where it is shown; it is shown no longer than the table that asked for it.
void show_table(Workspace& workspace, std::optional<TableKind> kind)
{
    Look& look = workspace.session.look;
    if (bool Look::*const came = std::exchange(workspace.shown_by_table, nullptr)) look.*came = false;
    workspace.table = kind;
    bool Look::*const told = kind == TableKind::Reactions ? &Look::reactions
                             : kind == TableKind::Modes   ? &Look::modes
                                                          : nullptr;
    if (told == nullptr || look.*told) return;
    look.*told = true;
    workspace.shown_by_table = told;
}

void add_tables(CommandTable& table)
{
    Menu menu(table, translatable("Tables"));
    menu.toggle(
        {"table.show", translatable("Show the tables"), {{Key::T, {}}}},
        [](const Workspace& workspace) { return workspace.table.has_value(); },
        [](Workspace& workspace, bool is_on) {
            show_table(workspace, is_on ? std::optional(TableKind::Points) : std::nullopt);
        });
    menu.choices(
        table_entries, [](const Workspace& workspace) { return workspace.table; }, show_table);
}

using LookEntry = ui::Choice<bool Look::*>;
constexpr std::array looks{
    LookEntry{&Look::regions, "view.show.regions", translatable("Regions"), {{Key::R, ui::shift}}},
    LookEntry{&Look::supports, "view.show.supports", translatable("Supports"), {{Key::S, ui::shift}}},
    LookEntry{&Look::loads, "view.show.loads", translatable("Loads"), {{Key::L, ui::shift}}},
    LookEntry{&Look::values, "view.show.values", translatable("Values"), {{Key::V, ui::shift}}},
    LookEntry{&Look::names, "view.show.names", translatable("Names"), {{Key::N, ui::shift}}},
    LookEntry{&Look::legend, "view.show.legend", translatable("Legend"), {{Key::T, ui::shift}}},
    LookEntry{&Look::backdrop, "view.show.background", translatable("Image behind the drawing"), {{Key::I, ui::shift}}},
};

constexpr std::array results{
    LookEntry{&Look::mesh, "results.mesh", translatable("Mesh"), {{Key::M, {}}}},
    LookEntry{&Look::deformed, "results.deformed", translatable("Deformed shape"), {{Key::D, {}}}},
    LookEntry{&Look::principal, "results.principal", translatable("Principal stresses"), {{Key::K, {}}}},
    LookEntry{&Look::trajectories, "results.trajectories", translatable("Stress trajectories"), {{Key::Y, {}}}},
    LookEntry{&Look::vectors, "results.vectors", translatable("Displacements as arrows"), {{Key::Y, ui::shift}}},
    LookEntry{&Look::error, "results.error", translatable("Estimated error"), {{Key::W, {}}}},
    LookEntry{&Look::lines, "results.lines", translatable("Lines in place of bands"), {{Key::K, ui::shift}}},
    LookEntry{&Look::element_values,
              "results.element_values",
              translatable("Element values with jumps"),
              {{Key::W, ui::shift}}},
    LookEntry{&Look::reactions, "results.reactions", translatable("Reactions"), {{Key::F, ui::shift}}},
    LookEntry{&Look::circle, "results.circle", translatable("Mohr's circle of a probe"), {{Key::Z, {}}}},
};

using femoop::plane::PlaneComponent;
constexpr std::array field_entries{
    FieldEntry{std::nullopt, "results.no_field", translatable("No bands")},
    FieldEntry{PlaneComponent::sx, "results.sx", "σx"},
    FieldEntry{PlaneComponent::sy, "results.sy", "σy"},
    FieldEntry{PlaneComponent::sz, "results.sz", "σz"},
    FieldEntry{PlaneComponent::txy, "results.txy", "τxy"},
    FieldEntry{PlaneComponent::s1, "results.s1", "σ1"},
    FieldEntry{PlaneComponent::s2, "results.s2", "σ2"},
    FieldEntry{PlaneComponent::tmax, "results.tmax", "τmax"},
    FieldEntry{PlaneComponent::Mises, "results.mises", "von Mises", {{Key::I, {}}}},
    FieldEntry{PlaneComponent::Tresca, "results.tresca", "Tresca"},
    FieldEntry{PlaneComponent::ex, "results.ex", "εx"},
    FieldEntry{PlaneComponent::ey, "results.ey", "εy"},
    FieldEntry{PlaneComponent::ez, "results.ez", "εz"},
    FieldEntry{PlaneComponent::gxy, "results.gxy", "γxy"},
    FieldEntry{PlaneComponent::ux, "results.ux", "ux"},
    FieldEntry{PlaneComponent::uy, "results.uy", "uy"},
};

struct ElementEntry {
    std::string_view id, label;
    femoop::ShapeKind kind;
};
constexpr std::array element_entries{
    ElementEntry{"mesh.T3", translatable("Mesh of T3"), femoop::ShapeKind::T3},
    ElementEntry{"mesh.T6", translatable("Mesh of T6"), femoop::ShapeKind::T6},
    ElementEntry{"mesh.Q4", translatable("Mesh of Q4"), femoop::ShapeKind::Q4},
    ElementEntry{"mesh.Q8", translatable("Mesh of Q8"), femoop::ShapeKind::Q8},
    ElementEntry{"mesh.Q9", translatable("Mesh of Q9"), femoop::ShapeKind::Q9},
};

ui::Reason why_not_refining(const Workspace& workspace)
{
    if (workspace.session.is_refining()) return std::nullopt;
    return translatable("no mesh is being refined");
}

ui::Reason why_not_refined(const Workspace& workspace)
{
    if (workspace.session.cycle() != nullptr) return std::nullopt;
    return translatable("the mesh is not refined");
}

void refine(Workspace& workspace, std::size_t n_cycles)
{
    if (const auto reason = workspace.session.refine(n_cycles)) workspace.session.notify(*reason);
}

void add_refinement(CommandTable& table)
{
    Menu menu(table, translatable("Results"));
    menu.step({"results.refine", translatable("Refine the mesh by the error"), {{Key::E, ui::shift}}},
              [](Workspace& workspace) { refine(workspace, workspace.session.look.n_cycles); });
    table.with_argument("results.refine", [](Workspace& workspace, const ui::Argument& argument) -> ui::Reason {
        constexpr auto most = discretize::ErrorCycle::most_cycles;
        const auto n = argument.number();
        if (!n || *n < 1.0 || *n > static_cast<double>(most))
            return argument.wanted("how many cycles, 1 to " + std::to_string(most));
        refine(workspace, static_cast<std::size_t>(*n));
        return std::nullopt;
    });
    menu.step(
        {"results.stop_refining", translatable("Stop refining")},
        [](Workspace& workspace) { workspace.session.stop_refining(); }, why_not_refining);
    menu.step(
        {"results.give_up", translatable("Give the analysis up")},
        [](Workspace& workspace) { workspace.session.give_up_analysis(); },
        [](const Workspace& workspace) -> ui::Reason {
            if (workspace.session.run() != nullptr) return std::nullopt;
            return translatable("no analysis is under way");
        });
    menu.step(
        {"results.go_on", translatable("Analyse all the same")},
        [](Workspace& workspace) { workspace.session.analyse_all_the_same(); },
        [](const Workspace& workspace) -> ui::Reason {
            if (workspace.session.was_left()) return std::nullopt;
            return translatable("no analysis was given up");
        });
    menu.step(
        {"results.keep_sizes", translatable("Keep the sizes of the refined mesh at the points")},
        [](Workspace& workspace) {
            const auto sizes = workspace.session.document().sizes();
            workspace.change({translatable("Keep the sizes of the refined mesh at the points"),
                              [sizes](Document& document) { keep_sizes(document, *sizes); }});
        },
        why_not_refined);
    menu.step(
        {"results.unrefined", translatable("Give the refined mesh up")},
        [](Workspace& workspace) { workspace.session.give_up_refinement(); }, why_not_refined);
}

void add_comparison(CommandTable& table)
{
    Menu menu(table, translatable("Results"));
    menu.toggle(
        {"results.compare", translatable("Compare with the present results"), {{Key::C, ui::shift}}},
        [](const Workspace& workspace) { return workspace.session.has_kept_results(); },
        [](Workspace& workspace, bool is_on) {
            Session& session = workspace.session;
            if (!is_on) return session.forget_results();
            session.look.deformed = true;
            const auto reason = session.keep_results();
            session.notify(reason ? *reason
                                  : translatable("these results are kept; what follows is compared with them"));
        });
    menu.toggle(
        {"results.beside", translatable("Side by side with the kept results"), {{Key::B, ui::shift}}},
        [](const Workspace& workspace) { return workspace.session.look.beside; },
        [](Workspace& workspace, bool is_on) { workspace.session.look.beside = is_on; },
        [](const Workspace& workspace) -> ui::Reason {
            if (workspace.session.has_kept_results()) return std::nullopt;
            return translatable("no results are kept; compare with the present ones first");
        });
    for (const ElementEntry& entry : element_entries)
        menu.step({entry.id, entry.label}, [entry](Workspace& workspace) {
            workspace.change({entry.label, [entry](Document& document) { mesh_by(document, entry.kind); }});
        });
}

void add_results(CommandTable& table)
{
    ui::standard::add_look_switches(table, translatable("Results"), results);
    Menu menu(table, translatable("Results"));
    menu.choices(
        field_entries, [](auto& workspace) -> auto& { return workspace.session.look.field; });
    menu.toggle(
        {"results.keep_range", translatable("Keep the range of the bands")},
        [](const Workspace& workspace) {
            const Look& look = workspace.session.look;
            return look.range && look.field == look.range->component;
        },
        [](Workspace& workspace, bool is_on) {
            workspace.session.look.range = is_on ? workspace.session.range_of_bands() : std::nullopt;
        },
        [](const Workspace& workspace) -> ui::Reason {
            if (workspace.session.look.field && workspace.session.input().result != nullptr) return std::nullopt;
            return translatable("no bands are shown");
        });
    table.with_argument("results.range", [](Workspace& workspace, const ui::Argument& argument) -> ui::Reason {
        const auto ends = argument.numbers(2);
        if (!ends || !(ends->at(0) < ends->at(1))) return argument.wanted("two numbers, the smaller one first");
        if (!workspace.session.look.field) return translatable("no bands are shown");
        workspace.session.look.range = KeptRange{*workspace.session.look.field, ends->at(0), ends->at(1)};
        return std::nullopt;
    });
    menu.toggle(
        {"results.animate", translatable("Animate"), {{Key::D, ui::shift}}},
        [](const Workspace& workspace) { return workspace.session.is_animated; },
        [](Workspace& workspace, bool is_on) {
            workspace.session.is_animated = is_on;
            if (is_on) workspace.session.look.deformed = true;
        });
    add_refinement(table);
    add_comparison(table);
    menu.step(
        {"results.clear_readings", translatable("Take away all probes and cuts")},
        [](Workspace& workspace) { workspace.session.look.readings = {}; },
        [](const Workspace& workspace) -> ui::Reason {
            if (!workspace.session.look.readings.are_none()) return std::nullopt;
            return translatable("there is no probe and no cut");
        });
}

ui::Reason why_no_mode(const Workspace& workspace)
{
    if (workspace.session.modes() != nullptr) return std::nullopt;
    return translatable("no natural modes are shown");
}

/// Round and round.
void go_on(Session& session, std::size_t by)
{
    const std::size_t n = session.modes()->modes.size();
    session.look.mode = (std::min(session.look.mode, n - 1) + by) % n;
}

void add_modes(CommandTable& table)
{
    Menu menu(table, translatable("Results"));
    menu.toggle(
        {"results.modes", translatable("Natural modes"), {{Key::O, ui::shift}}},
        [](const Workspace& workspace) { return workspace.session.look.modes; },
        [](Workspace& workspace, bool is_on) { workspace.session.look.modes = is_on; });
    menu.step(
        {"results.next_mode", translatable("Next mode"), {{Key::PageDown, ui::shift}}},
        [](Workspace& workspace) { go_on(workspace.session, 1); }, why_no_mode);
    menu.step(
        {"results.previous_mode", translatable("Previous mode"), {{Key::PageUp, ui::shift}}},
        [](Workspace& workspace) { go_on(workspace.session, workspace.session.modes()->modes.size() - 1); },
        why_no_mode);
    table.with_argument("results.mode", [](Workspace& workspace, const ui::Argument& argument) -> ui::Reason {
        workspace.session.look.modes = true;
        workspace.session.analyse_what_is_shown();
        if (const auto reason = why_no_mode(workspace)) return reason;
        const auto n = argument.number();
        const std::size_t most = workspace.session.modes()->modes.size();
        if (!n || *n < 1.0 || *n > static_cast<double>(most) || *n != std::floor(*n))
            return argument.wanted("the number of a mode, 1 to " + std::to_string(most));
        workspace.session.look.mode = static_cast<std::size_t>(*n) - 1;
        return std::nullopt;
    });
}

void add_gallery(CommandTable& table)
{
    Menu menu(table, translatable("Gallery"));
    for (std::size_t i = 0; i < gallery().size(); ++i)
        menu.step({gallery()[i].id, gallery()[i].title, {}}, [i](Workspace& workspace) {
            workspace.leave_document([i](Workspace& left) {
                Document document = gallery_document(i);
                document.model.title = left.tr()(gallery()[i].title);
                left.session.show_example(std::move(document));
                left.hand.select(ToolKind::Select);
            });
        });
}

void add_view_commands(CommandTable& table)
{
    ui::standard::add_zoom(table, translatable("Show the whole drawing"), {{Key::F, {}}});
    ui::standard::add_panels(table);
    ui::standard::add_topics(table, topic_entries);
    ui::standard::add_projector(table);
    ui::standard::add_themes(table);
    ui::standard::add_export_scales(table);
    ui::standard::add_look_switches(table, translatable("Show"), looks);
    ui::standard::add_units(
        table, [](auto& workspace) -> auto& { return workspace.session.look; },
        [](Workspace& workspace) { workspace.asks_for_units = true; });
    ui::standard::add_languages(table);
}

void add_insert(CommandTable& table)
{
    Menu menu(table, ui::standard::file_menu);
    menu.step({"file.insert", translatable("Insert an outline (DXF, SVG)…"), {{Key::I, ui::ctrl}}},
              [](Workspace& workspace) { workspace.asks_for_outline = true; });
    table.with_argument("file.insert", [](Workspace& workspace, const ui::Argument& path) {
        return ui::standard::notice_unless(workspace.insert_outline(path.text), workspace);
    });
    menu.step({"file.background", translatable("Image behind the drawing (PNG, JPEG)…")},
              [](Workspace& workspace) { workspace.asks_for_backdrop = true; });
    table.with_argument("file.background", [](Workspace& workspace, const ui::Argument& path) {
        return ui::standard::notice_unless(workspace.insert_backdrop(path.text), workspace);
    });
}

} // namespace

Workspace::Workspace(Session first) : DocumentWorkspace(std::move(first))
{
    if (session.document().backdrop && !session.path()) hand.select(ToolKind::Align);
}

void Workspace::open(const std::filesystem::path& path)
{
    if (outline::is_outline_file(path)) insert_outline(path);
    else if (is_image_file(path)) insert_backdrop(path);
    else DocumentWorkspace::open(path);
}

bool Workspace::open_at_once(const std::filesystem::path& path)
{
    if (outline::is_outline_file(path)) return insert_outline(path);
    return is_image_file(path) ? insert_backdrop(path) : DocumentWorkspace::open_at_once(path);
}

bool Workspace::insert_outline(const std::filesystem::path& path)
{
    if (!session.insert_outline(path)) return false;
    asked.push_back(ui::Request::Fit);
    return true;
}

bool Workspace::insert_backdrop(const std::filesystem::path& path)
{
    if (!session.insert_backdrop(path)) return false;
    asked.push_back(ui::Request::Fit);
    hand.select(ToolKind::Align);
    return true;
}

std::optional<ui::Message> Workspace::change(const Change& change)
{
    auto reason = session.change(change);
    if (reason) session.notify(*reason);
    return reason;
}

void Workspace::draw(const std::optional<CurveDraft>& drawn)
{
    if (!drawn) return;
    change({translatable("Draw a curve"), [draft = *drawn](Document& document) { draw_curve(document, draft); }});
}

void Workspace::align(const std::optional<Alignment>& told)
{
    if (!told) return;
    change({translatable("Place the image by two points"), [alignment = *told](Document& document) {
                if (document.backdrop) document.backdrop = aligned(*document.backdrop, alignment);
            }});
    hand.select(ToolKind::Select);
    asked.push_back(ui::Request::Fit);
}

std::span<const FieldEntry> fields() { return field_entries; }
std::span<const TableEntry> tables() { return table_entries; }
std::span<const TopicEntry> topics() { return topic_entries; }

CommandTable command_table()
{
    CommandTable table;
    ui::standard::add_file_commands(
        table, {.exported = translatable("Export picture…"), .described = translatable("Drawing in words")});
    add_insert(table);
    ui::standard::add_undo_and_redo(table);
    add_edit_commands(table);
    add_drawing_commands(table);
    add_backdrop_commands(table);
    add_part_commands(table);
    add_results(table);
    add_modes(table);
    add_mesher_commands(table);
    add_tables(table);
    add_gallery(table);
    add_view_commands(table);
    ui::standard::add_help(table);
    return table;
}

} // namespace plane
