#include "apps/plane/view/support_marks.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "apps/drawing/sketch/symbols.h"
#include "apps/drawing/structure/support_symbol.h"
#include "femoop/plane/mesh/mesh_geometry.h"

namespace plane {

namespace {

namespace fp = femoop::plane;
using drawing::Clearance;
using drawing::SymbolFrame;
using Eigen::Vector2d;
using femoop::Dof;
using ui::Point;
using ui::Role;

using std::numbers::pi;

// [px]
constexpr double ground_step = 7.0, ground_depth = 7.0, roller_radius = 2.6, roller_step = 13.0, spring_step = 42.0,
                 spring_length = 26.0, comb_step = 12.0;
constexpr int most_marks = 400; // of one kind along a curve

Vector2d turned(const Vector2d& d, double angle)
{
    return {std::cos(angle) * d.x() - std::sin(angle) * d.y(), std::sin(angle) * d.x() + std::cos(angle) * d.y()};
}

/// How the directions lie that leave a vertex, so that a symbol finds its place between them.
std::vector<Vector2d> lines_at(const PlateScene& scene, const Vector2d& at)
{
    std::vector<Vector2d> lines;
    for (const OutlinedPiece& piece : scene.outline.pieces) {
        if (piece.line.front() == at) lines.push_back((piece.line[1] - at).normalized());
        if (piece.line.back() == at) lines.push_back((piece.line[piece.line.size() - 2] - at).normalized());
    }
    return lines;
}

/// The one of some directions that points away from the lines most; earlier ones are liked better.
Vector2d freest(const std::vector<Vector2d>& choices, const std::vector<Vector2d>& lines)
{
    const auto crowd = [&](const Vector2d& side) {
        double sum = 0.0;
        for (const Vector2d& line : lines) sum += std::max(0.0, line.dot(side));
        return sum;
    };
    return *std::ranges::min_element(choices, {}, [&](const Vector2d& side) { return std::round(4.0 * crowd(side)); });
}

std::string held_text(const PlateScene& scene, const fp::PlaneSupport& support, double angle)
{
    std::string text;
    for (const Dof dof : {Dof::ux, Dof::uy})
        if (support.blocked().contains(dof))
            text += (text.empty() ? "" : ", ") + std::string(dof == Dof::ux ? "ux" : "uy") + " = 0";
    if (angle != 0.0) text += " (" + scene.text(angle, ui::Measure::Angle) + ")";
    return text;
}

/// "k = 20 kN/m³".
std::string spring_text(const PlateScene& scene, const femoop::Spring& spring, bool is_on_curve)
{
    if (!is_on_curve) return "k = " + scene.text(spring.stiffness, ui::Measure::ForcePerLength);
    return "k = " + scene.text(spring.stiffness, ui::Measure::ForcePerVolume);
}

SymbolFrame frame_at(const PlateScene& scene, const Vector2d& at, const Vector2d& up)
{
    return {scene.place(at), PlateScene::direction({up.y(), -up.x()}), PlateScene::direction(up)};
}

/// A zigzag away from a place, on the ground.
void draw_spring_at(const PlateScene& scene, const Vector2d& at, const Vector2d& side)
{
    const double length = scene.sketch.px(spring_length);
    const SymbolFrame f{scene.place(at), PlateScene::direction(side), PlateScene::direction({-side.y(), side.x()})};
    drawing::draw_zigzag(scene.sketch, f, length, scene.sketch.px(5.0));
    drawing::draw_ground(scene.sketch, f.moved(length, 0.0).turned(pi / 2), scene.sketch.px(9.0));
}

void draw_point_support(const PlateScene& scene, femoop::NodeId point)
{
    const fp::PlaneSupport& support = *scene.model()[point].support;
    const Vector2d at = fp::position(scene.model()[point]);
    const double angle = support.angle * pi / 180.0;
    const Vector2d x = turned({1.0, 0.0}, angle), y = turned({0.0, 1.0}, angle);
    const std::vector<Vector2d> lines = lines_at(scene, at);
    const femoop::DofSet blocked = support.blocked();
    const bool holds_x = blocked.contains(Dof::ux), holds_y = blocked.contains(Dof::uy);
    if (holds_x || holds_y) {
        const std::vector<Vector2d> sides = !holds_y  ? std::vector<Vector2d>{-x, x}
                                            : holds_x ? std::vector<Vector2d>{-y, -x, x, y}
                                                      : std::vector<Vector2d>{-y, y};
        drawing::draw(scene.sketch, drawing::support_symbol(blocked), frame_at(scene, at, -freest(sides, lines)));
    }
    for (const femoop::Spring& spring : support.springs) {
        const Vector2d axis = spring.dof == Dof::ux ? x : y, side = freest({-axis, axis}, lines);
        draw_spring_at(scene, at, side);
        if (!scene.shows(PlateShow::Values)) continue;
        scene.sketch.caption(
            {.text = spring_text(scene, spring, false),
             .role = Role::Spring,
             .target = scene.place(at) + 0.6 * scene.sketch.px(spring_length) * PlateScene::direction(side),
             .toward = PlateScene::direction(x),
             .gap = scene.sketch.px(9.0),
             .rank = drawing::Rank::Minor,
             .size = scene.sketch.theme().type().small});
    }
}

/// What is drawn along one stretch of a curve.
class SupportedPath {
public:
    SupportedPath(const PlateScene& scene, const CurvePath& path) : scene_(scene), path_(path) {}

    /// Short strokes against which the curve rests, at this depth below it.
    void draw_ground(double depth) const
    {
        const ui::Stroke stroke = scene_.sketch.thin(Role::Support);
        std::vector<Point> line;
        for (std::size_t i = 0; i < path_.line.size(); ++i) {
            const std::size_t part = std::min(i, path_.line.size() - 2);
            line.push_back(scene_.place(path_.line[i]) + depth * outward(part));
        }
        scene_.sketch.polyline(line, scene_.sketch.stroke(Role::Support));
        at_steps(ground_step, [&](Point at, Point out) {
            const Point foot = at + depth * out, along = ui::left_normal(out);
            scene_.sketch.line(foot, foot + scene_.sketch.px(ground_depth) * ui::direction(out + along), stroke,
                               Clearance::Soft);
        });
    }

    void draw_rollers() const
    {
        const double r = scene_.sketch.px(roller_radius);
        at_steps(roller_step, [&](Point at, Point out) {
            const ui::LayerScope layer(scene_.sketch.painter(), ui::Layer::Symbols);
            const Point center = at + (r + 1.5) * out;
            scene_.sketch.disc(center, r, scene_.sketch.theme().background());
            scene_.sketch.ring(center, r, scene_.sketch.thin(Role::Support));
        });
        draw_ground(2.0 * r + 3.0);
    }

    /// Held along itself alone: teeth in a comb.
    void draw_comb() const
    {
        const double depth = scene_.sketch.px(9.0);
        at_steps(comb_step, [&](Point at, Point out) {
            const Point along = 0.5 * scene_.sketch.px(3.0) * ui::left_normal(out);
            for (const double side : {-1.0, 1.0})
                scene_.sketch.line(at + side * along, at + side * along + depth * out,
                                   scene_.sketch.thin(Role::Support), Clearance::Soft);
        });
    }

    void draw_springs(const Vector2d& axis) const
    {
        const int n = steps(spring_step);
        for (int i = 0; i < n; ++i) {
            const auto [at, part] = path_.at(path_.s.front() + (i + 0.5) / n * path_.extent());
            const Vector2d side = axis.dot(path_.outward(part)) < 0.0 ? Vector2d(-axis) : axis;
            draw_spring_at(scene_, at, side);
        }
    }

    /// In small beside the middle, as far out as the marks reach.
    void write(const std::string& text, double reach, Role role) const
    {
        const auto [at, part] = path_.at(path_.middle());
        const auto place = [&](double share) {
            return scene_.place(path_.at(path_.s.front() + share * path_.extent()).at);
        };
        scene_.sketch.caption({.text = text,
                               .role = role,
                               .target = scene_.place(at),
                               .toward = outward(part),
                               .gap = scene_.sketch.px(reach),
                               .rank = drawing::Rank::Minor,
                               .size = scene_.sketch.theme().type().small,
                               .others = {place(0.3), place(0.7)}});
    }

private:
    Point outward(std::size_t part) const { return PlateScene::direction(path_.outward(part)); }
    int steps(double step) const
    {
        const double length = path_.extent() * scene_.camera.scale();
        return static_cast<int>(std::clamp(std::round(length / scene_.sketch.px(step)), 1.0, 1.0 * most_marks));
    }
    template <class Draw> void at_steps(double step, const Draw& draw) const
    {
        const int n = steps(step);
        for (int i = 0; i < n; ++i) {
            const auto [at, part] = path_.at(path_.s.front() + (i + 0.5) / n * path_.extent());
            draw(scene_.place(at), outward(part));
        }
    }

    const PlateScene& scene_;
    const CurvePath& path_;
};

/// The axes of a curve's support, at a part of it.
std::array<Vector2d, 2> axes_of(const fp::PlaneSupport& support, const CurvePath& path, std::size_t part)
{
    const Vector2d along = (path.line[part + 1] - path.line[part]).normalized();
    if (support.has_curve_axes()) return {along, Vector2d(-along.y(), along.x())};
    const double angle = support.angle * pi / 180.0;
    return {turned({1.0, 0.0}, angle), turned({0.0, 1.0}, angle)};
}

void draw_curve_support(const PlateScene& scene, const fp::PlaneSupport& support, const CurvePath& path)
{
    const SupportedPath marks(scene, path);
    const femoop::DofSet blocked = support.blocked();
    const bool holds_x = blocked.contains(Dof::ux), holds_y = blocked.contains(Dof::uy);
    const std::size_t middle = path.at(path.middle()).part;
    const auto axes = axes_of(support, path, middle);
    double reach = 8.0;
    if (holds_x && holds_y) marks.draw_ground(0.0);
    else if (holds_x || holds_y) {
        const Vector2d& held = holds_x ? axes[0] : axes[1];
        const bool is_across = std::abs(held.dot(path.outward(middle))) > 0.5;
        if (is_across) marks.draw_rollers();
        else marks.draw_comb();
        reach = 18.0;
    }
    for (const femoop::Spring& spring : support.springs) {
        marks.draw_springs(spring.dof == Dof::ux ? axes[0] : axes[1]);
        if (scene.shows(PlateShow::Values))
            marks.write(spring_text(scene, spring, true), spring_length + 12.0, Role::Spring);
    }
    if (!scene.shows(PlateShow::Values) || holds_x == holds_y || support.has_curve_axes()) return;
    marks.write(held_text(scene, support, support.angle), reach, Role::FaintLabel);
}

void write_tie(const PlateScene& scene, const fp::PlaneCurve& curve, const CurvePath& path)
{
    std::string which;
    for (const Dof dof : {Dof::ux, Dof::uy})
        if (curve.tie.contains(dof)) which += (which.empty() ? "" : ", ") + std::string(dof == Dof::ux ? "ux" : "uy");
    SupportedPath(scene, path)
        .write(scene.options.tr("one {direction} for all", {{"direction", which}}), 8.0, Role::FaintLabel);
}

} // namespace

void draw_supports(const PlateScene& scene)
{
    const fp::PlaneModel& model = scene.model();
    for (std::size_t c = 0; c < model.curves.size(); ++c) {
        const fp::PlaneCurve& curve = model.curves[c];
        const bool is_tied = curve.tie.contains(Dof::ux) || curve.tie.contains(Dof::uy);
        if (!curve.support && !is_tied) continue;
        for (const CurvePath& path : paths_of(scene.outline, fp::CurveId(c))) {
            if (curve.support && path.touches_material()) draw_curve_support(scene, *curve.support, path);
            if (is_tied && scene.shows(PlateShow::Values)) write_tie(scene, curve, path);
        }
    }
    for (const femoop::NodeId point : scene.outline.points)
        if (model[point].support) draw_point_support(scene, point);
}

} // namespace plane
