#include "topology/tables/winged_edge.h"

#include <algorithm>

#include "topology/text/words.h"

namespace topology {

namespace {

template <class Id, class Table> std::vector<Id> living(const Table& table)
{
    std::vector<Id> rows;
    rows.reserve(table.n_living());
    for (const Id id : table) rows.push_back(id);
    return rows;
}

TableCell vertex_cell(std::string_view label, VertexId v)
{
    return {.label = label, .number = v.index + std::size_t{1}, .link = v};
}

std::string cells_text(const TableRow& row)
{
    std::string text;
    for (const TableCell& cell : row.cells) text += " " + std::to_string(cell.number);
    return text + "\n";
}

} // namespace

WingedTables::WingedTables(const Solid& solid, std::optional<FaceId> outside)
    : solid_(&solid),
      outside_(outside),
      vertices_(living<VertexId>(solid.vertices())),
      faces_(living<FaceId>(solid.faces())),
      edges_(living<EdgeId>(solid.edges()))
{
    for (const FaceId f : faces_) {
        std::size_t n = 0;
        for ([[maybe_unused]] const LoopId l : solid.loops(f)) ++n;
        most_loops_ = std::max(most_loops_, n);
    }
}

std::size_t WingedTables::number(FaceId f) const
{
    if (outside_ == f) return 0;
    return f.index + (outside_ && outside_->index < f.index ? std::size_t{0} : std::size_t{1});
}

TableCell WingedTables::face_cell(std::string_view label, HalfEdgeId h) const
{
    return {.label = label, .number = number(solid_->face(h)), .link = solid_->face(h)};
}

TableCell WingedTables::edge_cell(std::string_view label, HalfEdgeId h) const
{
    const auto e = solid_->edge(h);
    if (!e) return {.label = label};
    return {.label = label, .number = e->index + std::size_t{1}, .link = *e};
}

TableRow WingedTables::vertex(std::size_t row) const
{
    const VertexId v = vertices_[row];
    return {"v", v.index + std::size_t{1}, v, {edge_cell("eI", solid_->half_edge(v))}};
}

TableRow WingedTables::face(std::size_t row) const
{
    const FaceId f = faces_[row];
    TableRow made{.label = "f", .number = number(f), .entity = f};
    for (const LoopId l : solid_->loops(f)) made.cells.push_back(edge_cell("eI", solid_->half_edge(l)));
    return made;
}

TableRow WingedTables::edge(std::size_t row) const
{
    const EdgeId e = edges_[row];
    const HalfEdgeId left = solid_->plus(e), right = solid_->minus(e);
    return {"e",
            e.index + std::size_t{1},
            e,
            {vertex_cell("vI", solid_->start(left)), vertex_cell("vF", solid_->end(left)), face_cell("fL", left),
             face_cell("fR", right), edge_cell("eLP", solid_->prev(left)), edge_cell("eLN", solid_->next(left)),
             edge_cell("eRP", solid_->prev(right)), edge_cell("eRN", solid_->next(right))}};
}

std::string winged_text(const Solid& solid, std::optional<FaceId> outside)
{
    const WingedTables tables(solid, outside);
    std::string text = "v x y z eI\n";
    for (std::size_t i = 0; i < tables.n_vertices(); ++i) {
        const TableRow row = tables.vertex(i);
        const Point& p = solid.point(VertexId{row.entity->index});
        text += std::to_string(row.number) + " " + written(p.x) + " " + written(p.y) + " " + written(p.z) +
                cells_text(row);
    }
    text += "f eI\n";
    for (std::size_t i = 0; i < tables.n_faces(); ++i)
        text += std::to_string(tables.face(i).number) + cells_text(tables.face(i));
    text += "e vI vF fL fR eLP eLN eRP eRN\n";
    for (std::size_t i = 0; i < tables.n_edges(); ++i)
        text += std::to_string(tables.edge(i).number) + cells_text(tables.edge(i));
    return text;
}

} // namespace topology
