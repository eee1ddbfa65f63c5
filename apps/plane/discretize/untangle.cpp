#include "apps/plane/discretize/untangle.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <numbers>
#include <utility>

#include "femoop/element/continuum/element_geometry.h"

namespace discretize {

namespace {

using femoop::Shape;
using femoop::ShapeKind;
using topology::CellNode;
using topology::FlatPoint;

constexpr double good_shape = 0.2; // evenness that is left alone, and sine that no move goes below
constexpr int most_sweeps = 30;

/// Derivatives of a shape at its nodes and in its middle.
const std::vector<Shape::Derivatives>& samples(ShapeKind kind)
{
    static const std::map<ShapeKind, std::vector<Shape::Derivatives>> all = [] {
        std::map<ShapeKind, std::vector<Shape::Derivatives>> made;
        for (const ShapeKind each : {ShapeKind::T3, ShapeKind::T6, ShapeKind::Q4, ShapeKind::Q8, ShapeKind::Q9}) {
            const Shape& shape = femoop::shape_of(each);
            for (const femoop::NaturalPoint& at : shape.nodes()) made[each].push_back(shape.derivatives(at));
            const double middle = is_triangle(each) ? 1.0 / 3.0 : 0.0;
            made[each].push_back(shape.derivatives({.xi = middle, .eta = middle}));
        }
        return made;
    }();
    return all.at(kind);
}

/// Elements that are turned, with those around them.
class Untangling {
public:
    Untangling(std::vector<FlatPoint>& nodes, const std::vector<MeshedElement>& elements,
               const std::vector<bool>& is_held)
        : nodes_(nodes), elements_(elements), is_held_(is_held)
    {}

    void run()
    {
        for (int i = 0; i < most_sweeps; ++i) {
            std::vector<std::pair<double, std::size_t>> poor;
            for (std::size_t e = 0; e < elements_.size(); ++e)
                if (const double evenness = shape_of(e).evenness; evenness < good_shape) poor.emplace_back(evenness, e);
            if (poor.empty()) return;
            if (around_.empty()) find_around();
            std::sort(poor.begin(), poor.end());
            bool has_moved = false;
            for (const auto& [evenness, e] : poor)
                for (const CellNode node : elements_[e].nodes)
                    if (!is_held_[node]) has_moved = move_to_best(node) || has_moved;
            if (!has_moved) return;
        }
    }

private:
    struct Form {
        double evenness = 1.0; ///< the least det J over the mean of all its absolute values: 1 of a parallelogram
        double sine = 1.0;     ///< the least, of angles between sides as J draws them; both negative if turned
    };

    Form shape_of(std::size_t element) const
    {
        const std::vector<CellNode>& of_element = elements_[element].nodes;
        femoop::NodePositions X(static_cast<Eigen::Index>(of_element.size()), 2);
        for (std::size_t i = 0; i < of_element.size(); ++i)
            X.row(static_cast<Eigen::Index>(i)) << nodes_[of_element[i]].x, nodes_[of_element[i]].y;
        double least = std::numeric_limits<double>::infinity(), sum = 0.0;
        Form form;
        const auto& at = samples(elements_[element].kind);
        for (const Shape::Derivatives& derivatives : at) {
            const Eigen::Matrix2d J = femoop::jacobian(derivatives, X);
            least = std::min(least, J.determinant());
            sum += std::abs(J.determinant());
            form.sine = std::min(form.sine, sine_of(J, elements_[element].kind));
        }
        form.evenness = sum > 0.0 ? least * static_cast<double>(at.size()) / sum : 0.0;
        return form;
    }

    static double sine_of(const Eigen::Matrix2d& J, ShapeKind kind)
    {
        const double a = J.row(0).norm(), b = J.row(1).norm(), c = (J.row(1) - J.row(0)).norm();
        const double lengths = is_triangle(kind) ? std::max({a * b, b * c, c * a}) : a * b;
        return lengths > 0.0 ? J.determinant() / lengths : 0.0;
    }

    void find_around()
    {
        around_.resize(nodes_.size());
        for (std::size_t e = 0; e < elements_.size(); ++e)
            for (const CellNode node : elements_[e].nodes) around_[node].push_back(e);
    }

    Form worst_around(CellNode node) const
    {
        Form worst;
        for (const std::size_t e : around_[node]) {
            const Form form = shape_of(e);
            worst = {std::min(worst.evenness, form.evenness), std::min(worst.sine, form.sine)};
        }
        return worst;
    }

    bool move_to_best(CellNode node)
    {
        constexpr int n_directions = 12;
        double reach = 0.0, n = 0.0;
        for (const std::size_t e : around_[node])
            for (const CellNode other : elements_[e].nodes) {
                reach += distance(nodes_[other], nodes_[node]);
                n += 1.0;
            }
        reach /= n;
        const auto [before, sine_before] = worst_around(node);
        const double least_sine = std::min(sine_before, good_shape);
        double best = before;
        for (double step = 0.5 * reach; step > 0.01 * reach; step *= 0.5) {
            const FlatPoint from = nodes_[node];
            FlatPoint place = from;
            for (int i = 0; i < n_directions; ++i) {
                const double angle = 2.0 * std::numbers::pi * i / n_directions;
                nodes_[node] = from + step * topology::FlatVector{std::cos(angle), std::sin(angle)};
                const Form now = worst_around(node);
                if (now.evenness <= best || now.sine < least_sine) continue;
                best = now.evenness;
                place = nodes_[node];
            }
            nodes_[node] = place;
        }
        constexpr double worth_a_move = 1e-3;
        return best > before + worth_a_move;
    }

    std::vector<FlatPoint>& nodes_;
    const std::vector<MeshedElement>& elements_;
    const std::vector<bool>& is_held_;
    std::vector<std::vector<std::size_t>> around_; ///< elements of each node
};

} // namespace

void untangle(std::vector<FlatPoint>& nodes, const std::vector<MeshedElement>& elements,
              const std::vector<bool>& is_held)
{
    Untangling(nodes, elements, is_held).run();
}

} // namespace discretize
