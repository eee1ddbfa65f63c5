#include "topology/tables/winged_edge.h"

#include "topology/text/words.h"

namespace topology {

namespace {

class Winged {
public:
    Winged(const Solid& solid, std::optional<FaceId> outside) : solid_(solid), outside_(outside) {}

    WingedTables take() const
    {
        WingedTables made;
        for (const VertexId v : solid_.vertices())
            made.vertices.push_back({"v", v.index + std::size_t{1}, v, {edge_cell("eI", solid_.half_edge(v))}});
        for (const FaceId f : solid_.faces()) made.faces.push_back(face_row(f));
        for (const EdgeId e : solid_.edges()) made.edges.push_back(edge_row(e));
        return made;
    }

private:
    std::size_t number(FaceId f) const
    {
        if (outside_ == f) return 0;
        return f.index + (outside_ && outside_->index < f.index ? std::size_t{0} : std::size_t{1});
    }
    TableCell face_cell(std::string_view label, HalfEdgeId h) const
    {
        return {.label = label, .number = number(solid_.face(h)), .link = solid_.face(h)};
    }
    TableCell vertex_cell(std::string_view label, VertexId v) const
    {
        return {.label = label, .number = v.index + std::size_t{1}, .link = v};
    }
    TableCell edge_cell(std::string_view label, HalfEdgeId h) const
    {
        const auto e = solid_.edge(h);
        if (!e) return {.label = label};
        return {.label = label, .number = e->index + std::size_t{1}, .link = *e};
    }
    TableRow face_row(FaceId f) const
    {
        TableRow row{.label = "f", .number = number(f), .entity = f};
        for (const LoopId l : solid_.loops(f)) row.cells.push_back(edge_cell("eI", solid_.half_edge(l)));
        return row;
    }
    TableRow edge_row(EdgeId e) const
    {
        const HalfEdgeId left = solid_.plus(e), right = solid_.minus(e);
        return {"e",
                e.index + std::size_t{1},
                e,
                {vertex_cell("vI", solid_.start(left)), vertex_cell("vF", solid_.end(left)), face_cell("fL", left),
                 face_cell("fR", right), edge_cell("eLP", solid_.prev(left)), edge_cell("eLN", solid_.next(left)),
                 edge_cell("eRP", solid_.prev(right)), edge_cell("eRN", solid_.next(right))}};
    }

    const Solid& solid_;
    std::optional<FaceId> outside_;
};

std::string cells_text(const TableRow& row)
{
    std::string text;
    for (const TableCell& cell : row.cells) text += " " + std::to_string(cell.number);
    return text + "\n";
}

} // namespace

WingedTables winged_tables(const Solid& solid, std::optional<FaceId> outside) { return Winged(solid, outside).take(); }

std::string winged_text(const Solid& solid, std::optional<FaceId> outside)
{
    const WingedTables tables = winged_tables(solid, outside);
    std::string text = "v x y z eI\n";
    for (const TableRow& row : tables.vertices) {
        const Point& p = solid.point(VertexId{row.entity->index});
        text += std::to_string(row.number) + " " + written(p.x) + " " + written(p.y) + " " + written(p.z) +
                cells_text(row);
    }
    text += "f eI\n";
    for (const TableRow& row : tables.faces) text += std::to_string(row.number) + cells_text(row);
    text += "e vI vF fL fR eLP eLN eRP eRN\n";
    for (const TableRow& row : tables.edges) text += std::to_string(row.number) + cells_text(row);
    return text;
}

} // namespace topology
