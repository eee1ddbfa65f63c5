#include "apps/cli/bench_plane.h"

#include <cmath>
#include <numbers>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "apps/cli/bench_frame.h"
#include "femoop/analysis/stopwatch.h"
#include "femoop/plane/analysis/plane_analysis.h"
#include "femoop/solver/at_once.h"
#include "topology/meshing/mapped_mesher.h"

namespace cli {

namespace {

namespace fp = femoop::plane;

using femoop::NodeId;
using femoop::ShapeKind;

/// Points of a grid, row by row, with their numbers: as fine as the nodes of the elements.
class GridOfPoints {
public:
    GridOfPoints(fp::PlaneModel& model, std::size_t n_steps) : n_(n_steps + 1), ids_(n_ * n_), model_(model) {}

    NodeId at(std::size_t i, std::size_t j)
    {
        auto& id = ids_[i + j * n_];
        if (!id) {
            id = NodeId(model_.points.size());
            const double steps = static_cast<double>(n_ - 1);
            model_.points.push_back({.id = "p" + std::to_string(id->index + 1),
                                     .at = {static_cast<double>(i) / steps, static_cast<double>(j) / steps}});
        }
        return *id;
    }

private:
    std::size_t n_;
    std::vector<std::optional<NodeId>> ids_;
    fp::PlaneModel& model_;
};

struct Offset {
    std::size_t x, y;
};

/// Nodes of an element as steps of a grid that is twice as fine as corners are.
std::vector<std::vector<Offset>> elements_of_cell(ShapeKind kind)
{
    const std::vector<Offset> corners{{0, 0}, {2, 0}, {2, 2}, {0, 2}}, middles{{1, 0}, {2, 1}, {1, 2}, {0, 1}};
    std::vector<Offset> all = corners;
    switch (kind) {
    case ShapeKind::T3: return {{{0, 0}, {2, 0}, {2, 2}}, {{0, 0}, {2, 2}, {0, 2}}};
    case ShapeKind::T6:
        return {{{0, 0}, {2, 0}, {2, 2}, {1, 0}, {2, 1}, {1, 1}}, {{0, 0}, {2, 2}, {0, 2}, {1, 1}, {1, 2}, {0, 1}}};
    case ShapeKind::Q4: return {corners};
    default: all.insert(all.end(), middles.begin(), middles.end());
    }
    if (kind == ShapeKind::Q9) all.push_back({1, 1});
    return {all};
}

/// Recovered stresses at the points that 2 x 2 Gauss points have in a square, of a triangle at its own.
double sum_of_stresses(const fp::PlaneCase& result)
{
    const double g = 1.0 / std::numbers::sqrt3;
    const std::vector<femoop::NaturalPoint> in_square{{-g, -g}, {g, -g}, {g, g}, {-g, g}},
        in_triangle{{0.2, 0.2}, {0.6, 0.2}, {0.2, 0.6}, {1.0 / 3.0, 1.0 / 3.0}};
    constexpr std::size_t at_once = 10000; // elements
    const auto& elements = result.structure().model().elements;
    std::vector<double> sums(elements.size() / at_once + 1);
    result.sample();
    femoop::in_ranges(elements.size(), at_once, [&](std::size_t begin, std::size_t end) {
        double& sum = sums[begin / at_once];
        for (std::size_t e = begin; e < end; ++e)
            for (const femoop::NaturalPoint& at : femoop::is_triangle(elements[e].kind) ? in_triangle : in_square) {
                const auto stress = result.element_stress({.element = fp::ElementId(e), .at = at});
                sum += stress.sx + stress.sy + stress.txy;
            }
    });
    return std::accumulate(sums.begin(), sums.end(), 0.0);
}

} // namespace

fp::PlaneModel unit_square(std::size_t n, ShapeKind element)
{
    fp::PlaneModel model;
    model.materials.push_back({.id = "m", .E = 1.0, .nu = 0.3});
    model.regions.push_back({.id = "square", .material = femoop::MaterialId(0), .thickness = 1.0});
    GridOfPoints grid(model, 2 * n);
    const auto shapes = elements_of_cell(element);
    for (std::size_t j = 0; j < n; ++j)
        for (std::size_t i = 0; i < n; ++i)
            for (const auto& shape : shapes) {
                fp::PlaneElement made{.id = "", .kind = element, .points = {}, .region = fp::RegionId(0)};
                for (const auto& [x, y] : shape) made.points.push_back(grid.at(2 * i + x, 2 * j + y));
                made.id = std::to_string(model.elements.size() + 1);
                model.elements.push_back(std::move(made));
            }
    fp::PlaneCurve left{.id = "left"}, right{.id = "right"};
    for (std::size_t j = 0; j <= n; ++j) {
        right.points.push_back(grid.at(2 * n, 2 * j));
        left.points.push_back(grid.at(0, 2 * (n - j)));
    }
    left.support = fp::PlaneSupport{.kind = fp::PlaneSupportKind::Fixed};
    model.curves = {left, right};
    fp::CurveLoad load{.curves = {fp::CurveId(1)}, .kind = fp::CurveLoadKind::Traction};
    load.qy = fp::Field{femoop::Quantity(1.0)};
    model.load_cases.push_back({.id = "P", .curves = {load}});
    return model;
}

PlaneBench bench_plane(fp::PlaneModel model, const femoop::AnalysisOptions& options)
{
    PlaneBench bench;
    femoop::Stopwatch watch;
    const fp::PlaneResults results = fp::analyse(std::move(model), options);
    const double solved = watch.lap();
    const fp::PlaneCase result = results[femoop::CaseId(0)];
    bench.sum = sum_of_stresses(result);
    bench.recover = watch.lap();
    bench.total = solved + bench.recover;
    bench.statistics = results.statistics();
    bench.peak_mb = peak_megabytes();
    bench.tip = result.displacement(results.locator().find({1.0, 0.5}).front()).y();
    return bench;
}

} // namespace cli
