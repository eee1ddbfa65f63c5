#include "femoop/plane/analysis/edge_traction.h"

#include <algorithm>
#include <functional>
#include <variant>

namespace femoop::plane {

namespace {

constexpr int n_sections = 8;       // of an edge, in each of which a place along a table is met once at most
constexpr double far_apart = 1e-12; // of the edge: nearer to its end, or to another one, a kink is none

/// The place in (a, b) where f changes its sign. \pre it does
double root(const std::function<double(double)>& f, double a, double b)
{
    const bool is_low_at_a = f(a) < 0.0;
    while (true) {
        const double middle = 0.5 * (a + b);
        if (!(a < middle && middle < b)) return middle;
        ((f(middle) < 0.0) == is_low_at_a ? a : b) = middle;
    }
}

/// Adds where an edge meets a row of a table.
void add_kinks(const Field::Table& table, const std::function<FieldPlace(double)>& place, std::vector<double>& kinks)
{
    const auto along = [&](double xi) { return place_along(table, place(xi)); };
    double begin = -1.0, at_begin = along(begin);
    for (int i = 1; i <= n_sections; ++i) {
        const double end = -1.0 + 2.0 * i / n_sections, at_end = along(end);
        const auto [low, high] = std::minmax(at_begin, at_end);
        for (const auto& row : table.rows)
            if (low < row.first && row.first <= high)
                kinks.push_back(root([&](double xi) { return along(xi) - row.first; }, begin, end));
        begin = end;
        at_begin = at_end;
    }
}

} // namespace

FieldPlace place_of(const Eigen::Vector2d& at) { return {.x = at.x(), .y = at.y()}; }

double value_or_zero(const std::optional<Field>& field, const FieldPlace& at)
{
    return field ? value(*field, at) : 0.0;
}

FieldPlace EdgeTraction::place(double xi) const
{
    const double along = is_reversed ? -xi : xi;
    FieldPlace at = place_of(curve->at(edge, along));
    at.s = curve->s(edge, along);
    at.length = curve->length();
    return at;
}

Eigen::Vector2d EdgeTraction::operator()(const EdgePoint& point) const
{
    const FieldPlace at = place(point.xi);
    if (load->kind == CurveLoadKind::Pressure) return -value_or_zero(load->value, at) * point.outward;
    const Eigen::Vector2d q = per_area * Eigen::Vector2d(value_or_zero(load->qx, at), value_or_zero(load->qy, at));
    if (load->axes == LoadAxes::Global) return q;
    const Eigen::Vector2d along = is_reversed ? Eigen::Vector2d(-point.along) : point.along;
    return q.x() * along + q.y() * Eigen::Vector2d(-along.y(), along.x());
}

std::vector<double> EdgeTraction::kinks() const
{
    std::vector<double> found;
    for (const auto* field : {&load->value, &load->qx, &load->qy})
        if (const auto* table = *field ? std::get_if<Field::Table>(&(*field)->form) : nullptr)
            add_kinks(
                *table, [this](double xi) { return place(xi); }, found);
    std::ranges::sort(found);
    double last = -1.0;
    std::erase_if(found, [&](double kink) {
        if (kink - last <= far_apart || 1.0 - kink <= far_apart) return true;
        last = kink;
        return false;
    });
    return found;
}

} // namespace femoop::plane
