#include "apps/euler/session/look_commands.h"

#include <array>

#include "ui/desk/standard_commands.h"

namespace euler {

using topology::EntityKind;
using topology::TableKind;
using ui::Key;
using ui::translatable;

namespace {

using ui::standard::view_menu;
constexpr std::string_view show_menu = translatable("Show");

struct KindEntry {
    ViewKind kind;
    std::string_view id, label;
    Key key;
};
constexpr std::array kinds{
    KindEntry{ViewKind::Space, "view.space", translatable("In space"), Key::Digit1},
    KindEntry{ViewKind::Plane, "view.plane", translatable("As a map in the plane"), Key::Digit2},
    KindEntry{ViewKind::Polygons, "view.polygons", translatable("As polygons: the plane model"), Key::Digit3},
};

struct DirectionEntry {
    Request request;
    std::string_view id, label;
    Key key;
};
constexpr std::array directions{
    DirectionEntry{Request::LookFront, "view.front", translatable("From the front"), Key::Digit8},
    DirectionEntry{Request::LookSide, "view.side", translatable("From the side"), Key::Digit9},
    DirectionEntry{Request::LookTop, "view.top", translatable("From the top"), Key::Digit0},
};

void add_views(CommandTable& table)
{
    for (const KindEntry& entry : kinds)
        table.add({.id = entry.id,
                   .menu = view_menu,
                   .label = entry.label,
                   .shortcuts = {{entry.key, {}}},
                   .run = [kind = entry.kind](Desk& desk) { desk.session.show_as(kind); },
                   .is_on = [kind = entry.kind](const Desk& desk) { return desk.session.view() == kind; }});
    ui::standard::add_zoom(table, translatable("Show everything"), {{Key::F, {}}});
    table.add({.id = "view.isometric",
               .menu = view_menu,
               .label = translatable("From a corner"),
               .shortcuts = {{Key::Digit7, {}}},
               .run = [](Desk& desk) { desk.session.look_from_corner(); }});
    for (const DirectionEntry& entry : directions)
        table.add({.id = entry.id,
                   .menu = view_menu,
                   .label = entry.label,
                   .shortcuts = {{entry.key, {}}},
                   .run = asks(entry.request)});
}

struct LookEntry {
    bool Look::*item;
    std::string_view id, label;
    Key key;
};
constexpr std::array looks{
    LookEntry{&Look::faces, "view.show.faces", translatable("Faces"), Key::F},
    LookEntry{&Look::hatching, "view.show.hatching", translatable("Hatching of back faces"), Key::B},
    LookEntry{&Look::half_edges, "view.show.half_edges", translatable("Half-edges"), Key::H},
};

struct NameEntry {
    EntityKind kind;
    std::string_view id, label;
    Key key;
};
constexpr std::array names{
    NameEntry{EntityKind::Vertex, "view.show.vertex_names", translatable("Names of vertices"), Key::V},
    NameEntry{EntityKind::Edge, "view.show.edge_names", translatable("Names of edges"), Key::E},
    NameEntry{EntityKind::HalfEdge, "view.show.half_edge_names", translatable("Names of half-edges"), Key::D},
    NameEntry{EntityKind::Face, "view.show.face_names", translatable("Names of faces"), Key::N},
};

void flip(std::set<EntityKind>& kinds_named, EntityKind kind)
{
    if (kinds_named.erase(kind) == 0) kinds_named.insert(kind);
}

void add_show(CommandTable& table)
{
    ui::standard::add_look_switches(table, show_menu, looks);
    for (const NameEntry& entry : names)
        table.add({.id = entry.id,
                   .menu = show_menu,
                   .label = entry.label,
                   .shortcuts = {{entry.key, ui::shift}},
                   .run = [kind = entry.kind](Desk& desk) { flip(desk.session.look.names, kind); },
                   .is_on = [kind = entry.kind](const Desk& desk) { return desk.session.look.names.contains(kind); }});
    table.add({.id = "view.show.exploded",
               .menu = show_menu,
               .label = translatable("Exploded"),
               .shortcuts = {{Key::X, ui::shift}},
               .run = [](Desk& desk) { desk.session.look.explosion = desk.session.look.explosion > 0.0 ? 0.0 : 0.5; },
               .is_on = [](const Desk& desk) { return desk.session.look.explosion > 0.0; }});
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

void add_panels(CommandTable& table)
{
    ui::standard::add_panels(table);
    table.add({.id = "view.tables",
               .menu = view_menu,
               .label = translatable("Tables"),
               .shortcuts = {{Key::T, {}}},
               .run = [](Desk& desk) { desk.has_tables = !desk.has_tables; },
               .is_on = [](const Desk& desk) { return desk.has_tables; }});
    ui::standard::add_topics(table, topic_entries);
    for (const TableEntry& entry : table_entries)
        table.add(
            {.id = entry.id,
             .menu = translatable("Tables"),
             .label = entry.label,
             .run =
                 [kind = entry.table](Desk& desk) {
                     desk.show_table(kind);
                     desk.has_tables = true;
                 },
             .is_on = [kind = entry.table](
                          const Desk& desk) { return desk.table == kind && desk.structure == Structure::HalfEdges; }});
    table.add({.id = "table.winged",
               .menu = translatable("Tables"),
               .label = translatable("Winged edges"),
               .run =
                   [](Desk& desk) {
                       desk.structure = Structure::WingedEdges;
                       desk.has_tables = true;
                   },
               .is_on = [](const Desk& desk) { return desk.structure == Structure::WingedEdges; }});
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
