#include "apps/euler/session/look_commands.h"

#include <array>

#include "ui/workspace/standard_commands.h"

namespace euler {

using topology::EntityKind;
using topology::TableKind;
using ui::Key;
using ui::shift;
using ui::translatable;
using Menu = ui::MenuBuilder<Workspace>;

namespace {

using ui::standard::view_menu;
constexpr std::string_view show_menu = translatable("Show");

constexpr std::array kinds{
    ui::Choice<ViewKind>{ViewKind::Space, "view.space", translatable("In space"), {{Key::Digit1, {}}}},
    ui::Choice<ViewKind>{ViewKind::Plane, "view.plane", translatable("As a map in the plane"), {{Key::Digit2, {}}}},
    ui::Choice<ViewKind>{
        ViewKind::Polygons, "view.polygons", translatable("As polygons: the plane model"), {{Key::Digit3, {}}}},
};

void add_views(CommandTable& table)
{
    Menu menu(table, view_menu);
    menu.choices(
        kinds, [](const Workspace& workspace) { return workspace.session.view(); },
        [](Workspace& workspace, ViewKind kind) { workspace.session.show_as(kind); });
    ui::standard::add_zoom(table, translatable("Show everything"), {{Key::F, {}}});
    menu.step({"view.isometric", translatable("From a corner"), {{Key::Digit7, {}}}},
              [](Workspace& workspace) { workspace.session.look_from_corner(); });
    menu.step({"view.front", translatable("From the front"), {{Key::Digit8, {}}}}, asks(Request::LookFront));
    menu.step({"view.side", translatable("From the side"), {{Key::Digit9, {}}}}, asks(Request::LookSide));
    menu.step({"view.top", translatable("From the top"), {{Key::Digit0, {}}}}, asks(Request::LookTop));
}

using LookEntry = ui::Choice<bool Look::*>;
constexpr std::array looks{
    LookEntry{&Look::faces, "view.show.faces", translatable("Faces"), {{Key::F, shift}}},
    LookEntry{&Look::hatching, "view.show.hatching", translatable("Hatching of back faces"), {{Key::B, shift}}},
    LookEntry{&Look::half_edges, "view.show.half_edges", translatable("Half-edges"), {{Key::H, shift}}},
};

using NameEntry = ui::Choice<EntityKind>;
constexpr std::array names{
    NameEntry{EntityKind::Vertex, "view.show.vertex_names", translatable("Names of vertices"), {{Key::V, shift}}},
    NameEntry{EntityKind::Edge, "view.show.edge_names", translatable("Names of edges"), {{Key::E, shift}}},
    NameEntry{
        EntityKind::HalfEdge, "view.show.half_edge_names", translatable("Names of half-edges"), {{Key::D, shift}}},
    NameEntry{EntityKind::Face, "view.show.face_names", translatable("Names of faces"), {{Key::N, shift}}},
};

void show_names(Workspace& workspace, EntityKind kind, bool is_on)
{
    if (is_on) workspace.session.look.names.insert(kind);
    else workspace.session.look.names.erase(kind);
}

void add_show(CommandTable& table)
{
    ui::standard::add_look_switches(table, show_menu, looks);
    Menu menu(table, show_menu);
    menu.toggles(
        names, [](const Workspace& workspace, EntityKind kind) { return workspace.session.look.names.contains(kind); },
        show_names);
    menu.toggle(
        {"view.show.exploded", translatable("Exploded"), {{Key::X, shift}}},
        [](const Workspace& workspace) { return workspace.session.look.explosion > 0.0; },
        [](Workspace& workspace, bool is_on) { workspace.session.look.explosion = is_on ? 0.5 : 0.0; });
}

constexpr std::array topic_entries{
    TopicEntry{Topic::Script, "panel.script", translatable("Script")},
    TopicEntry{Topic::Operators, "panel.operators", translatable("Operators")},
    TopicEntry{Topic::Gallery, "panel.gallery", translatable("Gallery")},
    TopicEntry{Topic::Challenges, "panel.challenges", translatable("Challenges")},
};

constexpr std::array table_entries{
    TableEntry{TableKind::Vertices, "table.vertices", translatable("Vertices")},
    TableEntry{TableKind::HalfEdges, "table.half_edges", translatable("Half-edges")},
    TableEntry{TableKind::Edges, "table.edges", translatable("Edges")},
    TableEntry{TableKind::Loops, "table.loops", translatable("Loops")},
    TableEntry{TableKind::Faces, "table.faces", translatable("Faces")},
    TableEntry{TableKind::Solids, "table.solids", translatable("Solids")},
};

bool shows_winged_edges(const Workspace& workspace) { return workspace.structure == Structure::WingedEdges; }

std::optional<TableKind> shown_table(const Workspace& workspace)
{
    return shows_winged_edges(workspace) ? std::nullopt : std::optional(workspace.table);
}

void open_table(Workspace& workspace, TableKind kind)
{
    workspace.show_table(kind);
    workspace.has_tables = true;
}

void open_winged_edges(Workspace& workspace)
{
    workspace.structure = Structure::WingedEdges;
    workspace.has_tables = true;
}

void add_panels(CommandTable& table)
{
    ui::standard::add_panels(table);
    Menu(table, view_menu)
        .toggle(
            {"view.tables", translatable("Tables"), {{Key::T, {}}}},
            [](auto& workspace) -> auto& { return workspace.has_tables; });
    ui::standard::add_topics(table, topic_entries);
    Menu menu(table, translatable("Tables"));
    menu.choices(table_entries, shown_table, open_table);
    menu.step({"table.winged", translatable("Winged edges")}, open_winged_edges).is_on = shows_winged_edges;
}

} // namespace

void add_look_commands(CommandTable& table)
{
    add_views(table);
    add_show(table);
}

void add_panel_commands(CommandTable& table)
{
    add_panels(table);
    ui::standard::add_projector(table);
    ui::standard::add_themes(table);
    ui::standard::add_export_scales(table);
    ui::standard::add_languages(table);
}

std::span<const TopicEntry> topics() { return topic_entries; }
std::span<const TableEntry> tables() { return table_entries; }

} // namespace euler
