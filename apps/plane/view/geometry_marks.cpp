#include "apps/plane/view/geometry_marks.h"

#include <algorithm>
#include <cmath>

#include "femoop/plane/mesh/mesh_geometry.h"

namespace plane {

namespace {

namespace fp = femoop::plane;
using Eigen::Vector2d;
using ui::Point;
using ui::Role;

constexpr double hatch_distance = 9.0, tick_length = 4.0, vertex_radius = 2.6; // [px]

/// Lines at 45 degrees through what lies inside an odd number of loops, as far as it may be seen.
void draw_hatch(const PlateScene& scene, const std::vector<std::vector<Point>>& loops)
{
    const double step = scene.sketch.px(hatch_distance) * std::sqrt(2.0);
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const auto& loop : loops)
        for (const Point p : loop) {
            low = std::min(low, p.x + p.y);
            high = std::max(high, p.x + p.y);
        }
    const ui::Box& room = scene.sketch.room();
    const double beyond = room.width() + room.height(); // under panels and legend
    low = std::max(low, room.min.x + room.min.y - beyond);
    high = std::min(high, room.max.x + room.max.y + beyond);
    ui::Stroke stroke = scene.sketch.thin(Role::Undeformed);
    for (double c = step * std::ceil(low / step); c < high; c += step) {
        std::vector<double> at; // x where the line x + y = c meets the loops
        for (const auto& loop : loops)
            for (std::size_t i = 0; i < loop.size(); ++i) {
                const Point a = loop[i], b = loop[(i + 1) % loop.size()];
                const double da = a.x + a.y - c, db = b.x + b.y - c;
                if ((da > 0.0) == (db > 0.0)) continue;
                at.push_back(a.x + da / (da - db) * (b.x - a.x));
            }
        std::ranges::sort(at);
        for (std::size_t i = 0; i + 1 < at.size(); i += 2)
            scene.sketch.line({at[i], c - at[i]}, {at[i + 1], c - at[i + 1]}, stroke, drawing::Clearance::None);
    }
}

std::vector<std::vector<Point>> loops_on_sheet(const PlateScene& scene, const OutlinedFace& face)
{
    std::vector<std::vector<Point>> loops;
    for (const PlaceLine& loop : face.loops) loops.push_back(scene.on_sheet(loop));
    return loops;
}

void draw_face(const PlateScene& scene, const OutlinedFace& face)
{
    const auto loops = loops_on_sheet(scene, face);
    if (loops.empty() || loops.front().size() < 3) return;
    for (const Point p : loops.front()) scene.sketch.include(p);
    const ui::LayerScope layer(scene.sketch.painter(), ui::Layer::Background);
    if (!face.region) return draw_hatch(scene, loops);
    if (!face.is_hole) scene.sketch.painter().region(loops, region_style(scene.sketch.theme(), *face.region).fill);
}

/// Whether a string written in the middle of the face's box stays in the box.
bool has_room(const PlateScene& scene, const OutlinedFace& face, const std::string& text)
{
    if (face.loops.empty() || face.loops.front().empty()) return false;
    const std::vector<Point> outline = scene.on_sheet(face.loops.front());
    const auto [left, right] = std::ranges::minmax(outline, {}, &Point::x);
    const auto [top, bottom] = std::ranges::minmax(outline, {}, &Point::y);
    const ui::Size size = ui::label_size(scene.sketch.painter().fonts(), text,
                                         scene.sketch.theme().text(Role::FaintLabel));
    return size.width <= right.x - left.x && size.height <= bottom.y - top.y;
}

void name_face(const PlateScene& scene, const OutlinedFace& face)
{
    const ui::Catalogue& tr = scene.options.tr;
    std::string name = face.region ? scene.model()[*face.region].id : tr("empty");
    if (!face.region && !has_room(scene, face, name)) return; // beside it the word would be its neighbour's
    if (face.is_hole) name = tr("{region} (hole)", {{"region", name}});
    scene.sketch.caption({.text = name,
                          .role = face.region && !face.is_hole ? Role::Label : Role::FaintLabel,
                          .target = scene.place(face.inside),
                          .toward = {0.0, -1.0},
                          .gap = -0.5 * scene.sketch.theme().type().normal,
                          .rank = drawing::Rank::Minor,
                          .weight = face.region && !face.is_hole ? ui::Weight::Bold : ui::Weight::Regular,
                          .reach = 30.0});
}

/// Where a piece is divided, as shares of its length: geometric with the ratio of the last part to the first.
std::vector<double> division_shares(const fp::Division& division)
{
    std::vector<double> shares;
    const int n = division.n;
    const double q = n > 1 && division.ratio ? std::pow(division.ratio->value(), 1.0 / (n - 1)) : 1.0;
    const auto sum = [&](int k) { return std::abs(q - 1.0) < 1e-12 ? k : (std::pow(q, k) - 1.0) / (q - 1.0); };
    for (int k = 1; k < n; ++k) shares.push_back(sum(k) / sum(n));
    return shares;
}

void draw_ticks(const PlateScene& scene, const PlaceLine& line, const fp::Division& division)
{
    CurvePath path{.line = line, .s = {0.0}};
    for (std::size_t i = 1; i < line.size(); ++i) path.s.push_back(path.s.back() + (line[i] - line[i - 1]).norm());
    for (const double share : division_shares(division)) {
        const auto [at, part] = path.at(share * path.s.back());
        const Point across = scene.sketch.px(tick_length) * PlateScene::direction(path.outward(part));
        scene.sketch.line(scene.place(at) - across, scene.place(at) + across, scene.sketch.thin(Role::Dimension),
                          drawing::Clearance::None);
    }
}

void draw_divisions(const PlateScene& scene)
{
    std::optional<fp::CurveId> curve;
    std::size_t rank = 0;
    for (const OutlinedPiece& piece : scene.outline.pieces) {
        if (!piece.curve) continue;
        rank = piece.curve == curve ? rank + 1 : 0;
        curve = piece.curve;
        const auto& shape = scene.model()[*curve].shape;
        if (!shape || shape->divide.empty()) continue;
        const std::size_t i = shape->is_divided_by_piece ? rank : 0;
        if (i < shape->divide.size()) draw_ticks(scene, piece.line, shape->divide[i]);
    }
}

void draw_piece(const PlateScene& scene, const OutlinedPiece& piece)
{
    ui::Stroke stroke = scene.sketch.stroke(piece.dangles ? Role::Warning : Role::Edge);
    if (!piece.curve) stroke.width *= 0.7;
    scene.sketch.polyline(scene.on_sheet(piece.line), stroke);
}

/// Beside the middle of a curve, where no material is if it can.
void name_curve(const PlateScene& scene, fp::CurveId curve)
{
    const std::vector<CurvePath> paths = paths_of(scene.outline, curve);
    if (paths.empty()) return;
    const CurvePath& path = *std::ranges::max_element(paths, {}, &CurvePath::extent);
    const auto [middle, part] = path.at(path.middle());
    const auto place_at = [&](double share) { return scene.place(path.at(path.s.front() + share * path.extent()).at); };
    const Point out = PlateScene::direction(path.outward(part));
    scene.sketch.caption({.text = scene.model()[curve].id,
                          .role = Role::FaintLabel,
                          .target = scene.place(middle),
                          .toward = scene.is_colored() ? out : -out,
                          .rank = drawing::Rank::Name,
                          .size = scene.sketch.theme().type().small,
                          .others = {place_at(0.35), place_at(0.65), place_at(0.2)},
                          .reach = 30.0});
}

void name_points(const PlateScene& scene)
{
    Vector2d middle = Vector2d::Zero();
    for (const Vector2d& at : scene.outline.vertices) middle += at / static_cast<double>(scene.outline.vertices.size());
    for (const femoop::NodeId point : scene.outline.points) {
        const Vector2d at = fp::position(scene.model()[point]);
        scene.sketch.caption({.text = scene.model()[point].id,
                              .target = scene.place(at),
                              .toward = PlateScene::direction(at - middle),
                              .rank = drawing::Rank::Name,
                              .reach = 25.0});
    }
}

void draw_highlight(const PlateScene& scene, const PlateHighlight& what, Role role)
{
    const ui::LayerScope layer(scene.sketch.painter(), ui::Layer::Grid);
    const ui::Stroke stroke = scene.sketch.theme().stroke(role);
    for (const std::size_t i : what.faces) {
        if (i >= scene.outline.faces.size()) continue;
        const auto loops = loops_on_sheet(scene, scene.outline.faces[i]);
        if (!loops.empty()) scene.sketch.painter().region(loops, ui::with_opacity(stroke.color, 0.25));
    }
    for (const OutlinedPiece& piece : scene.outline.pieces)
        if (piece.curve && std::ranges::find(what.curves, *piece.curve) != what.curves.end())
            scene.sketch.painter().polyline(scene.on_sheet(piece.line), stroke);
    for (const femoop::NodeId point : what.points) {
        if (point.index >= scene.model().points.size()) continue;
        const Point at = scene.place(fp::position(scene.model()[point]));
        scene.sketch.painter().disc(at, scene.sketch.px(vertex_radius) + stroke.width, stroke.color);
    }
}

} // namespace

void draw_highlights(const PlateScene& scene)
{
    draw_highlight(scene, scene.state.hover, Role::Hover);
    draw_highlight(scene, scene.state.selection, Role::Selection);
}

ui::RoleStyle region_style(const ui::Theme& theme, fp::RegionId region)
{
    ui::RoleStyle style = theme.series(region.index);
    if (theme.name() == ui::ThemeName::Light || theme.name() == ui::ThemeName::Projector)
        style.fill = ui::with_opacity(style.stroke.color, 0.18);
    return style;
}

void draw_regions(const PlateScene& scene)
{
    for (const OutlinedFace& face : scene.outline.faces) draw_face(scene, face);
    if (!scene.shows(PlateShow::Names)) return;
    for (const OutlinedFace& face : scene.outline.faces) name_face(scene, face);
}

void draw_geometry(const PlateScene& scene)
{
    for (const OutlinedPiece& piece : scene.outline.pieces) draw_piece(scene, piece);
    draw_divisions(scene);
    // of a mesh the vertices are nodes, which the mesh shows
    if (scene.input.drawing != nullptr) {
        const ui::LayerScope layer(scene.sketch.painter(), ui::Layer::Symbols);
        for (const Vector2d& at : scene.outline.vertices)
            scene.sketch.disc(scene.place(at), scene.sketch.px(vertex_radius), scene.sketch.theme().fill(Role::Node));
    }
    if (!scene.shows(PlateShow::Names)) return;
    if (scene.input.drawing != nullptr) name_points(scene);
    for (std::size_t c = 0; c < scene.model().curves.size(); ++c) name_curve(scene, fp::CurveId(c));
}

} // namespace plane
