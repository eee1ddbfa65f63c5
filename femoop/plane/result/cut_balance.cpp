#include "femoop/plane/result/cut_balance.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "femoop/plane/mesh/mesh_geometry.h"

namespace femoop::plane {

namespace {

/// What an element is to a cut.
enum class Side : std::uint8_t { Unknown, Crossed, Behind, Before }; // seen along x'

/// The sides of a cut on which elements lie.
class CutSides {
public:
    CutSides(const PlaneStructure& structure, const Cut& cut, const std::vector<CutPiece>& pieces)
        : model_(structure.model()), edges_(structure.edges()), cut_(cut), side_(model_.elements.size(), Side::Unknown)
    {
        for (const CutPiece& piece : pieces)
            for (const ElementId element : piece.elements) side_[element.index] = Side::Crossed;
        for (std::size_t e = 0; e < side_.size(); ++e)
            if (side_[e] == Side::Crossed)
                for (const std::size_t other : neighbours(e)) spread(other);
    }

    bool part_the_body() const { return !hang_together_; }
    Side operator[](std::size_t element) const { return side_[element]; }

private:
    /// Those that have an edge in common with it.
    std::vector<std::size_t> neighbours(std::size_t element) const
    {
        std::vector<std::size_t> found;
        const auto& points = model_.elements[element].points;
        const std::size_t n = shape_of(model_.elements[element].kind).edges().size();
        for (std::size_t i = 0; i < n; ++i)
            for (const auto& there :
                 {edges_.find(points[i], points[(i + 1) % n]), edges_.find(points[(i + 1) % n], points[i])})
                if (there && there->element.index != element) found.push_back(there->element.index);
        return found;
    }

    Side side_of(std::size_t element) const
    {
        const auto& points = model_.elements[element].points;
        Eigen::Vector2d sum = Eigen::Vector2d::Zero();
        for (const NodeId node : points) sum += Eigen::Vector2d(model_[node].at[0], model_[node].at[1]);
        const Eigen::Vector2d middle = sum / static_cast<double>(points.size());
        return (middle - cut_.start).dot(cut_.normal()) < 0.0 ? Side::Behind : Side::Before;
    }

    /// Gives an element its side, and all that hang together with it.
    void spread(std::size_t from)
    {
        const Side side = side_of(from);
        if (side_[from] != Side::Unknown) {
            hang_together_ = hang_together_ || (side_[from] != Side::Crossed && side_[from] != side);
            return;
        }
        std::vector<std::size_t> waiting{from};
        side_[from] = side;
        while (!waiting.empty()) {
            const std::size_t here = waiting.back();
            waiting.pop_back();
            for (const std::size_t other : neighbours(here))
                if (side_[other] == Side::Unknown) {
                    side_[other] = side;
                    waiting.push_back(other);
                }
        }
    }

    const PlaneModel& model_;
    const EdgeTable& edges_;
    const Cut& cut_;
    std::vector<Side> side_;
    bool hang_together_ = false;
};

bool goes_through(const PlaneResults& results, const Cut& cut)
{
    const PlaneModel& model = results.model();
    const auto is_in_material = [&](const Eigen::Vector2d& at) { // the locator takes what is beside a curved side too
        return std::ranges::any_of(results.locator().find(at), [&](const Location& found) {
            const PlaneElement& element = model[found.element];
            const Eigen::Vector2d there = positions_of(model, element).transpose() *
                                          shape_of(element.kind).values(found.at);
            return (there - at).norm() < 1e-6 * cut.length();
        });
    };
    const double beyond = 1e-5 * cut.length();
    return !is_in_material(cut.at(-beyond)) && !is_in_material(cut.at(cut.length() + beyond));
}

/// The middle of the material that is met, as a length.
double middle_of(const std::vector<CutPiece>& pieces)
{
    double length = 0.0, moment = 0.0;
    for (const CutPiece& piece : pieces) {
        length += piece.to - piece.from;
        moment += 0.5 * (piece.to + piece.from) * (piece.to - piece.from);
    }
    return moment / length;
}

/// The forces at the nodes between the elements that a cut crosses and the others, as N, V and M on the cut.
class ForcesBetween {
public:
    ForcesBetween(const PlaneCase& result, const Cut& cut, const CutSides& sides, const Eigen::Vector2d& about)
        : result_(result), model_(result.structure().model()), cut_(cut), about_(about)
    {
        std::vector<bool> is_between(model_.points.size(), false);
        for (std::size_t e = 0; e < model_.elements.size(); ++e)
            if (sides[e] == Side::Crossed)
                for (const NodeId node : model_.elements[e].points) is_between[node.index] = true;
        for (std::size_t e = 0; e < model_.elements.size(); ++e) {
            const auto& points = model_.elements[e].points;
            if (std::ranges::any_of(points, [&](NodeId node) { return is_between[node.index]; }))
                add(ElementId(e), sides[e], is_between);
        }
        for (const auto& [node, force] : at_nodes_) doubt(force, moment_of(node, force), reach_of(node));
    }

    /// On the elements of a side; nothing where there are none.
    std::optional<CutForces> on(Side side) const
    {
        const Sum& sum = side == Side::Behind ? behind_ : before_;
        if (!sum.is_any) return std::nullopt;
        const double sense = side == Side::Behind ? 1.0 : -1.0;
        return CutForces{.N = sense * sum.force.dot(cut_.normal()),
                         .V = -sense * sum.force.dot(cut_.along()),
                         .M = sense * sum.moment};
    }
    /// As much as what is applied to the crossed elements and their nodes, on whichever side of the cut it is.
    const CutForces& applied() const { return applied_; }

private:
    struct Sum {
        Eigen::Vector2d force = Eigen::Vector2d::Zero();
        double moment = 0.0;
        bool is_any = false;
    };

    void add(ElementId element, Side side, const std::vector<bool>& is_between)
    {
        const auto& points = model_[element].points;
        const std::vector<Eigen::Vector2d> forces = result_.node_forces(element);
        Sum whole;
        double reach = 0.0;
        for (std::size_t i = 0; i < points.size(); ++i) {
            if (!is_between[points[i].index]) continue;
            whole.force += forces[i];
            whole.moment += moment_of(points[i], forces[i]);
            reach = std::max(reach, reach_of(points[i]));
            const auto [at, is_new] = at_nodes_.try_emplace(points[i], Eigen::Vector2d::Zero());
            at->second += forces[i];
        }
        if (side == Side::Crossed) return doubt(whole.force, whole.moment, reach); // K u balances by itself
        Sum& sum = side == Side::Behind ? behind_ : before_;
        sum.force += whole.force;
        sum.moment += whole.moment;
        sum.is_any = true;
    }

    void doubt(const Eigen::Vector2d& force, double moment, double reach)
    {
        applied_.N += std::abs(force.dot(cut_.normal()));
        applied_.V += std::abs(force.dot(cut_.along()));
        applied_.M += std::abs(moment) + reach * force.norm();
    }

    const Eigen::Vector2d& place(NodeId node) const { return result_.structure().positions()[node.index]; }
    double reach_of(NodeId node) const { return std::abs((place(node) - cut_.start).dot(cut_.normal())); }
    double moment_of(NodeId node, const Eigen::Vector2d& force) const
    {
        const Eigen::Vector2d arm = place(node) - about_;
        return arm.x() * force.y() - arm.y() * force.x();
    }

    const PlaneCase& result_;
    const PlaneModel& model_;
    const Cut& cut_;
    Eigen::Vector2d about_;
    Sum behind_, before_;
    std::map<NodeId, Eigen::Vector2d> at_nodes_; ///< of all their elements: what loads and supports do there
    CutForces applied_;
};

/// How far a value lies outside of what lies between two others, but for what they may miss.
double outside(double value, double a, double b, double missed)
{
    const auto [low, high] = std::minmax(a, b);
    return std::max({0.0, low - missed - value, value - high - missed});
}

/// All that the supports do, without regard to directions.
double sum_of_reactions(const PlaneCase& result)
{
    double sum = 0.0;
    for (std::size_t i = 0; i < result.structure().positions().size(); ++i) sum += result.reaction(NodeId(i)).norm();
    return sum;
}

double size_of(const CutForces& f, const Cut& cut)
{
    return std::max({std::abs(f.N), std::abs(f.V), std::abs(f.M) / cut.length()});
}

} // namespace

bool CutBalance::is_exact(const Cut& cut) const { return size_of(applied, cut) <= 1e-9 * size; }

CutForces CutBalance::mean() const
{
    return {.N = 0.5 * (by_first.N + by_second.N),
            .V = 0.5 * (by_first.V + by_second.V),
            .M = 0.5 * (by_first.M + by_second.M)};
}

std::optional<CutBalance> cut_balance(const PlaneResults& results, const PlaneCase& result, const Cut& cut)
{
    const std::vector<CutPiece> pieces = pieces_along(results.model(), results.locator(), cut);
    if (pieces.empty() || !goes_through(results, cut)) return std::nullopt;
    const CutSides sides(result.structure(), cut, pieces);
    if (!sides.part_the_body()) return std::nullopt;
    const Eigen::Vector2d about = cut.at(middle_of(pieces));
    const ForcesBetween between(result, cut, sides, about);
    const auto first = between.on(Side::Behind), second = between.on(Side::Before);
    if (!first && !second) return std::nullopt;
    CutBalance balance{
        .by_first = first ? *first : *second, .by_second = second ? *second : *first, .applied = between.applied()};
    constexpr double small = 1e-3; // of what the supports do: less is no size to measure by
    balance.size = std::max(
        {size_of(balance.by_first, cut), size_of(balance.by_second, cut), small * sum_of_reactions(result)});
    return balance;
}

CutForces missed(const CutForces& forces, const CutBalance& balance, const Cut& cut)
{
    if (!(balance.size > 0.0)) return {};
    const CutForces &a = balance.by_first, &b = balance.by_second, &applied = balance.applied;
    return {.N = outside(forces.N, a.N, b.N, applied.N) / balance.size,
            .V = outside(forces.V, a.V, b.V, applied.V) / balance.size,
            .M = outside(forces.M, a.M, b.M, applied.M) / (balance.size * cut.length())};
}

std::optional<CutWarning> cut_warning(const PlaneResults& results, const PlaneCase& result, const Cut& cut)
{
    constexpr double tolerable = 0.02;
    const auto balance = cut_balance(results, result, cut);
    if (!balance) return std::nullopt;
    const CutForces forces = result.forces(cut);
    const CutForces by = missed(forces, *balance, cut);
    const double worst = std::max({by.N, by.V, by.M});
    const bool is_known_better = size_of(balance->applied, cut) < worst * balance->size;
    if (worst <= tolerable || !is_known_better) return std::nullopt;
    return CutWarning{.missed = worst,
                      .digits = static_cast<int>(std::max(0.0, std::floor(-std::log10(worst)))),
                      .balanced = balance->mean()};
}

} // namespace femoop::plane
