#include "femoop/plane/mesh/cut.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "femoop/plane/mesh/mesh_geometry.h"

namespace femoop::plane {

namespace {

constexpr double negligible_piece = 1e-10; // of the cut, or of the body along it where that is shorter

/// The roots of a x^2 + b x + c from -1 to 1.
std::vector<double> roots(double a, double b, double c)
{
    constexpr double slack = 1e-9;
    const double size = std::max({std::abs(a), std::abs(b), std::abs(c)});
    std::vector<double> found;
    const auto add = [&](double x) {
        if (std::abs(x) <= 1.0 + slack) found.push_back(std::clamp(x, -1.0, 1.0));
    };
    if (std::abs(a) <= 1e-14 * size) {
        if (std::abs(b) > 1e-14 * size) add(-c / b);
        return found;
    }
    const double discriminant = b * b - 4.0 * a * c;
    if (discriminant < 0.0) return found;
    const double q = -0.5 * (b + std::copysign(std::sqrt(discriminant), b));
    add(q / a);
    if (q != 0.0) add(c / q);
    return found;
}

/// Where a cut meets the edges of an element: lengths from its first end.
class EdgeCrossings {
public:
    EdgeCrossings(const Cut& cut, std::vector<double>& places) : cut_(cut), places_(places) {}

    void add(const Shape& shape, const NodePositions& X)
    {
        for (const Shape::Edge edge : shape.edges()) {
            std::array<Eigen::Vector2d, 3> at; // relative to the cut: along, across
            for (std::size_t i = 0; i < edge.size(); ++i) {
                at[i] = relative(X.row(edge[i]).transpose());
                low_ = std::min(low_, at[i].x());
                high_ = std::max(high_, at[i].x());
            }
            if (edge.size() == 2) at[2] = 0.5 * (at[0] + at[1]);
            const Eigen::Vector2d a = 0.5 * (at[0] + at[1]) - at[2], b = 0.5 * (at[1] - at[0]), c = at[2];
            for (const double xi : roots(a.y(), b.y(), c.y())) places_.push_back(a.x() * xi * xi + b.x() * xi + c.x());
        }
    }

    double extent() const { return high_ - low_; } ///< of the elements along the cut

private:
    Eigen::Vector2d relative(const Eigen::Vector2d& at) const
    {
        return {(at - cut_.start).dot(cut_.along()), (at - cut_.start).dot(cut_.normal())};
    }
    const Cut& cut_;
    std::vector<double>& places_;
    double low_ = std::numeric_limits<double>::infinity(), high_ = -std::numeric_limits<double>::infinity();
};

} // namespace

std::vector<CutPiece> pieces_along(const PlaneModel& model, const Locator& locator, const Cut& cut)
{
    const double length = cut.length();
    std::vector<double> places{0.0, length};
    EdgeCrossings crossings(cut, places);
    for (const ElementId element : locator.in_box(cut.start.cwiseMin(cut.end), cut.start.cwiseMax(cut.end)))
        crossings.add(shape_of(model[element].kind), positions_of(model, model[element]));
    const double negligible = negligible_piece * std::min(length, crossings.extent());
    std::ranges::sort(places);
    std::vector<CutPiece> pieces;
    for (std::size_t i = 0; i + 1 < places.size(); ++i) {
        const double from = std::max(places[i], 0.0), to = std::min(places[i + 1], length);
        if (to - from <= negligible) continue;
        CutPiece piece{.from = from, .to = to, .elements = {}};
        const Eigen::Vector2d middle = cut.at(0.5 * (from + to));
        for (const ElementId element : locator.in_box(middle, middle)) {
            const PlaneElement& e = model[element];
            if (natural_place(shape_of(e.kind), positions_of(model, e), middle).distance == 0.0)
                piece.elements.push_back(element);
        }
        if (!piece.elements.empty()) pieces.push_back(std::move(piece));
    }
    return pieces;
}

} // namespace femoop::plane
