#include "apps/euler/view/solid/solid_shapes.h"

#include "apps/euler/view/shapes/outline.h"
#include "apps/euler/view/solid/arrow_line.h"
#include "apps/euler/view/solid/face_body.h"
#include "apps/euler/view/solid/paint_order.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>

namespace euler {

using topology::EdgeId;
using topology::FaceId;
using topology::HalfEdgeId;
using topology::Point;
using topology::Solid;
using topology::Vector;
using topology::VertexId;

namespace {

std::vector<ui::Point> on_sheet(const std::vector<Point>& line, const Vector& shift, const Sight& sight)
{
    std::vector<ui::Point> points;
    points.reserve(line.size());
    for (const Point& p : line) points.push_back(sight.to_sheet(p + shift));
    return points;
}

/// A solid with everything that its picture is made from.
struct Built {
    Built(std::size_t number, const Subject& subject, const Sight& sight, double explosion)
        : place(number),
          solid(*subject.solid),
          marks(solid, subject.marks),
          stations(solid, marks, sight),
          paths(solid, stations, sight),
          bodies(solid, stations, paths, sight),
          last_piece(solid.faces().n_rows(), 0)
    {
        bodies.explode(solid, explosion, stations.extent());
    }
    Built(const Built&) = delete;
    Built& operator=(const Built&) = delete;

    std::size_t place; ///< among the subjects
    const Solid& solid;
    MarkTable marks;
    Stations stations;
    HalfEdgePaths paths;
    FaceBodies bodies;
    std::vector<std::size_t> last_piece; ///< by face: how many pieces are painted when it is done; 0 without area
};

class SolidShapes {
public:
    SolidShapes(std::span<const Subject> subjects, const Sight& sight, const Look& look)
        : sight_(sight), look_(look), symbol_(look.full_theme().symbol_scale())
    {
        for (std::size_t i = 0; i < subjects.size(); ++i)
            built_.push_back(std::make_unique<Built>(i, subjects[i], sight, look.explosion));
    }

    Shapes shapes()
    {
        for (const auto& built : built_) add_faces(*built);
        put_in_order();
        for (const auto& built : built_) {
            add_edges(*built);
            add_arrows(*built);
            add_vertices(*built);
        }
        return std::move(shapes_);
    }

private:
    void add_faces(const Built& of)
    {
        for (const FaceBody& body : of.bodies.all()) {
            const std::size_t place = shapes_.faces.size();
            shapes_.faces.push_back({of.place, body.face, is_back(of, body.face)});
            for (const auto& piece : body.pieces) add_piece(place, piece, body.shift);
        }
    }

    void add_piece(std::size_t face, const std::vector<Point>& piece, const Vector& shift)
    {
        SeenPiece seen{.outline = on_sheet(piece, shift, sight_)};
        const Vector normal = area_of(piece);
        seen.plane = depth_plane(piece.front() + shift, normal, sight_);
        seen.is_back = dot(normal, sight_.toward_eye()) < 0.0;
        seen.bounds = bounds_of(seen.outline);
        for (const Point& p : piece) seen.nearness += sight_.scale() * sight_.nearness(p + shift);
        seen.nearness /= static_cast<double>(piece.size());
        seen_.push_back(std::move(seen));
        face_of_.push_back(face);
    }

    static Vector area_of(const std::vector<Point>& piece)
    {
        Vector sum;
        for (std::size_t i = 1; i + 1 < piece.size(); ++i)
            sum = sum + cross(piece[i] - piece[0], piece[i + 1] - piece[0]);
        return sum;
    }

    void put_in_order()
    {
        for (const std::size_t i : back_to_front(seen_)) {
            const Shapes::Face& face = shapes_.faces[face_of_[i]];
            shapes_.pieces.push_back({face_of_[i], seen_[i].outline, seen_[i].is_back});
            built_[face.subject]->last_piece[face.face.index] = shapes_.pieces.size();
        }
    }

    /// After the faces on both its sides; after all where these have no area.
    std::size_t turn(const Built& of, FaceId f, FaceId g) const
    {
        const std::size_t last = std::max(of.last_piece[f.index], of.last_piece[g.index]);
        return last != 0 ? last : shapes_.pieces.size();
    }

    bool is_behind(const Point& p, bool are_faces_back) const
    {
        if (!look_.faces) return false;
        if (seen_.size() > most_compared) return are_faces_back;
        return is_covered(seen_, sight_.to_sheet(p), sight_.scale() * sight_.nearness(p));
    }

    bool is_back(const Built& of, FaceId f) const { return dot(of.bodies[f].normal, sight_.toward_eye()) < 0.0; }

    void add_edges(const Built& of)
    {
        const bool is_exploded = look_.explosion > 0.0;
        for (const EdgeId e : of.solid.edges()) {
            add_edge(of, e, of.solid.plus(e), is_exploded);
            if (is_exploded && of.solid.face(of.solid.plus(e)) != of.solid.face(of.solid.minus(e)))
                add_edge(of, e, of.solid.minus(e), is_exploded);
        }
    }

    void add_edge(const Built& of, EdgeId e, HalfEdgeId h, bool is_alone)
    {
        const FaceId f = of.solid.face(h), g = is_alone ? f : of.solid.face(of.solid.mate(h));
        const Vector shift = of.bodies[f].shift;
        std::vector<Point> line = of.paths(of.solid.minus(e));
        const Point middle = line[line.size() / 2] + 0.5 * (line[(line.size() - 1) / 2] - line[line.size() / 2]);
        keep_share(line, grown(of, e));
        shapes_.edges.push_back({.subject = of.place,
                                 .edge = e,
                                 .line = on_sheet(line, shift, sight_),
                                 .is_hidden = is_behind(middle + shift, is_back(of, f) && is_back(of, g)),
                                 .after = turn(of, f, g)});
    }

    /// How much of an edge is there, where both its ends stand still.
    double grown(const Built& of, EdgeId e) const
    {
        const HalfEdgeId h = of.solid.plus(e);
        const bool moves = of.marks.presence(of.solid.start(h)) < 1.0 || of.marks.presence(of.solid.end(h)) < 1.0;
        return moves ? 1.0 : of.marks.presence(e);
    }

    void add_arrows(const Built& of)
    {
        const ArrowLines lines(of.solid, of.paths, of.bodies, sight_, symbol_);
        for (const HalfEdgeId h : of.solid.half_edges()) {
            const FaceId f = of.solid.face(h);
            std::vector<Point> line = lines(h);
            if (line.empty()) continue;
            if (const auto e = of.solid.edge(h)) keep_share(line, grown(of, *e));
            const Point middle = line[line.size() / 2];
            shapes_.arrows.push_back({.subject = of.place,
                                      .half_edge = h,
                                      .line = on_sheet(line, of.bodies[f].shift, sight_),
                                      .is_hidden = is_behind(middle + of.bodies[f].shift, is_back(of, f)),
                                      .after = turn(of, f, f)});
        }
    }

    void add_vertices(const Built& of)
    {
        for (const VertexId v : of.solid.vertices()) {
            std::vector<FaceId> faces;
            for (const HalfEdgeId h : of.solid.fan(v)) faces.push_back(of.solid.face(h));
            if (look_.explosion <= 0.0) {
                add_vertex(of, v, faces);
                continue;
            }
            std::sort(faces.begin(), faces.end());
            faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
            for (const FaceId f : faces) add_vertex(of, v, {f});
        }
    }

    void add_vertex(const Built& of, VertexId v, const std::vector<FaceId>& faces)
    {
        const Point at = of.stations[v] + of.bodies[faces.front()].shift;
        std::size_t after = 0;
        for (const FaceId f : faces) after = std::max(after, turn(of, f, f));
        const bool are_back = std::all_of(faces.begin(), faces.end(), [&](FaceId f) { return is_back(of, f); });
        shapes_.vertices.push_back({.subject = of.place,
                                    .vertex = v,
                                    .at = sight_.to_sheet(at),
                                    .is_hidden = is_behind(at, are_back),
                                    .after = after});
    }

    const Sight& sight_;
    const Look& look_;
    double symbol_;
    std::vector<std::unique_ptr<Built>> built_; // which refer to one another inside
    std::vector<SeenPiece> seen_;
    std::vector<std::size_t> face_of_; ///< by piece, in `shapes_.faces`
    Shapes shapes_;
};

} // namespace

Shapes solid_shapes(std::span<const Subject> subjects, const ui::OrbitCamera& camera, const Look& look)
{
    const Sight sight(camera);
    return SolidShapes(subjects, sight, look).shapes();
}

ui::OrbitCamera fitted(ui::OrbitCamera camera, std::span<const Subject> subjects, const Look& look, ui::Size sheet)
{
    constexpr double margin = 70.0; // [px], for names and for closed edges
    std::vector<ui::World3> places;
    const Sight sight(camera);
    for (std::size_t i = 0; i < subjects.size(); ++i) {
        const Built built(i, subjects[i], sight, look.explosion);
        for (const VertexId v : built.solid.vertices())
            for (const HalfEdgeId h : built.solid.fan(v)) {
                const Point p = built.solid.point(v) + built.bodies[built.solid.face(h)].shift;
                places.push_back({p.x, p.y, p.z});
            }
    }
    camera.fit(places, sheet, {margin, margin, margin, margin});
    return camera;
}

} // namespace euler
