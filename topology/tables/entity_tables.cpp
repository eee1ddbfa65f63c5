#include "topology/tables/entity_tables.h"

#include <algorithm>
#include <span>

namespace topology {

namespace {

template <class Id> std::size_t number_of(Id id) { return id == nothing<Id> ? 0 : std::size_t{id.index} + 1; }

template <class Table> std::size_t oldest(const Table& table)
{
    return table.n_living() == 0 ? 0 : number_of(*table.begin());
}

/// What the cells of a table are called, and what they lead to.
struct Column {
    std::string_view label;
    std::optional<EntityKind> kind; ///< none of a solid
};
using enum EntityKind;
constexpr std::array vertex_columns{Column{"H", HalfEdge}, Column{"N", Vertex}, Column{"P", Vertex}};
constexpr std::array half_edge_columns{Column{"V", Vertex}, Column{"E", Edge}, Column{"L", Loop}, Column{"N", HalfEdge},
                                       Column{"P", HalfEdge}};
constexpr std::array edge_columns{Column{"H1", HalfEdge}, Column{"H2", HalfEdge}, Column{"N", Edge}, Column{"P", Edge}};
constexpr std::array loop_columns{Column{"H", HalfEdge}, Column{"F", Face}, Column{"N", Loop}, Column{"P", Loop}};
constexpr std::array face_columns{Column{"S", {}}, Column{"LOUT", Loop}, Column{"LOOPS", Loop}, Column{"N", Face},
                                  Column{"P", Face}};
constexpr std::array solid_columns{Column{"V", Vertex}, Column{"F", Face}, Column{"E", Edge}, Column{"N", {}},
                                   Column{"P", {}}};

struct Form {
    std::string_view label;
    std::optional<EntityKind> kind; ///< none of a solid
    std::span<const Column> columns;
};
const std::array<Form, n_table_kinds> forms{{{"V", Vertex, vertex_columns},
                                             {"H", HalfEdge, half_edge_columns},
                                             {"E", Edge, edge_columns},
                                             {"L", Loop, loop_columns},
                                             {"F", Face, face_columns},
                                             {"S", {}, solid_columns}}};

std::optional<Entity> entity(std::optional<EntityKind> kind, std::size_t number)
{
    if (!kind || number == 0) return std::nullopt;
    Entity found;
    found.kind = *kind;
    found.index = static_cast<std::uint32_t>(number - 1);
    return found;
}

template <class Table> std::vector<std::uint32_t> living(const Table& table)
{
    std::vector<std::uint32_t> rows;
    rows.reserve(table.n_living());
    for (const auto id : table) rows.push_back(id.index);
    return rows;
}

/// As the edge has it, not as a mate would be found in a sound solid.
HalfEdgeId other_half(const Solid& solid, HalfEdgeId h)
{
    const auto e = solid.edge(h);
    if (!e) return h;
    return solid.plus(*e) == h ? solid.minus(*e) : solid.plus(*e);
}

} // namespace

EntityRows::EntityRows(const Solid& solid, const SolidPlace& place)
    : solid_(&solid),
      place_(place),
      living_{living(solid.vertices()), living(solid.half_edges()), living(solid.edges()), living(solid.loops()),
              living(solid.faces())},
      loops_of_(solid.faces().n_rows()),
      is_bounding_(solid.loops().n_rows(), false)
{
    for (const LoopId l : solid.loops()) loops_of_[solid.face(l).index].push_back(l);
    for (const HalfEdgeId h : solid.half_edges())
        if (solid.loop(other_half(solid, h)) != solid.loop(h)) is_bounding_[solid.loop(h).index] = true;
}

std::size_t EntityRows::size(TableKind kind) const
{
    if (solid_ == nullptr) return 0;
    if (kind == TableKind::Solids) return 1;
    const std::size_t n = living_[static_cast<std::size_t>(kind)].size();
    return kind == TableKind::Edges ? std::max<std::size_t>(n, 1) : n;
}

std::size_t EntityRows::number(TableKind kind, std::size_t row) const
{
    if (kind == TableKind::Solids) return place_.number;
    const bool has_none = living_[static_cast<std::size_t>(kind)].empty(); // a row says that there is no edge
    return has_none ? 0 : std::size_t{index(kind, row)} + 1;
}

EntityRows::Numbers EntityRows::numbers(TableKind kind, std::size_t row) const
{
    if (number(kind, row) == 0) return {};
    switch (kind) {
    case TableKind::Vertices:
        return {number_of(solid_->half_edge(VertexId{index(kind, row)})), before(kind, row), after(kind, row)};
    case TableKind::HalfEdges: {
        const HalfEdgeId i{index(kind, row)};
        const topology::HalfEdge& h = solid_->half_edges()[i];
        const bool is_lone = !solid_->edge(i);
        return {number_of(h.start), number_of(h.edge), number_of(h.loop), is_lone ? 0 : number_of(h.next),
                is_lone ? 0 : number_of(h.prev)};
    }
    case TableKind::Edges: {
        const EdgeId e{index(kind, row)};
        return {number_of(solid_->plus(e)), number_of(solid_->minus(e)), before(kind, row), after(kind, row)};
    }
    case TableKind::Loops: return loop(LoopId{index(kind, row)});
    case TableKind::Faces: return face(FaceId{index(kind, row)}, row);
    case TableKind::Solids: break;
    }
    return solid();
}

/// Its neighbours are those of its face.
EntityRows::Numbers EntityRows::loop(LoopId l) const
{
    const std::vector<LoopId>& all = loops_of_[solid_->face(l).index];
    const auto at = std::lower_bound(all.begin(), all.end(), l);
    return {number_of(solid_->half_edge(l)), number_of(solid_->face(l)), at == all.begin() ? 0 : number_of(*(at - 1)),
            at + 1 == all.end() ? 0 : number_of(*(at + 1))};
}

EntityRows::Numbers EntityRows::face(FaceId f, std::size_t row) const
{
    const std::vector<LoopId>& all = loops_of_[f.index];
    const LoopId outer = solid_->outer(f);
    return {place_.number, is_bounding_[outer.index] ? number_of(outer) : 0, all.empty() ? 0 : number_of(all.front()),
            before(TableKind::Faces, row), after(TableKind::Faces, row)};
}

EntityRows::Numbers EntityRows::solid() const
{
    return {oldest(solid_->vertices()), oldest(solid_->faces()), oldest(solid_->edges()), place_.older, place_.newer};
}

TableRow EntityRows::operator()(TableKind kind, std::size_t row) const
{
    const Form& form = forms[static_cast<std::size_t>(kind)];
    TableRow made{.label = form.label, .number = number(kind, row)};
    made.entity = entity(form.kind, made.number);
    const Numbers cells = numbers(kind, row);
    for (std::size_t i = 0; i < form.columns.size(); ++i)
        made.cells.push_back({form.columns[i].label, cells[i], entity(form.columns[i].kind, cells[i])});
    return made;
}

EntityTables entity_tables(const Solid& solid, const SolidPlace& place)
{
    const EntityRows rows(solid, place);
    EntityTables made;
    for (std::size_t k = 0; k < n_table_kinds; ++k) {
        const auto kind = static_cast<TableKind>(k);
        for (std::size_t row = 0; row < rows.size(kind); ++row) made[kind].push_back(rows(kind, row));
    }
    return made;
}

} // namespace topology
