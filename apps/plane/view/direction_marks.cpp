#include "apps/plane/view/direction_marks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "femoop/plane/result/trajectories.h"

namespace plane {

namespace {

namespace fp = femoop::plane;
using Eigen::Vector2d;
using ui::Point;

constexpr double cross_distance = 34.0, trajectory_distance = 20.0; // [px]

struct Cross {
    Vector2d at;
    fp::PrincipalStress stress;
};

ui::Stroke first_stroke(const PlateScene& scene)
{
    ui::Stroke stroke = scene.sketch.thin(ui::Role::Error);
    return stroke;
}

ui::Stroke second_stroke(const PlateScene& scene)
{
    ui::Stroke stroke = scene.sketch.thin(ui::Role::BendingMoment);
    stroke.dash = ui::DashPattern{5.0, 3.0}.scaled(scene.sketch.theme().symbol_scale());
    return stroke;
}

/// At equal distances on the sheet, wherever there is material.
std::vector<Cross> crosses_of(const PlateScene& scene)
{
    ui::Point low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()}, high = -low;
    for (const OutlinedPiece& piece : scene.outline.pieces)
        for (const ui::Point p : scene.on_sheet(piece.line)) {
            low = {std::min(low.x, p.x), std::min(low.y, p.y)};
            high = {std::max(high.x, p.x), std::max(high.y, p.y)};
        }
    const ui::Box seen = ui::intersection({low, high}, scene.sketch.painter().sheet());
    const double step = scene.sketch.px(cross_distance);
    std::vector<Cross> crosses;
    // from the middle of the body, so that a symmetric one is met symmetrically
    const Point middle = 0.5 * (low + high);
    for (double y = middle.y - step * std::floor((middle.y - seen.min.y) / step); y <= seen.max.y; y += step)
        for (double x = middle.x - step * std::floor((middle.x - seen.min.x) / step); x <= seen.max.x; x += step) {
            const ui::World2 world = scene.camera.to_world({x, y});
            const Vector2d at(world.x, world.y);
            const auto places = scene.input.results->locator().find(at);
            if (places.empty()) continue;
            Cross cross{at, fp::principal(scene.result->smoothed_stress(places.front()))};
            if (scene.magnification != 0.0)
                cross.at += scene.magnification * scene.result->displacement(places.front());
            crosses.push_back(cross);
        }
    return crosses;
}

void draw_arm(const PlateScene& scene, const Cross& cross, double stress, double angle, double unit)
{
    const Vector2d d(std::cos(angle), std::sin(angle));
    const Point half = unit * std::abs(stress) * PlateScene::direction(d), at = scene.place(cross.at);
    if (ui::length(half) < 1.0) return;
    scene.sketch.line(at - half, at + half, stress > 0.0 ? first_stroke(scene) : second_stroke(scene),
                      drawing::Clearance::None);
}

} // namespace

void draw_principal(const PlateScene& scene)
{
    if (scene.result == nullptr) return;
    const std::vector<Cross> crosses = crosses_of(scene);
    double largest = 0.0;
    for (const Cross& cross : crosses)
        largest = std::max({largest, std::abs(cross.stress.s1), std::abs(cross.stress.s2)});
    if (!(largest > 0.0)) return;
    const double unit = 0.46 * scene.sketch.px(cross_distance) / largest;
    for (const Cross& cross : crosses) {
        draw_arm(scene, cross, cross.stress.s1, cross.stress.angle, unit);
        draw_arm(scene, cross, cross.stress.s2, cross.stress.angle + 0.5 * std::numbers::pi, unit);
    }
}

namespace {

/// A line of the body at rest where displacements take it.
fp::Trajectory drawn_line(const PlateScene& scene, fp::Trajectory line)
{
    if (scene.magnification == 0.0) return line;
    for (Vector2d& at : line) {
        const auto places = scene.input.results->locator().find(at);
        if (!places.empty()) at += scene.magnification * scene.result->displacement(places.front());
    }
    return line;
}

} // namespace

void draw_trajectories(const PlateScene& scene)
{
    if (scene.result == nullptr) return;
    const double spacing = scene.sketch.px(trajectory_distance) / scene.camera.scale();
    for (const auto family : {fp::PrincipalFamily::First, fp::PrincipalFamily::Second}) {
        const ui::Stroke stroke = family == fp::PrincipalFamily::First ? first_stroke(scene) : second_stroke(scene);
        for (const fp::Trajectory& line : fp::trajectories(*scene.input.results, *scene.result, family, spacing))
            scene.sketch.polyline(scene.on_sheet(drawn_line(scene, line)), stroke, drawing::Clearance::None);
    }
}

std::string principal_note(const ui::Catalogue& tr)
{
    return tr("principal stresses: full lines tension, dashes compression");
}

std::string trajectories_note(const ui::Catalogue& tr) { return tr("trajectories: full lines σ1, dashes σ2"); }

} // namespace plane
