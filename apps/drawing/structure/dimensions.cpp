#include "apps/drawing/structure/dimensions.h"

#include "apps/drawing/structure/dimension_symbol.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace drawing {

namespace {

using Eigen::Vector3d;

/// The distinct coordinates of the nodes along one axis, ascending.
std::vector<double> levels(const Scene& scene, int axis)
{
    std::vector<double> found;
    for (const Vector3d& node : scene.shape.nodes) found.push_back(node[axis]);
    std::sort(found.begin(), found.end());
    const auto same = [&](double a, double b) { return b - a < 1e-6 * scene.shape.size; };
    found.erase(std::unique(found.begin(), found.end(), same), found.end());
    return found;
}

/// A chain on the sheet: where a level lies, and the direction in which the texts stand.
struct Chain {
    std::vector<double> levels;
    std::function<ui::Point(double)> at;
    ui::Point outward;
};

/// Of the longest of a chain's texts [px].
double text_width(const Scene& scene, const std::vector<double>& levels)
{
    ui::TextStyle style = scene.sketch.theme().text(ui::Role::Dimension);
    style.size = scene.sketch.theme().type().small;
    double widest = 0.0;
    for (std::size_t i = 0; i + 1 < levels.size(); ++i) {
        const std::string text = length_text(scene, levels[i + 1] - levels[i]);
        widest = std::max(widest, ui::label_size(scene.sketch.painter().fonts(), text, style).width);
    }
    return widest;
}

void draw_chain(const Scene& scene, const Chain& chain)
{
    for (std::size_t i = 0; i + 1 < chain.levels.size(); ++i)
        draw(scene, {.start = chain.at(chain.levels[i]),
                     .end = chain.at(chain.levels[i + 1]),
                     .outward = chain.outward,
                     .length = chain.levels[i + 1] - chain.levels[i]});
}

void draw_with_total(const Scene& scene, const Chain& chain, double step, Chains chains)
{
    if (chain.levels.size() < 2) return;
    draw_chain(scene, chain);
    if (chain.levels.size() == 2 || chains == Chains::Brief) return;
    draw_chain(scene, {{chain.levels.front(), chain.levels.back()},
                       [&](double level) { return chain.at(level) + step * chain.outward; },
                       chain.outward});
}

void draw_in_plane(const Scene& scene, Chains chains)
{
    Sketch& sketch = scene.sketch;
    if (!sketch.bounds()) return;
    const ui::Box around = *sketch.bounds();
    const double gap = sketch.px(16.0);
    const double step = sketch.px(20.0) + 6.0;
    const auto sheet = [&](double x, double y) { return scene.projection(Vector3d(x, y, 0.0)); };
    draw_with_total(scene,
                    {levels(scene, 0),
                     [&](double x) {
                         return ui::Point{sheet(x, 0.0).x, around.max.y + gap};
                     },
                     ui::Point{0.0, 1.0}},
                    step, chains);
    const std::vector<double> heights = levels(scene, 1);
    const ui::Point outward{chains == Chains::Brief ? 1.0 : -1.0, 0.0};
    draw_with_total(scene,
                    {heights,
                     [&](double y) {
                         return ui::Point{around.min.x - gap, sheet(0.0, y).y};
                     },
                     outward},
                    std::max(step, text_width(scene, heights) + sketch.px(14.0)), chains);
}

void draw_in_space(const Scene& scene, Chains chains)
{
    Sketch& sketch = scene.sketch;
    const double unit = sketch.px(34.0) / scene.projection.scale();
    const std::vector<double> x = levels(scene, 0);
    const std::vector<double> y = levels(scene, 1);
    const std::vector<double> z = levels(scene, 2);
    if (x.empty()) return;
    const auto at = [&](double px, double py, double pz) { return scene.projection(Vector3d(px, py, pz)); };
    const auto chain = [&](std::vector<double> list, std::function<ui::Point(double)> place, ui::Point outward) {
        draw_with_total(scene, {std::move(list), std::move(place), outward}, sketch.px(26.0), chains);
    };
    chain(
        x, [&](double v) { return at(v, y.front() - unit, z.front()); },
        ui::direction(scene.projection.direction(-Vector3d::UnitY())));
    chain(
        y, [&](double v) { return at(x.back() + unit, v, z.front()); },
        ui::direction(scene.projection.direction(Vector3d::UnitX())));
    chain(
        z, [&](double v) { return at(x.front(), y.front() - unit, v); },
        ui::direction(scene.projection.direction(-Vector3d::UnitY())));
}

} // namespace

std::vector<Eigen::Vector3d> dimensioned_corners(const StructureShape& shape)
{
    if (shape.nodes.empty()) return {};
    Vector3d least = shape.nodes.front(), most = least;
    for (const Vector3d& node : shape.nodes) {
        least = least.cwiseMin(node);
        most = most.cwiseMax(node);
    }
    return {least, {most.x(), least.y(), least.z()}, {most.x(), most.y(), least.z()}, {least.x(), least.y(), most.z()}};
}

void draw_dimensions(const Scene& scene, Chains chains)
{
    const ui::LayerScope layer(scene.sketch.painter(), ui::Layer::Symbols);
    if (scene.is_flat()) draw_in_plane(scene, chains);
    else draw_in_space(scene, chains);
}

} // namespace drawing
