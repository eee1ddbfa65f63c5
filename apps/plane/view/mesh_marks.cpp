#include "apps/plane/view/mesh_marks.h"

#include <algorithm>
#include <cmath>

#include "apps/drawing/results/solved_case.h"
#include "apps/plane/view/geometry_marks.h"
#include "femoop/plane/mesh/edge_table.h"
#include "femoop/plane/mesh/mesh_geometry.h"

namespace plane {

namespace {

namespace fp = femoop::plane;
using Eigen::Vector2d;
using femoop::NodeId;
using ui::Role;

constexpr double share_of_body = 0.1;  // that the largest displacement takes
constexpr double side_flatness = 0.05; // [px]

struct Side {
    NodeId from, to;
    std::optional<NodeId> middle;
};

/// Every side once.
std::vector<Side> sides_of(const fp::PlaneModel& mesh)
{
    std::vector<Side> sides;
    for (const fp::PlaneElement& element : mesh.elements) {
        if (!fp::has_points(mesh, element)) continue;
        for (const femoop::Shape::Edge& edge : femoop::shape_of(element.kind).edges()) {
            Side side{element.points[static_cast<std::size_t>(edge[0])],
                      element.points[static_cast<std::size_t>(edge[1])],
                      {}};
            if (edge.size() > 2) side.middle = element.points[static_cast<std::size_t>(edge[2])];
            if (side.to < side.from) std::swap(side.from, side.to);
            sides.push_back(side);
        }
    }
    const auto ends = [](const Side& s) { return std::pair(s.from, s.to); };
    std::ranges::sort(sides, {}, ends);
    const auto are_same = [&](const Side& a, const Side& b) { return ends(a) == ends(b); };
    sides.erase(std::unique(sides.begin(), sides.end(), are_same), sides.end());
    return sides;
}

/// Sides one after the other, going straight on where they can, as lines of nodes: so that a file of them stays small.
class SideTrails {
public:
    SideTrails(const PlateScene& scene, const PlaceLine& places, std::vector<Side> sides)
        : scene_(scene), places_(places), sides_(std::move(sides)), at_node_(places.size()), is_drawn_(sides_.size())
    {
        for (std::size_t i = 0; i < sides_.size(); ++i) {
            at_node_[sides_[i].from.index].push_back(i);
            at_node_[sides_[i].to.index].push_back(i);
        }
    }

    template <class Draw> void each(const Draw& draw)
    {
        for (std::size_t i = 0; i < sides_.size(); ++i) {
            if (is_drawn_[i]) continue;
            std::vector<ui::Point> line = scene_.on_sheet(PlaceLine{place(sides_[i].from)});
            NodeId at = sides_[i].from;
            for (std::optional<std::size_t> next = i; next; next = onward(at, line)) at = follow(*next, at, line);
            draw(line);
        }
    }

private:
    const Vector2d& place(NodeId node) const { return places_[node.index]; }

    NodeId follow(std::size_t i, NodeId from, std::vector<ui::Point>& line)
    {
        is_drawn_[i] = true;
        const Side& side = sides_[i];
        const NodeId to = side.from == from ? side.to : side.from;
        const PlaceLine curve = flattened_side(place(from),
                                               side.middle ? std::optional(place(*side.middle)) : std::nullopt,
                                               place(to), side_flatness / scene_.camera.scale());
        for (std::size_t k = 1; k < curve.size(); ++k) line.push_back(scene_.place(curve[k]));
        return to;
    }

    std::optional<std::size_t> onward(NodeId at, const std::vector<ui::Point>& line) const
    {
        const ui::Point heading = ui::direction(line.back() - line[line.size() - 2]);
        std::optional<std::size_t> best;
        double straightest = -2.0;
        for (const std::size_t i : at_node_[at.index]) {
            if (is_drawn_[i]) continue;
            const NodeId to = sides_[i].from == at ? sides_[i].to : sides_[i].from;
            const double cosine = ui::dot(heading, ui::direction(scene_.place(place(to)) - line.back()));
            if (cosine <= straightest) continue;
            straightest = cosine;
            best = i;
        }
        return best;
    }

    const PlateScene& scene_;
    const PlaceLine& places_;
    std::vector<Side> sides_;
    std::vector<std::vector<std::size_t>> at_node_;
    std::vector<bool> is_drawn_;
};

} // namespace

void draw_sides(const PlateScene& scene, const fp::PlaneModel& mesh, const PlaceLine& places, const ui::Stroke& stroke)
{
    const ui::LayerScope layer(scene.sketch.painter(), ui::Layer::Grid);
    SideTrails(scene, places, sides_of(mesh)).each([&](const std::vector<ui::Point>& line) {
        scene.sketch.polyline(line, stroke, drawing::Clearance::None);
    });
}

void draw_mesh(const PlateScene& scene)
{
    if (scene.mesh == nullptr) return;
    ui::Stroke stroke = scene.sketch.thin(Role::HiddenEdge);
    stroke.color = ui::with_opacity(scene.sketch.theme().stroke(Role::FaintLabel).color, 0.75);
    stroke.join = ui::Join::Round;
    if (scene.mesh->elements.size() > 4000) stroke.width *= 0.6;
    scene.shade_faces();
    draw_sides(scene, *scene.mesh, *scene.places, stroke);
}

void draw_deformed(const PlateScene& scene)
{
    if (scene.mesh == nullptr) return;
    const PlateOutline moved = outline_of(*scene.mesh, *scene.places, side_flatness / scene.camera.scale());
    for (const OutlinedFace& face : moved.faces) {
        if (!scene.options.show.fields.empty() || scene.shows(PlateShow::Error)) break;
        std::vector<std::vector<ui::Point>> loops;
        for (const PlaceLine& loop : face.loops) loops.push_back(scene.on_sheet(loop));
        if (loops.empty() || loops.front().size() < 3) continue;
        const ui::LayerScope layer(scene.sketch.painter(), ui::Layer::Background);
        scene.sketch.painter().region(loops, region_style(scene.sketch.theme(), *face.region).fill);
    }
    ui::Stroke stroke = scene.sketch.thin(Role::Deformed);
    for (const OutlinedPiece& piece : moved.pieces) scene.sketch.polyline(scene.on_sheet(piece.line), stroke);
    for (const OutlinedPiece& piece : scene.outline.pieces)
        scene.sketch.polyline(scene.on_sheet(piece.line), scene.sketch.stroke(Role::Undeformed),
                              drawing::Clearance::Soft);
}

void draw_mechanism(const PlateScene& scene)
{
    const PlateOutline moved = outline_of(*scene.mesh, *scene.places, side_flatness / scene.camera.scale());
    ui::Stroke stroke = scene.sketch.stroke(Role::Error);
    stroke.width = scene.sketch.px(2.0);
    for (const OutlinedFace& face : moved.faces) {
        std::vector<std::vector<ui::Point>> loops;
        for (const PlaceLine& loop : face.loops) loops.push_back(scene.on_sheet(loop));
        if (loops.empty() || loops.front().size() < 3) continue;
        const ui::LayerScope layer(scene.sketch.painter(), ui::Layer::Areas);
        scene.sketch.painter().region(loops, ui::with_opacity(stroke.color, 0.18));
    }
    for (const OutlinedPiece& piece : moved.pieces) scene.sketch.polyline(scene.on_sheet(piece.line), stroke);
}

PlaceLine moved_by(const fp::PlaneModel& mesh, const std::vector<femoop::NodeVector>& motion, double share)
{
    std::vector<Vector2d> in_plane;
    for (const femoop::NodeVector& u : motion) in_plane.emplace_back(u[0], u[1]);
    return moved_by(mesh, in_plane, share);
}

PlaceLine moved_by(const fp::PlaneModel& mesh, const std::vector<Vector2d>& motion, double share)
{
    PlaceLine places = fp::positions(mesh);
    const double reach = share * share_of_body * fp::extent(places);
    for (std::size_t i = 0; i < std::min(places.size(), motion.size()); ++i) places[i] += reach * motion[i];
    return places;
}

namespace {

double magnification_of(const PlateOptions& options, const fp::PlaneModel& mesh, const fp::PlaneCase& result)
{
    if (options.deformation_scale) return *options.deformation_scale;
    const double largest = largest_displacement(mesh, result);
    return largest > 0.0 ? drawing::round_below(share_of_body * fp::extent(fp::positions(mesh)) / largest) : 1.0;
}

} // namespace

double largest_displacement(const fp::PlaneModel& mesh, const fp::PlaneCase& result)
{
    double largest = 0.0;
    for (std::size_t i = 0; i < mesh.points.size(); ++i)
        largest = std::max(largest, result.displacement(NodeId(i)).norm());
    return largest;
}

double magnification(const PlateInput& input, const fp::PlaneCase& result, const PlateOptions& options)
{
    const double factor = magnification_of(options, *mesh_of(input), result);
    if (!input.is_compared()) return factor;
    return std::min(factor, magnification_of(options, input.kept_results->model(), *input.kept_result));
}

PlaceLine displaced(const fp::PlaneModel& mesh, const fp::PlaneCase& result, double factor)
{
    PlaceLine places = fp::positions(mesh);
    for (std::size_t i = 0; i < places.size(); ++i) places[i] += factor * result.displacement(NodeId(i));
    return places;
}

} // namespace plane
