#include "apps/euler/view/draw/hatching.h"

#include <algorithm>
#include <cmath>
#include <numbers>
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

} // namespace

void hatch(ui::Painter& painter, const Region& area, double spacing, const ui::Stroke& stroke)
{
    constexpr double most_lines = 400.0;
    const double step = spacing * std::numbers::sqrt2;
    const auto [least, most] = std::minmax_element(area.front().begin(), area.front().end(),
                                                   [](ui::Point a, ui::Point b) { return across(a) < across(b); });
    const double first = std::ceil(across(*least) / step), last = std::floor(across(*most) / step);
    if (!(last - first < most_lines)) return;
    for (double k = first; k <= last; k += 1.0) {
        const double line = k * step;
        const std::vector<double> xs = crossings(area, line);
        for (std::size_t i = 0; i + 1 < xs.size(); i += 2)
            painter.line({xs[i], line - xs[i]}, {xs[i + 1], line - xs[i + 1]}, stroke);
    }
}

} // namespace euler
