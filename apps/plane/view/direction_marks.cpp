#include "apps/plane/view/direction_marks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "apps/drawing/sketch/symbols.h"
#include "apps/plane/view/mesh_marks.h"
#include "femoop/plane/result/trajectories.h"

namespace plane {

namespace {

namespace fp = femoop::plane;
using Eigen::Vector2d;
using ui::Point;

constexpr double cross_distance = 34.0, trajectory_distance = 20.0; // [px]

/// A place of the body at rest, with an element that it lies in.
struct Sample {
    Vector2d at;
    fp::Location element;
};

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
std::vector<Sample> samples_of(const PlateScene& scene)
{
    ui::Point low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()}, high = -low;
    for (const OutlinedPiece& piece : scene.outline.pieces)
        for (const ui::Point p : scene.on_sheet(piece.line)) {
            low = {std::min(low.x, p.x), std::min(low.y, p.y)};
            high = {std::max(high.x, p.x), std::max(high.y, p.y)};
        }
    const ui::Box seen = ui::intersection({low, high}, scene.sketch.painter().sheet());
    const double step = scene.sketch.px(cross_distance);
    std::vector<Sample> samples;
    // from the middle of the body, so that a symmetric one is met symmetrically
    const Point middle = 0.5 * (low + high);
    for (double y = middle.y - step * std::floor((middle.y - seen.min.y) / step); y <= seen.max.y; y += step)
        for (double x = middle.x - step * std::floor((middle.x - seen.min.x) / step); x <= seen.max.x; x += step) {
            const ui::World2 world = scene.camera.to_world({x, y});
            const Vector2d at(world.x, world.y);
            const auto places = scene.input.results->locator().find(at);
            if (!places.empty()) samples.push_back({at, places.front()});
        }
    return samples;
}

std::vector<Cross> crosses_of(const PlateScene& scene)
{
    std::vector<Cross> crosses;
    for (const Sample& sample : samples_of(scene)) {
        Cross cross{sample.at, fp::principal(scene.result->smoothed_stress(sample.element))};
        if (scene.magnification != 0.0) cross.at += scene.magnification * scene.result->displacement(sample.element);
        crosses.push_back(cross);
    }
    return crosses;
}

/// Half the longer arm of a cross by the stress along it, as a share of the distance of crosses: one of a small stress is
/// still long enough that its directions are seen, as at the neutral axis of a beam; both arms are to each other as the
/// stresses are.
double half_length(const fp::PrincipalStress& stress, double largest)
{
    constexpr double longest = 0.46, shortest = 0.14, nothing = 0.005;
    const double here = std::max(std::abs(stress.s1), std::abs(stress.s2));
    if (here <= nothing * largest) return 0.0;
    return (shortest + (longest - shortest) * here / largest) / here;
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
    for (const Cross& cross : crosses) {
        const double unit = scene.sketch.px(cross_distance) * half_length(cross.stress, largest);
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

void draw_vectors(const PlateScene& scene)
{
    if (scene.result == nullptr || scene.mesh == nullptr) return;
    constexpr double least_length = 1.5, head = 6.0, most_of_arrow = 0.45; // [px]; of the arrow is its head
    const double largest = largest_displacement(*scene.mesh, *scene.result);
    if (!(largest > 0.0)) return;
    const double factor = scene.magnification != 0.0 ? scene.magnification * scene.camera.scale()
                                                     : 0.92 * scene.sketch.px(cross_distance) / largest;
    const ui::Stroke stroke = scene.sketch.thin(ui::Role::Deformed);
    for (const Sample& sample : samples_of(scene)) {
        const Point foot = scene.place(sample.at);
        const Point arrow = factor * PlateScene::direction(scene.result->displacement(sample.element));
        const double length = ui::length(arrow);
        if (length < least_length) continue;
        scene.sketch.line(foot, foot + arrow, stroke, drawing::Clearance::None);
        drawing::arrow_head(scene.sketch, foot + arrow, arrow, std::min(scene.sketch.px(head), most_of_arrow * length),
                            stroke.color);
    }
}

std::string principal_note(const ui::Catalogue& tr)
{
    return tr("principal stresses: full lines tension, dashes compression");
}

std::string trajectories_note(const ui::Catalogue& tr) { return tr("trajectories: full lines σ1, dashes σ2"); }

std::string vectors_note(const std::string& largest, const ui::Catalogue& tr)
{
    return tr("arrows: displacements, the largest {value}", {{"value", largest}});
}

} // namespace plane
