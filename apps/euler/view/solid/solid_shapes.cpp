#include "apps/euler/view/solid/solid_shapes.h"

#include "apps/euler/view/solid/arrow_line.h"
#include "apps/euler/view/solid/paint_order.h"
#include "apps/euler/view/solid/placed_solid.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

namespace euler {

using topology::EdgeId;
using topology::FaceId;
using topology::HalfEdgeId;
using topology::Point;
using topology::Solid;
using topology::Vector;
using topology::VertexId;

namespace {

std::vector<ui::Point> on_sheet(const std::vector<Point>& line, const Vector& shift, const ViewTransform& transform)
{
    std::vector<ui::Point> points;
    points.reserve(line.size());
    for (const Point& p : line) points.push_back(transform.to_sheet(p + shift));
    return points;
}

class SolidShapes {
public:
    SolidShapes(const PlacedSolids& solids, const ViewTransform& transform, const Look& look)
        : solids_(solids), transform_(transform), look_(look), symbol_(look.full_theme().symbol_scale())
    {
        for (const auto& solid : solids_) last_piece_.emplace_back(solid->solid.faces().n_rows(), 0);
    }

    Shapes take()
    {
        for (const auto& solid : solids_) add_faces(*solid);
        put_in_order();
        if (seen_.size() <= most_compared) cover_.emplace(seen_);
        for (const auto& solid : solids_) {
            add_edges(*solid);
            add_arrows(*solid);
            add_vertices(*solid);
        }
        return std::move(shapes_);
    }

private:
    void add_faces(const PlacedSolid& of)
    {
        for (const FaceBody& body : of.bodies.all()) {
            if (of.is_left_out(body.face)) continue;
            const std::size_t place = shapes_.faces.size();
            shapes_.faces.push_back({of.place, body.face, is_back(of, body.face), body.pieces.size() > 1});
            for (const auto& piece : body.pieces) add_piece(place, piece, body.shift);
        }
    }

    void add_piece(std::size_t face, const std::vector<std::vector<Point>>& rims, const Vector& shift)
    {
        SeenPiece seen;
        for (const std::vector<Point>& rim : rims) seen.area.push_back(on_sheet(rim, shift, transform_));
        if (shapes_.faces[face].is_bent) set_aslant(seen.area);
        const std::vector<Point>& outline = rims.front();
        const Vector normal = area_of(outline);
        seen.plane = depth_plane(outline.front() + shift, normal, transform_);
        seen.is_back = dot(normal, transform_.toward_eye()) < 0.0;
        seen.bounds = bounds_of(seen.area);
        for (const Point& p : outline) seen.nearness += transform_.scale() * transform_.nearness(p + shift);
        seen.nearness /= static_cast<double>(outline.size());
        seen_.push_back(std::move(seen));
        face_of_.push_back(face);
    }

    /// A surface moves level and upright sides onto its grid of pixels, which would open seams between triangles; a
    /// hundredth of a pixel keeps their sides aslant. It depends on the place alone, so that triangles still meet.
    static void set_aslant(Region& area)
    {
        for (std::vector<ui::Point>& loop : area)
            for (ui::Point& p : loop) p = p + 0.01 * ui::Point{std::sin(0.37 * p.y), std::sin(0.37 * p.x)};
    }

    static Vector area_of(const std::vector<Point>& outline)
    {
        Vector sum;
        for (std::size_t i = 1; i + 1 < outline.size(); ++i)
            sum = sum + cross(outline[i] - outline[0], outline[i + 1] - outline[0]);
        return sum;
    }

    void put_in_order()
    {
        for (const std::size_t i : back_to_front(seen_)) {
            const Shapes::Face& face = shapes_.faces[face_of_[i]];
            shapes_.pieces.push_back({face_of_[i], seen_[i].area, seen_[i].is_back});
            last_piece_[face.subject][face.face.index] = shapes_.pieces.size();
        }
    }

    /// After the faces on both its sides; after all where these have no area.
    std::size_t turn(const PlacedSolid& of, FaceId f, FaceId g) const
    {
        const std::size_t last = std::max(last_piece_[of.place][f.index], last_piece_[of.place][g.index]);
        return last != 0 ? last : shapes_.pieces.size();
    }

    bool is_behind(const Point& p, bool are_faces_back) const
    {
        if (!look_.faces) return false;
        if (!cover_) return are_faces_back;
        return cover_->is_covered(transform_.to_sheet(p), transform_.scale() * transform_.nearness(p));
    }

    bool is_back(const PlacedSolid& of, FaceId f) const
    {
        return dot(of.bodies[f].normal, transform_.toward_eye()) < 0.0;
    }

    /// Of very many parts that are too small to be told apart only some are there.
    bool is_dropped(const PlacedSolid& of, topology::Entity part, VertexId a, VertexId b) const
    {
        constexpr std::size_t most = 50'000;
        constexpr double smallest = 2.0; // [px]
        const std::size_t one_in = 1 + of.solid.edges().n_living() / most;
        return one_in > 1 && part.index % one_in != 0 && !of.marks.is_marked(part) &&
               ui::distance(transform_.to_sheet(of.positions[a]), transform_.to_sheet(of.positions[b])) < smallest;
    }

    void add_edges(const PlacedSolid& of)
    {
        const bool is_exploded = look_.explosion > 0.0;
        for (const EdgeId e : of.solid.edges()) {
            if (of.is_left_out(of.solid.face(of.solid.plus(e)))) continue;
            if (is_dropped(of, e, of.solid.start(of.solid.plus(e)), of.solid.start(of.solid.minus(e)))) continue;
            add_edge(of, e, of.solid.plus(e), is_exploded);
            if (is_exploded && of.solid.face(of.solid.plus(e)) != of.solid.face(of.solid.minus(e)))
                add_edge(of, e, of.solid.minus(e), is_exploded);
        }
    }

    void add_edge(const PlacedSolid& of, EdgeId e, HalfEdgeId h, bool is_alone)
    {
        const FaceId f = of.solid.face(h), g = is_alone ? f : of.solid.face(of.solid.mate(h));
        const Vector shift = of.bodies[f].shift;
        std::vector<Point> line = of.paths(of.solid.minus(e));
        const Point middle = line[line.size() / 2] + 0.5 * (line[(line.size() - 1) / 2] - line[line.size() / 2]);
        keep_share(line, grown(of, e));
        shapes_.edges.push_back({.subject = of.place,
                                 .edge = e,
                                 .line = on_sheet(line, shift, transform_),
                                 .is_hidden = is_behind(middle + shift, is_back(of, f) && is_back(of, g)),
                                 .after = turn(of, f, g)});
    }

    /// How much of an edge is there, where both its ends stand still.
    double grown(const PlacedSolid& of, EdgeId e) const
    {
        const HalfEdgeId h = of.solid.plus(e);
        const bool moves = of.marks.presence(of.solid.start(h)) < 1.0 || of.marks.presence(of.solid.end(h)) < 1.0;
        return moves ? 1.0 : of.marks.presence(e);
    }

    /// A half-edge's line grows as its edge does: the one that runs with it from its tail, the other from its head.
    static void grow(std::vector<Point>& line, double share, bool is_along)
    {
        if (!is_along) std::reverse(line.begin(), line.end());
        keep_share(line, share);
        if (!is_along) std::reverse(line.begin(), line.end());
    }

    void add_arrows(const PlacedSolid& of)
    {
        const ArrowLines lines(of.solid, of.paths, of.bodies, transform_, symbol_);
        for (const HalfEdgeId h : of.solid.half_edges()) {
            const FaceId f = of.solid.face(h);
            if (of.is_left_out(f)) continue;
            std::vector<Point> line = lines(h);
            if (line.empty()) continue;
            if (const auto e = of.solid.edge(h)) grow(line, grown(of, *e), h == of.solid.minus(*e));
            const Point middle = line[line.size() / 2];
            shapes_.arrows.push_back({.subject = of.place,
                                      .half_edge = h,
                                      .line = on_sheet(line, of.bodies[f].shift, transform_),
                                      .is_hidden = is_behind(middle + of.bodies[f].shift, is_back(of, f)),
                                      .after = turn(of, f, f)});
        }
    }

    void add_vertices(const PlacedSolid& of)
    {
        for (const VertexId v : of.solid.vertices()) {
            const HalfEdgeId h = of.solid.half_edge(v);
            if (of.is_left_out(of.solid.face(h))) continue;
            if (of.solid.edge(h) && is_dropped(of, v, v, of.solid.end(h))) continue;
            std::vector<FaceId> faces;
            for (const HalfEdgeId leaving : of.solid.fan(v)) faces.push_back(of.solid.face(leaving));
            if (look_.explosion <= 0.0) {
                add_vertex(of, v, faces);
                continue;
            }
            std::sort(faces.begin(), faces.end());
            faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
            for (const FaceId f : faces) add_vertex(of, v, {f});
        }
    }

    void add_vertex(const PlacedSolid& of, VertexId v, const std::vector<FaceId>& faces)
    {
        const Point at = of.positions[v] + of.bodies[faces.front()].shift;
        std::size_t after = 0;
        for (const FaceId f : faces) after = std::max(after, turn(of, f, f));
        const bool are_back = std::all_of(faces.begin(), faces.end(), [&](FaceId f) { return is_back(of, f); });
        shapes_.vertices.push_back({.subject = of.place,
                                    .vertex = v,
                                    .at = transform_.to_sheet(at),
                                    .is_hidden = is_behind(at, are_back),
                                    .after = after});
    }

    const PlacedSolids& solids_;
    const ViewTransform& transform_;
    const Look& look_;
    double symbol_;
    /// By solid and face: how many pieces are painted when it is done; 0 without area.
    std::vector<std::vector<std::size_t>> last_piece_;
    std::vector<SeenPiece> seen_;
    std::optional<CoverMap> cover_;    ///< none where there are too many pieces
    std::vector<std::size_t> face_of_; ///< by piece, in `shapes_.faces`
    Shapes shapes_;
};

} // namespace

Shapes shapes_of(const PlacedSolids& solids, const ViewTransform& transform, const Look& look)
{
    return SolidShapes(solids, transform, look).take();
}

Shapes solid_shapes(std::span<const Subject> subjects, const ui::OrbitCamera& camera, const Look& look)
{
    const ViewTransform transform(camera);
    return shapes_of(placed_in_space(subjects, transform, look.explosion), transform, look);
}

namespace {

/// Every vertex, in an exploded view once for each of its faces.
std::vector<ui::World3> places_of(std::span<const Subject> subjects, const ui::OrbitCamera& camera, const Look& look)
{
    std::vector<ui::World3> places;
    const auto add = [&](const Point& p) { places.push_back({p.x, p.y, p.z}); };
    if (look.explosion <= 0.0) {
        for (const Subject& subject : subjects)
            for (const VertexId v : subject.solid->vertices()) add(subject.solid->point(v));
        return places;
    }
    for (const auto& placed : placed_in_space(subjects, ViewTransform(camera), look.explosion))
        for (const VertexId v : placed->solid.vertices())
            for (const HalfEdgeId h : placed->solid.fan(v))
                add(placed->solid.point(v) + placed->bodies[placed->solid.face(h)].shift);
    return places;
}

} // namespace

ui::OrbitCamera fitted(ui::OrbitCamera camera, std::span<const Subject> subjects, const Look& look, ui::Size sheet)
{
    constexpr double margin = 70.0; // [px], for names and for closed edges
    camera.fit(places_of(subjects, camera, look), sheet, {margin, margin, margin, margin});
    return camera;
}

} // namespace euler
