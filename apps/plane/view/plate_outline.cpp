#include "apps/plane/view/plate_outline.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "femoop/plane/mesh/edge_table.h"
#include "femoop/plane/mesh/mesh_geometry.h"

namespace plane {

namespace {

namespace fp = femoop::plane;
using Eigen::Vector2d;
using femoop::NodeId;
using topology::HalfEdgeId;

constexpr int least_parts = 8, most_parts = 400; // of one piece that is curved

constexpr double straightness = 1e-9; // of the length of an element's side

Vector2d to_place(const topology::FlatPoint& p) { return {p.x, p.y}; }

/// Parts that a curve's chord strays from by no more than the tolerance: h^2 M / 8 for a second derivative M.
int n_parts(double bent, double range, double tolerance)
{
    const double n = std::ceil(std::abs(range) * std::sqrt(bent / (8.0 * tolerance)));
    return static_cast<int>(std::clamp<double>(n, least_parts, most_parts));
}

double twice_area(const PlaceLine& loop)
{
    double sum = 0.0;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const Vector2d a = loop[i] - loop.front(), b = loop[(i + 1) % loop.size()] - loop.front();
        sum += a.x() * b.y() - a.y() * b.x();
    }
    return sum;
}

bool encloses(const PlaceLine& loop, const Vector2d& p)
{
    bool is_inside = false;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const Vector2d &a = loop[i], &b = loop[(i + 1) % loop.size()];
        if ((a.y() > p.y()) == (b.y() > p.y())) continue;
        if (p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x())) is_inside = !is_inside;
    }
    return is_inside;
}

/// The outline of a drawing.
class DrawnOutline {
public:
    DrawnOutline(const discretize::Drawing& drawing, double tolerance)
        : drawing_(drawing),
          plane_(drawing.subdivision()),
          tolerance_(tolerance),
          is_material_(plane_.solid().faces().n_rows())
    {
        for (const discretize::DrawnFace& face : drawing.faces())
            is_material_[face.id.index] = face.region && !drawing.model()[*face.region].is_hole;
    }

    PlateOutline made()
    {
        list_faces();
        list_pieces();
        for (const topology::VertexId v : plane_.solid().vertices())
            outline_.vertices.push_back(to_place(plane_.at(v)));
        for (std::size_t i = 0; i < drawing_.model().points.size(); ++i)
            if (drawing_.vertex(NodeId(i))) outline_.points.emplace_back(i);
        return std::move(outline_);
    }

private:
    PlaceLine flattened(const topology::CurvePart& part, Vector2d from, Vector2d to) const
    {
        const topology::Curve& curve = plane_.curve(part.curve);
        const int n = curve.is_straight()
                          ? 1
                          : n_parts(curve.most_bent(part.span), part.span.to - part.span.from, tolerance_);
        PlaceLine line{from};
        for (int i = 1; i < n; ++i) line.push_back(to_place(curve.at(part.span.at(static_cast<double>(i) / n))));
        line.push_back(to);
        return line;
    }

    Vector2d start(HalfEdgeId h) const { return to_place(plane_.at(plane_.solid().start(h))); }
    Vector2d end(HalfEdgeId h) const { return to_place(plane_.at(plane_.solid().end(h))); }

    PlaceLine loop_of(topology::LoopId l) const
    {
        PlaceLine loop;
        for (const HalfEdgeId h : plane_.solid().chain(l)) {
            const auto edge = plane_.solid().edge(h);
            if (!edge) continue;
            const PlaceLine line = flattened({plane_.part(*edge).curve, plane_.span(h)}, start(h), end(h));
            loop.insert(loop.end(), line.begin(), line.end() - 1);
        }
        return loop;
    }

    void list_faces()
    {
        for (const discretize::DrawnFace& face : drawing_.faces()) {
            OutlinedFace drawn{.region = face.region,
                               .is_hole = face.region && drawing_.model()[*face.region].is_hole,
                               .loops = {},
                               .inside = to_place(face.inside)};
            for (const topology::LoopId l : plane_.solid().loops(face.id))
                if (PlaceLine loop = loop_of(l); loop.size() >= 2) drawn.loops.push_back(std::move(loop));
            outline_.faces.push_back(std::move(drawn));
        }
    }

    bool is_material(HalfEdgeId h) const { return is_material_[plane_.solid().face(h).index]; }

    struct Carried {
        topology::CurvePart part;
        topology::EdgeId edge;
        double first; ///< the part's least parameter
    };

    void list_pieces()
    {
        std::vector<Carried> all;
        for (const topology::EdgeId e : plane_.solid().edges())
            for (const topology::CurvePart& part : plane_.carriers(e))
                all.push_back({part, e, std::min(part.span.from, part.span.to)});
        std::ranges::sort(all, [](const Carried& a, const Carried& b) {
            return std::tie(a.part.curve, a.first) < std::tie(b.part.curve, b.first);
        });
        for (const Carried& carried : all) add_piece(carried);
    }

    void add_piece(const Carried& carried)
    {
        const HalfEdgeId plus = plane_.solid().plus(carried.edge), minus = plane_.solid().minus(carried.edge);
        const bool is_along = carried.part.span.from < carried.part.span.to;
        const HalfEdgeId h = is_along ? plus : minus, mate = is_along ? minus : plus;
        const topology::CurvePart part{carried.part.curve,
                                       is_along ? carried.part.span
                                                : topology::Span{carried.part.span.to, carried.part.span.from}};
        outline_.pieces.push_back({.curve = drawing_.owner(part.curve),
                                   .line = flattened(part, start(h), end(h)),
                                   .has_left_material = is_material(h),
                                   .has_right_material = is_material(mate),
                                   .dangles = plane_.solid().face(h) == plane_.solid().face(mate)});
    }

    const discretize::Drawing& drawing_;
    const topology::PlanarSubdivision& plane_;
    double tolerance_;
    std::vector<bool> is_material_; ///< by face of the solid
    PlateOutline outline_;
};

/// The outline of a mesh: regions end where an element has no neighbour of its own region.
class MeshOutline {
public:
    MeshOutline(const fp::PlaneModel& mesh, const PlaceLine& places, double tolerance)
        : mesh_(mesh), places_(places), edges_(mesh), tolerance_(tolerance)
    {}

    PlateOutline made()
    {
        list_faces();
        list_pieces();
        for (const OutlinedPiece& piece : outline_.pieces) {
            add_vertex(piece.line.front());
            add_vertex(piece.line.back());
        }
        for (std::size_t i = 0; i < mesh_.points.size(); ++i) outline_.points.emplace_back(i);
        return std::move(outline_);
    }

private:
    using Ends = std::pair<std::size_t, std::size_t>;

    PlaceLine flattened(NodeId from, std::optional<NodeId> middle, NodeId to) const
    {
        return flattened_side(places_[from.index], middle ? std::optional(places_[middle->index]) : std::nullopt,
                              places_[to.index], tolerance_);
    }

    struct Border {
        NodeId from, to;
        std::optional<NodeId> middle;
        bool is_free = false; ///< no element at all on its other side
        bool is_used = false;
    };

    std::vector<Border> borders_of(fp::RegionId region) const
    {
        std::vector<Border> borders;
        for (const fp::PlaneElement& element : mesh_.elements) {
            if (element.region != region || !fp::has_points(mesh_, element)) continue;
            for (const femoop::Shape::Edge& edge : femoop::shape_of(element.kind).edges()) {
                const auto point = [&](std::size_t i) { return element.points[static_cast<std::size_t>(edge[i])]; };
                const auto other = edges_.find(point(1), point(0));
                if (other && mesh_[other->element].region == region) continue;
                borders.push_back({.from = point(0),
                                   .to = point(1),
                                   .middle = edge.size() > 2 ? std::optional(point(2)) : std::nullopt,
                                   .is_free = !other});
            }
        }
        return borders;
    }

    std::vector<PlaceLine> loops_of(std::vector<Border>& borders) const
    {
        std::multimap<std::size_t, std::size_t> starts;
        for (std::size_t i = 0; i < borders.size(); ++i) starts.emplace(borders[i].from.index, i);
        std::vector<PlaceLine> loops;
        for (std::size_t first = 0; first < borders.size(); ++first) {
            PlaceLine loop;
            for (std::optional<std::size_t> i = first; i && !borders[*i].is_used;) {
                borders[*i].is_used = true;
                const PlaceLine line = flattened(borders[*i].from, borders[*i].middle, borders[*i].to);
                loop.insert(loop.end(), line.begin(), line.end() - 1);
                const auto [low, high] = starts.equal_range(borders[*i].to.index);
                const auto next = std::find_if(low, high, [&](const auto& s) { return !borders[s.second].is_used; });
                i = next == high ? std::nullopt : std::optional(next->second);
            }
            if (loop.size() > 2) loops.push_back(std::move(loop));
        }
        return loops;
    }

    void list_faces()
    {
        for (std::size_t r = 0; r < mesh_.regions.size(); ++r) {
            const fp::RegionId region(r);
            std::vector<Border> borders = borders_of(region);
            const std::vector<PlaceLine> loops = loops_of(borders);
            const std::size_t first = outline_.faces.size();
            for (const PlaceLine& loop : loops)
                if (twice_area(loop) > 0.0)
                    outline_.faces.push_back({.region = region, .is_hole = false, .loops = {loop}, .inside = {}});
            for (const PlaceLine& loop : loops)
                if (twice_area(loop) <= 0.0) add_hole(loop, first);
            for (std::size_t i = first; i < outline_.faces.size(); ++i)
                outline_.faces[i].inside = inside_of(outline_.faces[i]);
            for (const Border& border : borders)
                if (border.is_free) free_.emplace(Ends{border.from.index, border.to.index}, border);
                else if (const Ends back{border.to.index, border.from.index}; !shared_.contains(back))
                    shared_.emplace(Ends{border.from.index, border.to.index}, border);
        }
    }

    void add_hole(const PlaceLine& loop, std::size_t first)
    {
        for (std::size_t i = first; i < outline_.faces.size(); ++i)
            if (encloses(outline_.faces[i].loops.front(), 0.5 * (loop[0] + loop[1])))
                return outline_.faces[i].loops.push_back(loop);
    }

    /// The middle of the element that lies farthest from the face's lines, of some hundred that are looked at.
    Vector2d inside_of(const OutlinedFace& face) const
    {
        const std::size_t step = 1 + mesh_.elements.size() / 200;
        Vector2d best = face.loops.front().front();
        double most = -1.0;
        for (std::size_t e = 0; e < mesh_.elements.size(); e += step) {
            const fp::PlaneElement& element = mesh_.elements[e];
            if (element.region != *face.region || !fp::has_points(mesh_, element)) continue;
            Vector2d middle = Vector2d::Zero();
            for (const NodeId node : element.points)
                middle += places_[node.index] / static_cast<double>(element.points.size());
            if (!encloses(face.loops.front(), middle)) continue;
            double nearest = std::numeric_limits<double>::infinity();
            for (const PlaceLine& loop : face.loops)
                for (const Vector2d& p : loop) nearest = std::min(nearest, (p - middle).norm());
            if (nearest > most) {
                most = nearest;
                best = middle;
            }
        }
        return best;
    }

    /// Curves, and borders that no curve names.
    void list_pieces()
    {
        std::map<Ends, bool> named;
        for (std::size_t c = 0; c < mesh_.curves.size(); ++c)
            for (const fp::CurveEdge& edge : fp::edges_along(mesh_, edges_, mesh_.curves[c]).edges) {
                named[{edge.start.index, edge.end.index}] = named[{edge.end.index, edge.start.index}] = true;
                outline_.pieces.push_back({.curve = fp::CurveId(c),
                                           .line = flattened(edge.start, edge.middle, edge.end),
                                           .has_left_material = edge.left.has_value(),
                                           .has_right_material = edge.right.has_value()});
            }
        for (const auto* borders : {&free_, &shared_})
            for (const auto& [ends, border] : *borders)
                if (!named.contains(ends))
                    outline_.pieces.push_back({.curve = {},
                                               .line = flattened(border.from, border.middle, border.to),
                                               .has_left_material = true,
                                               .has_right_material = !border.is_free});
    }

    void add_vertex(const Vector2d& at)
    {
        if (is_vertex_.emplace(std::pair(at.x(), at.y()), true).second) outline_.vertices.push_back(at);
    }

    const fp::PlaneModel& mesh_;
    const PlaceLine& places_;
    fp::EdgeTable edges_;
    double tolerance_;
    std::map<Ends, Border> free_, shared_;
    std::map<std::pair<double, double>, bool> is_vertex_;
    PlateOutline outline_;
};

bool follows(const CurvePath& path, const OutlinedPiece& piece)
{
    return path.has_left_material == piece.has_left_material && path.has_right_material == piece.has_right_material &&
           path.line.back() == piece.line.front();
}

} // namespace

PlateOutline outline_of(const discretize::Drawing& drawing, double tolerance)
{
    return DrawnOutline(drawing, tolerance).made();
}

PlateOutline outline_of(const fp::PlaneModel& mesh, double tolerance)
{
    return outline_of(mesh, fp::positions(mesh), tolerance);
}

PlateOutline outline_of(const fp::PlaneModel& mesh, const PlaceLine& places, double tolerance)
{
    return MeshOutline(mesh, places, tolerance).made();
}

PlaceLine flattened_side(const Vector2d& a, const std::optional<Vector2d>& middle, const Vector2d& b, double tolerance)
{
    if (!middle) return {a, b};
    const Vector2d& m = *middle;
    const double bent = (a - 2.0 * m + b).norm();
    if (bent <= straightness * (b - a).norm()) return {a, b};
    const int n = n_parts(bent, 2.0, tolerance);
    PlaceLine line;
    for (int i = 0; i <= n; ++i) {
        const double xi = 2.0 * i / n - 1.0;
        line.emplace_back(0.5 * xi * (xi - 1.0) * a + (1.0 - xi * xi) * m + 0.5 * xi * (xi + 1.0) * b);
    }
    return line;
}

CurvePath::Place CurvePath::at(double place) const
{
    const auto last = static_cast<std::ptrdiff_t>(s.size()) - 1;
    const auto i = static_cast<std::size_t>(
        std::clamp<std::ptrdiff_t>(std::ranges::lower_bound(s, place) - s.begin(), 1, last));
    const double part = s[i] - s[i - 1], t = part > 0.0 ? std::clamp((place - s[i - 1]) / part, 0.0, 1.0) : 0.0;
    return {line[i - 1] + t * (line[i] - line[i - 1]), i - 1};
}

Vector2d CurvePath::outward(std::size_t part) const
{
    const Vector2d along = (line[part + 1] - line[part]).normalized(), left(-along.y(), along.x());
    return has_left_material && !has_right_material ? Vector2d(-left) : left;
}

std::vector<CurvePath> paths_of(const PlateOutline& outline, fp::CurveId curve)
{
    std::vector<CurvePath> paths;
    double s = 0.0;
    for (const OutlinedPiece& piece : outline.pieces) {
        if (piece.curve != curve) continue;
        if (paths.empty() || !follows(paths.back(), piece))
            paths.push_back({.line = {piece.line.front()},
                             .s = {s},
                             .has_left_material = piece.has_left_material,
                             .has_right_material = piece.has_right_material});
        for (std::size_t i = 1; i < piece.line.size(); ++i) {
            s += (piece.line[i] - piece.line[i - 1]).norm();
            paths.back().line.push_back(piece.line[i]);
            paths.back().s.push_back(s);
        }
    }
    for (CurvePath& path : paths) path.length = s;
    return paths;
}

PlateOutline joined(PlateOutline outline)
{
    std::vector<OutlinedPiece> pieces;
    for (OutlinedPiece& piece : outline.pieces) {
        const auto goes_on = [&](const OutlinedPiece& before) {
            return before.curve == piece.curve && before.has_left_material == piece.has_left_material &&
                   before.has_right_material == piece.has_right_material && before.dangles == piece.dangles &&
                   before.line.back() == piece.line.front();
        };
        if (pieces.empty() || !goes_on(pieces.back())) pieces.push_back(std::move(piece));
        else pieces.back().line.insert(pieces.back().line.end(), piece.line.begin() + 1, piece.line.end());
    }
    outline.pieces = std::move(pieces);
    return outline;
}

} // namespace plane
