#include "apps/euler/view/draw/hatching.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace euler {

namespace {

/// Which of the lines x + y = constant a point lies on.
double across(ui::Point p) { return p.x + p.y; }

/// Where the line crosses the outline and the holes, by x.
std::vector<double> crossings(const Region& area, double line)
{
    std::vector<double> found;
    for_each_side(area, [&](ui::Point a, ui::Point b) {
        const double da = across(a) - line, db = across(b) - line;
        if ((da >= 0.0) != (db >= 0.0)) found.push_back(a.x + da / (da - db) * (b.x - a.x));
    });
    std::sort(found.begin(), found.end());
    return found;
}

// Lies a place on a line between an odd crossing and the next?
bool is_within(const std::vector<double>& crossings, double x)
{
    return (std::upper_bound(crossings.begin(), crossings.end(), x) - crossings.begin()) % 2 != 0;
}

// The stretches of a line, from one place to the next, that are in the area and behind no cover.
std::vector<std::pair<double, double>> stretches(const Region& area, std::span<const Region* const> covers, double line)
{
    const std::vector<double> own = crossings(area, line);
    std::vector<std::vector<double>> others;
    std::vector<double> ends = own;
    for (const Region* cover : covers) {
        others.push_back(crossings(*cover, line));
        ends.insert(ends.end(), others.back().begin(), others.back().end());
    }
    std::sort(ends.begin(), ends.end());
    std::vector<std::pair<double, double>> free;
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
        const double middle = 0.5 * (ends[i] + ends[i + 1]);
        const auto covers_it = [&](const std::vector<double>& other) { return is_within(other, middle); };
        if (!is_within(own, middle) || std::ranges::any_of(others, covers_it)) continue;
        if (!free.empty() && free.back().second == ends[i]) free.back().second = ends[i + 1];
        else free.emplace_back(ends[i], ends[i + 1]);
    }
    return free;
}

} // namespace

void hatch(ui::Painter& painter, const Region& area, std::span<const Region* const> covers, double spacing,
           const ui::Stroke& stroke)
{
    constexpr double most_lines = 400.0;
    const double step = spacing * std::numbers::sqrt2;
    const auto [least, most] = std::minmax_element(area.front().begin(), area.front().end(),
                                                   [](ui::Point a, ui::Point b) { return across(a) < across(b); });
    const double first = std::ceil(across(*least) / step), last = std::floor(across(*most) / step);
    if (!(last - first < most_lines)) return;
    for (double k = first; k <= last; k += 1.0) {
        const double line = k * step;
        for (const auto& [from, to] : stretches(area, covers, line))
            painter.line({from, line - from}, {to, line - to}, stroke);
    }
}

} // namespace euler
