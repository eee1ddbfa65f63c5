#include "apps/euler/view/pick.h"

#include "apps/euler/view/shapes/outline.h"

#include <algorithm>
#include <limits>

namespace euler {

using topology::EntityKind;

namespace {

constexpr double vertex_reach = 11.0, arrow_reach = 7.0, edge_reach = 6.0; // [px]
constexpr double same = 2.5; // [px] by which of two the nearer to the pointer does not matter, but the one in front

double distance_to_line(ui::Point p, const std::vector<ui::Point>& line)
{
    double least = ui::distance(p, line.front());
    for (std::size_t i = 0; i + 1 < line.size(); ++i)
        least = std::min(least, distance_to_segment(p, line[i], line[i + 1]));
    return least;
}

double distance_to(const Shapes::Vertex& vertex, ui::Point p) { return ui::distance(vertex.at, p); }
double distance_to(const Shapes::Edge& edge, ui::Point p) { return distance_to_line(p, edge.line); }
double distance_to(const Shapes::Arrow& arrow, ui::Point p) { return distance_to_line(p, arrow.line); }

/// The nearest of a kind within reach, in front where several are.
template <class Shape> const Shape* nearest(const std::vector<Shape>& shapes, ui::Point p, double reach)
{
    const Shape* best = nullptr;
    double least = std::numeric_limits<double>::infinity();
    for (const Shape& shape : shapes) {
        const double distance = distance_to(shape, p);
        if (!(distance <= reach)) continue;
        const bool is_nearer = distance < least - same;
        const bool is_in_front = distance < least + same && best &&
                                 std::pair(!shape.is_hidden, shape.after) > std::pair(!best->is_hidden, best->after);
        const bool is_level = best && shape.is_hidden == best->is_hidden && shape.after == best->after;
        if (!best || is_nearer || is_in_front || (is_level && distance < least)) {
            best = &shape;
            least = distance;
        }
    }
    return best;
}

const Shapes::Face* face_at(const Shapes& shapes, ui::Point p)
{
    for (auto piece = shapes.pieces.rbegin(); piece != shapes.pieces.rend(); ++piece)
        if (bounds_of(piece->area).contains(p) && is_inside(piece->area, p)) return &shapes.faces[piece->face];
    return nullptr;
}

Part of_arrow(const Shapes::Arrow& arrow, std::span<const Subject> subjects, const PickRequest& request)
{
    const topology::Solid& solid = *subjects[arrow.subject].solid;
    const topology::LoopId loop = solid.loop(arrow.half_edge);
    if (request.kinds.contains(EntityKind::HalfEdge)) return {arrow.subject, arrow.half_edge};
    if (request.kinds.contains(EntityKind::Loop)) return {arrow.subject, loop};
    return {arrow.subject, solid.face(loop)};
}

} // namespace

std::optional<Part> pick(const Shapes& shapes, std::span<const Subject> subjects, const PickRequest& request)
{
    const auto means = [&](EntityKind kind) { return request.kinds.contains(kind); };
    if (means(EntityKind::Vertex))
        if (const auto* found = nearest(shapes.vertices, request.at, request.reach * vertex_reach))
            return Part{found->subject, found->vertex};
    const auto* arrow = nearest(shapes.arrows, request.at, request.reach * arrow_reach);
    const auto* edge = nearest(shapes.edges, request.at, request.reach * edge_reach);
    const bool is_edge_nearer = means(EntityKind::Edge) && edge && arrow &&
                                distance_to(*edge, request.at) < distance_to(*arrow, request.at);
    if (arrow && !is_edge_nearer && (means(EntityKind::HalfEdge) || means(EntityKind::Loop)))
        return of_arrow(*arrow, subjects, request);
    if (edge && means(EntityKind::Edge)) return Part{edge->subject, edge->edge};
    if (!means(EntityKind::Face)) return std::nullopt;
    if (const auto* face = face_at(shapes, request.at)) return Part{face->subject, face->face};
    return arrow ? std::optional(of_arrow(*arrow, subjects, request)) : std::nullopt;
}

namespace {

/// Where in its face the corner before a half-edge lies: between the head of the arrow before and its own tail.
ui::Point corner_place(const Shapes::Arrow& arrow, const std::vector<const Shapes::Arrow*>& here,
                       topology::HalfEdgeId prev)
{
    const auto before = std::find_if(here.begin(), here.end(),
                                     [&](const Shapes::Arrow* other) { return other->half_edge == prev; });
    return before == here.end() ? arrow.line.front() : 0.5 * ((*before)->line.back() + arrow.line.front());
}

} // namespace

std::optional<Part> pick_corner(const Shapes& shapes, std::span<const Subject> subjects, const PickRequest& request)
{
    constexpr double corner_reach = 3.0; // times that of a vertex
    const auto* vertex = nearest(shapes.vertices, request.at, corner_reach * request.reach * vertex_reach);
    if (!vertex) return std::nullopt;
    const topology::Solid& solid = *subjects[vertex->subject].solid;
    std::vector<const Shapes::Arrow*> here; // those that meet the vertex
    for (const Shapes::Arrow& arrow : shapes.arrows)
        if (arrow.subject == vertex->subject &&
            (solid.start(arrow.half_edge) == vertex->vertex || solid.end(arrow.half_edge) == vertex->vertex))
            here.push_back(&arrow);
    std::optional<Part> best;
    double least = std::numeric_limits<double>::infinity();
    for (const Shapes::Arrow* arrow : here) {
        if (solid.start(arrow->half_edge) != vertex->vertex) continue;
        const double away = ui::distance(corner_place(*arrow, here, solid.prev(arrow->half_edge)), request.at);
        if (away >= least) continue;
        least = away;
        best = Part{arrow->subject, arrow->half_edge};
    }
    return best;
}

} // namespace euler
