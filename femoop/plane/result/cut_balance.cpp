#include "femoop/plane/result/cut_balance.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
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

/// The forces of crossed elements on those of one side, as N, V and M for the face whose outward normal is x'.
std::optional<CutForces> forces_on_side(const PlaneCase& result, const Cut& cut, const CutSides& sides, Side side,
                                        const Eigen::Vector2d& about)
{
    const PlaneModel& model = result.structure().model();
    std::vector<bool> is_between(model.points.size(), false);
    for (std::size_t e = 0; e < model.elements.size(); ++e)
        if (sides[e] == Side::Crossed)
            for (const NodeId node : model.elements[e].points) is_between[node.index] = true;
    Eigen::Vector2d force = Eigen::Vector2d::Zero();
    double moment = 0.0;
    bool is_any = false;
    for (std::size_t e = 0; e < model.elements.size(); ++e) {
        const auto& points = model.elements[e].points;
        const bool touches = sides[e] == side &&
                             std::ranges::any_of(points, [&](NodeId node) { return is_between[node.index]; });
        if (!touches) continue;
        is_any = true;
        const std::vector<Eigen::Vector2d> on_element = result.node_forces(ElementId(e));
        for (std::size_t i = 0; i < points.size(); ++i) {
            if (!is_between[points[i].index]) continue;
            const Eigen::Vector2d arm = result.structure().positions()[points[i].index] - about;
            force += on_element[i];
            moment += arm.x() * on_element[i].y() - arm.y() * on_element[i].x();
        }
    }
    if (!is_any) return std::nullopt;
    const double sense = side == Side::Behind ? 1.0 : -1.0;
    return CutForces{.N = sense * force.dot(cut.normal()), .V = -sense * force.dot(cut.along()), .M = sense * moment};
}

/// How far a value lies outside of what lies between two others.
double outside(double value, double a, double b)
{
    const auto [low, high] = std::minmax(a, b);
    return std::max({0.0, low - value, value - high});
}

double size_of(const CutForces& f, const Cut& cut)
{
    return std::max({std::abs(f.N), std::abs(f.V), std::abs(f.M) / cut.length()});
}

} // namespace

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
    const auto first = forces_on_side(result, cut, sides, Side::Behind, about),
               second = forces_on_side(result, cut, sides, Side::Before, about);
    if (!first && !second) return std::nullopt;
    CutBalance balance{.by_first = first ? *first : *second, .by_second = second ? *second : *first};
    balance.size = std::max(size_of(balance.by_first, cut), size_of(balance.by_second, cut));
    return balance;
}

CutForces missed(const CutForces& forces, const CutBalance& balance, const Cut& cut)
{
    if (!(balance.size > 0.0)) return {};
    const CutForces &a = balance.by_first, &b = balance.by_second;
    return {.N = outside(forces.N, a.N, b.N) / balance.size,
            .V = outside(forces.V, a.V, b.V) / balance.size,
            .M = outside(forces.M, a.M, b.M) / (balance.size * cut.length())};
}

std::optional<CutWarning> cut_warning(const PlaneResults& results, const PlaneCase& result, const Cut& cut)
{
    constexpr double tolerable = 0.02;
    const auto balance = cut_balance(results, result, cut);
    if (!balance) return std::nullopt;
    const CutForces by = missed(result.forces(cut), *balance, cut);
    const double worst = std::max({by.N, by.V, by.M});
    if (worst <= tolerable) return std::nullopt;
    return CutWarning{.missed = worst,
                      .digits = static_cast<int>(std::max(0.0, std::floor(-std::log10(worst)))),
                      .balanced = balance->mean()};
}

} // namespace femoop::plane
