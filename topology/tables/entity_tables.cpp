#include "topology/tables/entity_tables.h"

#include <algorithm>
#include <utility>

namespace topology {

namespace {

template <class Id> std::size_t number(Id id) { return std::size_t{id.index} + 1; }

template <class Id> TableCell cell(std::string_view label, Id id)
{
    if (id == nothing<Id>) return {.label = label};
    return {.label = label, .number = number(id), .link = Entity(id)};
}

template <class Table> auto oldest(const Table& table)
{
    using Id = decltype(table.last());
    return table.n_living() == 0 ? nothing<Id> : *table.begin();
}

/// Gives every row N and P, its neighbours in the list.
void chain(std::vector<TableRow>& rows)
{
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const auto beside = [&](std::string_view label, std::size_t j) {
            return j < rows.size() ? TableCell{.label = label, .number = rows[j].number, .link = rows[j].entity}
                                   : TableCell{.label = label};
        };
        rows[i].cells.push_back(beside("N", i - 1)); // of the first it is beyond the end
        rows[i].cells.push_back(beside("P", i + 1));
    }
}

class Maker {
public:
    Maker(const Solid& solid, const SolidPlace& place)
        : solid_(solid), place_(place), loops_of_(solid.faces().n_rows()), is_bounding_(solid.loops().n_rows(), false)
    {
        for (const LoopId l : solid.loops()) loops_of_[solid.face(l).index].push_back(l);
        for (const HalfEdgeId h : solid.half_edges())
            if (solid.loop(other_half(h)) != solid.loop(h)) is_bounding_[solid.loop(h).index] = true;
    }

    EntityTables take()
    {
        for (const VertexId v : solid_.vertices()) add(TableKind::Vertices, "V", v, {cell("H", solid_.half_edge(v))});
        for (const HalfEdgeId h : solid_.half_edges()) half_edge(h);
        for (const EdgeId e : solid_.edges())
            add(TableKind::Edges, "E", e, {cell("H1", solid_.plus(e)), cell("H2", solid_.minus(e))});
        if (solid_.edges().n_living() == 0)
            made_[TableKind::Edges].push_back({.label = "E", .cells = {{.label = "H1"}, {.label = "H2"}}});
        for (const LoopId l : solid_.loops()) loop(l);
        for (const FaceId f : solid_.faces()) face(f);
        for (const TableKind kind : {TableKind::Vertices, TableKind::Edges, TableKind::Faces}) chain(made_[kind]);
        solid();
        return std::move(made_);
    }

private:
    template <class Id> void add(TableKind kind, std::string_view label, Id id, std::vector<TableCell> cells)
    {
        made_[kind].push_back({.label = label, .number = number(id), .entity = Entity(id), .cells = std::move(cells)});
    }
    void half_edge(HalfEdgeId i)
    {
        const HalfEdge& h = solid_.half_edges()[i];
        const bool is_lone = !solid_.edge(i);
        add(TableKind::HalfEdges, "H", i,
            {cell("V", h.start), cell("E", h.edge), cell("L", h.loop),
             cell("N", is_lone ? nothing<HalfEdgeId> : h.next), cell("P", is_lone ? nothing<HalfEdgeId> : h.prev)});
    }
    void loop(LoopId l)
    {
        const std::vector<LoopId>& all = loops_of_[solid_.face(l).index];
        const auto at = std::find(all.begin(), all.end(), l);
        add(TableKind::Loops, "L", l,
            {cell("H", solid_.half_edge(l)), cell("F", solid_.face(l)),
             cell("N", at == all.begin() ? nothing<LoopId> : *(at - 1)),
             cell("P", at + 1 == all.end() ? nothing<LoopId> : *(at + 1))});
    }
    void face(FaceId f)
    {
        const std::vector<LoopId>& all = loops_of_[f.index];
        add(TableKind::Faces, "F", f,
            {{.label = "S", .number = place_.number},
             cell("LOUT", is_bounding_[solid_.outer(f).index] ? solid_.outer(f) : nothing<LoopId>),
             cell("LOOPS", all.empty() ? nothing<LoopId> : all.front())});
    }
    /// As the edge has it, not as a mate would be found in a sound solid.
    HalfEdgeId other_half(HalfEdgeId h) const
    {
        const auto e = solid_.edge(h);
        if (!e) return h;
        return solid_.plus(*e) == h ? solid_.minus(*e) : solid_.plus(*e);
    }
    void solid()
    {
        made_[TableKind::Solids].push_back({.label = "S",
                                            .number = place_.number,
                                            .cells = {cell("V", oldest(solid_.vertices())),
                                                      cell("F", oldest(solid_.faces())),
                                                      cell("E", oldest(solid_.edges())),
                                                      {.label = "N", .number = place_.older},
                                                      {.label = "P", .number = place_.newer}}});
    }

    const Solid& solid_;
    SolidPlace place_;
    std::vector<std::vector<LoopId>> loops_of_; ///< by face, oldest first
    std::vector<bool> is_bounding_;             ///< by loop: does another loop lie beyond some edge of it?
    EntityTables made_;
};

} // namespace

SolidPlace place_among_living(const ScriptRunner& runner, std::size_t solid)
{
    SolidPlace place{.number = solid + 1};
    for (std::size_t i = 0; i < runner.solids().size(); ++i) {
        if (!runner.solids()[i].is_alive()) continue;
        if (i < solid) place.older = i + 1;
        if (i > solid && place.newer == 0) place.newer = i + 1;
    }
    return place;
}

EntityTables entity_tables(const Solid& solid, const SolidPlace& place) { return Maker(solid, place).take(); }

} // namespace topology
