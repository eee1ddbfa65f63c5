#include "apps/frame/predict/guess.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace frame {

namespace {

constexpr double reach = 0.03; // of the length: a hand that is so near to an end means the end

bool is_number(const StrokePoint& point) { return std::isfinite(point.x) && std::isfinite(point.value); }

// The same ordinate at the end that the point is near to.
std::optional<StrokePoint> end_near(const StrokePoint& point)
{
    if (point.x > 0.0 && point.x <= reach) return StrokePoint{0.0, point.value};
    if (point.x < 1.0 && point.x >= 1.0 - reach) return StrokePoint{1.0, point.value};
    return std::nullopt;
}

} // namespace

void Guess::draw(std::span<const StrokePoint> stroke)
{
    std::vector<StrokePoint> points;
    std::ranges::copy_if(stroke, std::back_inserter(points), is_number);
    if (points.size() < 2) return;
    if (const auto end = end_near(points.front())) draw_line(*end, points.front());
    for (std::size_t i = 1; i < points.size(); ++i) draw_line(points[i - 1], points[i]);
    if (const auto end = end_near(points.back())) draw_line(points.back(), *end);
}

void Guess::draw_line(const StrokePoint& from, const StrokePoint& to)
{
    constexpr double last = n_places - 1, rounding = 1e-9;
    const auto [left, right] = from.x <= to.x ? std::pair{from, to} : std::pair{to, from};
    const double first_place = std::ceil(std::clamp(left.x, 0.0, 1.0 + 1.0 / last) * last - rounding);
    const double last_place = std::floor(std::clamp(right.x, -1.0 / last, 1.0) * last + rounding);
    for (double place = first_place; place <= last_place; ++place) {
        const double width = right.x - left.x;
        const double t = width > 0.0 ? (place / last - left.x) / width : 0.0;
        values_.at(static_cast<std::size_t>(place)) = width > 0.0 ? std::lerp(left.value, right.value, t) : to.value;
    }
}

bool Guess::is_empty() const
{
    return std::ranges::none_of(values_, [](const auto& value) { return value.has_value(); });
}

double Guess::largest() const
{
    double largest = 0.0;
    for (const auto& value : values_) largest = std::max(largest, std::abs(value.value_or(0.0)));
    return largest;
}

} // namespace frame
