#include "apps/euler/document/challenge/broken_pointer.h"

#include <array>
#include <random>
#include <vector>

#include "apps/euler/document/gallery/gallery.h"
#include "apps/euler/document/stepper.h"
#include "topology/halfedge/check/validate.h"
#include "ui/text/catalogue.h"

namespace euler {

namespace {

using topology::BentLink;
using topology::LinkKind;
using topology::Solid;
using topology::TableKind;
using ui::Phrase;
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

Phrase message(const topology::Breach& breach)
{
    Phrase said(topology::pattern(breach.invariant));
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

} // namespace

BrokenPointer broken_pointer(std::uint32_t seed)
{
    std::mt19937 random(seed);
    const Solid sound = any_solid(random);
    while (true) {
        const ShownLink& link = shown[random() % shown.size()];
        const std::uint32_t row = any_row(sound, link.table, random);
        const BentLink bent{.kind = link.link, .row = row, .to = any_row(sound, link.to, random)};
        const Solid broken = topology::BrokenSolid(sound, bent).solid();
        if (const auto breach = why_not_valid(broken)) // not every other half-edge of a vertex or loop is wrong
            return {.sound = sound,
                    .broken = broken,
                    .bent = bent,
                    .table = link.table,
                    .message = message(*breach),
                    .where = table_hint(link.table)};
    }
}

bool is_mended(const BrokenPointer& broken, const BentLink& set)
{
    return !why_not_valid(topology::BrokenSolid(broken.broken, set).solid());
}

std::optional<LinkKind> link_of(TableKind table, std::string_view label)
{
    for (const ShownLink& link : shown)
        if (link.table == table && link.label == label) return link.link;
    return std::nullopt;
}

} // namespace euler
