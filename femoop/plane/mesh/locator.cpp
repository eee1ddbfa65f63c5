#include "femoop/plane/mesh/locator.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "femoop/plane/mesh/mesh_geometry.h"

namespace femoop::plane {

namespace {

constexpr double on_border = 1e-9; // of an element's size: the place counts as inside
constexpr double beside = 0.12;    // of an element's size: so far a coarse side may miss its curve
constexpr int most_steps = 50;
constexpr int most_cells = 2000; // along a side

NaturalPoint into_domain(Domain domain, NaturalPoint p)
{
    if (domain == Domain::Quadrilateral)
        return {.xi = std::clamp(p.xi, -1.0, 1.0), .eta = std::clamp(p.eta, -1.0, 1.0)};
    double xi = std::max(p.xi, 0.0), eta = std::max(p.eta, 0.0);
    if (const double excess = xi + eta - 1.0; excess > 0.0) {
        xi -= 0.5 * excess;
        eta -= 0.5 * excess;
        if (xi < 0.0) return {.xi = 0.0, .eta = 1.0};
        if (eta < 0.0) return {.xi = 1.0, .eta = 0.0};
    }
    return {.xi = xi, .eta = eta};
}

/// A side of an element, as the outline of the material has it.
struct Side {
    NodeId start, end;
    Eigen::Vector2d a, b;
    double bulge = 0.0; ///< of its middle node from the chord

    Eigen::Vector2d chord() const { return b - a; }
    double distance(const Eigen::Vector2d& at) const
    {
        const double share = std::clamp((at - a).dot(chord()) / chord().squaredNorm(), 0.0, 1.0);
        return (at - a - share * chord()).norm();
    }
};

std::vector<Side> sides_of(const PlaneModel& model, ElementId id)
{
    const PlaneElement& element = model[id];
    std::vector<Side> sides;
    for (const Shape::Edge edge : shape_of(element.kind).edges()) {
        const auto node = [&](std::size_t i) { return element.points[static_cast<std::size_t>(edge[i])]; };
        Side side{.start = node(0), .end = node(1), .a = position(model[node(0)]), .b = position(model[node(1)])};
        if (edge.size() > 2) side.bulge = (position(model[node(2)]) - 0.5 * (side.a + side.b)).norm();
        sides.push_back(side);
    }
    return sides;
}

/// How far the arc of a circle that a chord is of lies beyond it, by the angle to the next chord; 0 at a corner.
double rise_of_arc(const Eigen::Vector2d& chord, const Eigen::Vector2d& next)
{
    constexpr double margin = 1.5; // curves are no circles
    if (is_corner(chord, next)) return 0.0;
    const double cosine = chord.normalized().dot(next.normalized());
    return margin * 0.5 * chord.norm() * std::tan(0.25 * std::acos(std::min(cosine, 1.0)));
}

} // namespace

NaturalPlace natural_place(const Shape& shape, const NodePositions& X, const Eigen::Vector2d& at)
{
    const Eigen::RowVector2d origin = X.row(0);
    const NodePositions relative = X.rowwise() - origin;
    const Eigen::Vector2d wanted = at - origin.transpose();
    const double size = extent(X);
    NaturalPoint p = centroid(shape.domain());
    const auto miss = [&](NaturalPoint q) -> Eigen::Vector2d {
        return wanted - relative.transpose() * shape.values(q);
    };
    for (int step = 0; step < most_steps; ++step) {
        const Eigen::Matrix2d J = jacobian(shape.derivatives(p), relative);
        const Eigen::Vector2d move = J.transpose().inverse() * miss(p);
        if (!move.allFinite()) break;
        const double shortened = std::min(1.0,
                                          1.0 / std::max(move.cwiseAbs().maxCoeff(), 1e-300)); // one step, one size
        p.xi += shortened * move.x();
        p.eta += shortened * move.y();
        if (std::abs(p.xi) > 10.0 || std::abs(p.eta) > 10.0) break; // far outside
        if (move.cwiseAbs().maxCoeff() < 1e-15) break;
    }
    const NaturalPoint inside = into_domain(shape.domain(), p);
    const double distance = miss(inside).norm() / size;
    if (distance <= on_border) return {.at = inside, .distance = 0.0};
    return {.at = inside, .distance = distance};
}

Locator::Locator(const PlaneModel& model) : model_(model), low_(Eigen::Vector2d::Zero()), step_(Eigen::Vector2d::Ones())
{
    Eigen::Vector2d high = Eigen::Vector2d::Zero();
    for (const PlaneElement& element : model.elements) {
        const NodePositions X = positions_of(model, element);
        const Eigen::Vector2d a = X.colwise().minCoeff(), b = X.colwise().maxCoeff();
        const Eigen::Vector2d margin = Eigen::Vector2d::Constant(0.25 * (b - a).norm()); // sides may bulge out
        const Box box{a - margin, b + margin};
        if (boxes_.empty()) low_ = box.low, high = box.high;
        low_ = low_.cwiseMin(box.low).eval();
        high = high.cwiseMax(box.high).eval();
        boxes_.push_back(box);
    }
    n_ = std::clamp(static_cast<int>(std::sqrt(static_cast<double>(boxes_.size()))), 1, most_cells);
    step_ = ((high - low_) / n_).cwiseMax(std::numeric_limits<double>::min());
    start_.assign(static_cast<std::size_t>(n_) * static_cast<std::size_t>(n_) + 1, 0);
    const auto visit = [&](auto&& use) {
        for (std::uint32_t e = 0; e < boxes_.size(); ++e) {
            const Cell a = cell_of(boxes_[e].low), b = cell_of(boxes_[e].high);
            for (int j = a.y(); j <= b.y(); ++j)
                for (int i = a.x(); i <= b.x(); ++i) use(static_cast<std::size_t>(j * n_ + i), e);
        }
    };
    visit([&](std::size_t cell, std::uint32_t) { ++start_[cell + 1]; });
    for (std::size_t i = 1; i < start_.size(); ++i) start_[i] += start_[i - 1];
    in_cell_.resize(start_.back());
    std::vector<std::uint32_t> next(start_.begin(), start_.end() - 1);
    visit([&](std::size_t cell, std::uint32_t e) { in_cell_[next[cell]++] = e; });
}

Locator::Cell Locator::cell_of(const Eigen::Vector2d& at) const
{
    const auto along = [&](int axis) {
        return static_cast<int>(std::clamp((at[axis] - low_[axis]) / step_[axis], 0.0, static_cast<double>(n_ - 1)));
    };
    return {along(0), along(1)};
}

std::vector<ElementId> Locator::in_box(const Eigen::Vector2d& low, const Eigen::Vector2d& high) const
{
    std::vector<ElementId> found;
    const Cell a = cell_of(low), b = cell_of(high);
    for (int j = a.y(); j <= b.y(); ++j)
        for (int i = a.x(); i <= b.x(); ++i) {
            const auto cell = static_cast<std::size_t>(j * n_ + i);
            for (std::uint32_t k = start_[cell]; k < start_[cell + 1]; ++k) {
                const Box& box = boxes_[in_cell_[k]];
                if ((box.low.array() <= high.array()).all() && (box.high.array() >= low.array()).all())
                    found.emplace_back(in_cell_[k]);
            }
        }
    std::ranges::sort(found);
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
}

std::vector<Location> Locator::find(const Eigen::Vector2d& at) const
{
    std::vector<Location> found;
    for (const ElementId element : in_box(at, at)) {
        const PlaneElement& e = model_[element];
        const NaturalPlace place = natural_place(shape_of(e.kind), positions_of(model_, e), at);
        if (place.distance == 0.0) found.push_back({.element = element, .at = place.at});
    }
    if (found.empty())
        if (const auto close = nearest(at)) found.push_back(*close);
    return found;
}

std::optional<Location> Locator::nearest(const Eigen::Vector2d& at) const
{
    std::optional<Location> found;
    double least = beside;
    for (const ElementId element : in_box(at, at)) {
        const PlaneElement& e = model_[element];
        const NodePositions X = positions_of(model_, e);
        const NaturalPlace place = natural_place(shape_of(e.kind), X, at);
        if (!(place.distance < least)) continue;
        if (place.distance * extent(X) > curve_beyond(element, at)) continue;
        least = place.distance;
        found = Location{.element = element, .at = place.at};
    }
    return found;
}

/// How far the outline that a place beside an element's side was drawn in may lie beyond the side.
double Locator::curve_beyond(ElementId element, const Eigen::Vector2d& at) const
{
    const std::vector<Side> sides = sides_of(model_, element);
    const Side side = *std::ranges::min_element(sides, {}, [&](const Side& each) { return each.distance(at); });
    std::vector<Side> around;
    for (const ElementId other : in_box(boxes_[element.index].low, boxes_[element.index].high))
        std::ranges::move(sides_of(model_, other), std::back_inserter(around));
    const auto is_outline = [&](const Side& each) {
        return std::ranges::none_of(
            around, [&](const Side& other) { return other.start == each.end && other.end == each.start; });
    };
    double most = side.bulge;
    for (const Side& each : around) {
        const bool is_next = each.start == side.end, is_last = each.end == side.start;
        if ((is_next || is_last) && is_outline(each)) most = std::max(most, rise_of_arc(side.chord(), each.chord()));
    }
    return most;
}

} // namespace femoop::plane
