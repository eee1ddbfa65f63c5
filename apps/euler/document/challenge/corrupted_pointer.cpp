#include "apps/euler/document/challenge/corrupted_pointer.h"

#include <algorithm>
#include <array>
#include <random>
#include <vector>

#include "apps/euler/document/gallery/gallery.h"
#include "apps/euler/document/stepper.h"
#include "topology/halfedge/check/validate.h"
#include "topology/text/words.h"
#include "ui/text/catalogue.h"

namespace euler {

namespace {

using topology::CorruptedLink;
using topology::LinkKind;
using topology::Solid;
using topology::TableKind;
using ui::Message;
using ui::translatable;

struct ShownLink {
    TableKind table;
    std::string_view label;
    LinkKind link;
    TableKind to; ///< the table of what it leads to
};
constexpr std::array<ShownLink, 10> shown{{
    {TableKind::Vertices, "H", LinkKind::VertexHalfEdge, TableKind::HalfEdges},
    {TableKind::HalfEdges, "V", LinkKind::HalfEdgeStart, TableKind::Vertices},
    {TableKind::HalfEdges, "E", LinkKind::HalfEdgeEdge, TableKind::Edges},
    {TableKind::HalfEdges, "L", LinkKind::HalfEdgeLoop, TableKind::Loops},
    {TableKind::HalfEdges, "N", LinkKind::HalfEdgeNext, TableKind::HalfEdges},
    {TableKind::HalfEdges, "P", LinkKind::HalfEdgePrev, TableKind::HalfEdges},
    {TableKind::Edges, "H1", LinkKind::EdgePlus, TableKind::HalfEdges},
    {TableKind::Edges, "H2", LinkKind::EdgeMinus, TableKind::HalfEdges},
    {TableKind::Loops, "H", LinkKind::LoopHalfEdge, TableKind::HalfEdges},
    {TableKind::Loops, "F", LinkKind::LoopFace, TableKind::Faces},
}};

std::uint32_t any_row(const Solid& solid, TableKind table, std::mt19937& random)
{
    const std::vector<topology::TableRow> rows = entity_tables(solid)[table];
    return rows[random() % rows.size()].entity->index;
}

Solid any_solid(std::mt19937& random)
{
    constexpr std::size_t n_small = 4; // the lessons whose tables can be read through
    Stepper lesson(gallery()[random() % n_small].script);
    lesson.go_to(5 + random() % (lesson.n_steps() - 4));
    return lesson.runner().solids().front().solid;
}

Message message(const topology::Breach& breach)
{
    Message said(topology::pattern(breach.invariant));
    for (std::size_t i = 0; i < breach.entities.size(); ++i)
        said.arguments.emplace_back(std::to_string(i), topology::table_name(breach.entities[i]));
    return said;
}

std::string_view table_hint(TableKind table)
{
    switch (table) {
    case TableKind::Vertices: return translatable("look among the vertices");
    case TableKind::HalfEdges: return translatable("look among the half-edges");
    case TableKind::Edges: return translatable("look among the edges");
    default: return translatable("look among the loops");
    }
}

using Rows = std::vector<topology::TableRow>;

const topology::TableRow* find_row(const Rows& rows, std::string_view number)
{
    const auto found = std::find_if(rows.begin(), rows.end(), [&](const topology::TableRow& row) {
        return row.entity && std::to_string(row.number) == number;
    });
    return found == rows.end() ? nullptr : &*found;
}

const ShownLink* find_link(std::string_view row, std::string_view label)
{
    const auto letter = [](TableKind table) -> std::string_view {
        switch (table) {
        case TableKind::Vertices: return "V";
        case TableKind::HalfEdges: return "H";
        case TableKind::Edges: return "E";
        default: return "L";
        }
    };
    const auto* const found = std::find_if(shown.begin(), shown.end(), [&](const ShownLink& link) {
        return letter(link.table) == row && link.label == label;
    });
    return found == shown.end() ? nullptr : found;
}

} // namespace

CorruptedPointer broken_pointer(std::uint32_t seed)
{
    std::mt19937 random(seed);
    const Solid sound = any_solid(random);
    while (true) {
        const ShownLink& link = shown[random() % shown.size()];
        const std::uint32_t row = any_row(sound, link.table, random);
        const CorruptedLink bent{.kind = link.link, .row = row, .to = any_row(sound, link.to, random)};
        const Solid broken = topology::CorruptedSolid(sound, bent).solid();
        if (const auto breach = why_not_valid(broken)) // not every other half-edge of a vertex or loop is wrong
            return {.sound = sound,
                    .broken = broken,
                    .bent = bent,
                    .table = link.table,
                    .message = message(*breach),
                    .where = table_hint(link.table)};
    }
}

bool is_mended(const CorruptedPointer& broken, const CorruptedLink& set)
{
    return !why_not_valid(topology::CorruptedSolid(broken.broken, set).solid());
}

std::optional<LinkKind> link_of(TableKind table, std::string_view label)
{
    for (const ShownLink& link : shown)
        if (link.table == table && link.label == label) return link.link;
    return std::nullopt;
}

std::variant<CorruptedLink, Message> link_typed(const CorruptedPointer& broken, std::string_view text)
{
    const std::vector<std::string_view> words = topology::words(text);
    if (words.size() != 4) return Message(translatable("write a row, a column and a number: H 3 N 4"));
    const ShownLink* const link = find_link(words[0], words[2]);
    if (link == nullptr) return Message(translatable("no pointer stands in that column: those of V, H, E and L do"));
    const topology::EntityTables tables = entity_tables(broken.broken);
    const auto missing = [](std::string_view number) {
        return Message(translatable("no row has the number {number}"), {{"number", std::string(number)}});
    };
    const topology::TableRow* const row = find_row(tables[link->table], words[1]);
    if (row == nullptr) return missing(words[1]);
    const topology::TableRow* const to = find_row(tables[link->to], words[3]);
    if (to == nullptr) return missing(words[3]);
    return CorruptedLink{.kind = link->link, .row = row->entity->index, .to = to->entity->index};
}

std::string way_back(const CorruptedPointer& broken)
{
    const topology::EntityTables tables = entity_tables(broken.sound);
    for (const topology::TableRow& row : tables[broken.table])
        for (const topology::TableCell& cell : row.cells)
            if (row.entity && row.entity->index == broken.bent.row &&
                link_of(broken.table, cell.label) == broken.bent.kind)
                return std::string(row.label) + " " + std::to_string(row.number) + " " + std::string(cell.label) + " " +
                       std::to_string(cell.number);
    return "";
}

} // namespace euler
