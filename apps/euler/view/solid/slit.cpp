#include "apps/euler/view/solid/slit.h"

#include <algorithm>
#include <cstddef>
#include <limits>

namespace euler {

using topology::Point;

namespace {

struct Corner {
    ui::Point flat;
    Point space;
};
using Rim = std::vector<Corner>;

/// The corners at the two ends of a slit.
struct Slit {
    std::size_t from; ///< of the outline
    std::size_t to;   ///< of the ring
    double length;
};

bool cross_inside(ui::Point a, ui::Point b, ui::Point c, ui::Point d)
{
    const auto side = [](ui::Point p, ui::Point q, ui::Point r) { return ui::cross(q - p, r - p); };
    return side(a, b, c) * side(a, b, d) < 0.0 && side(c, d, a) * side(c, d, b) < 0.0;
}

bool meets(ui::Point a, ui::Point b, const Rim& rim)
{
    for (std::size_t i = 0; i < rim.size(); ++i)
        if (cross_inside(a, b, rim[i].flat, rim[(i + 1) % rim.size()].flat)) return true;
    return false;
}

/// The shortest slit that crosses no rim; the shortest of all where each does.
Slit best_slit(const Rim& outline, const Rim& ring, const std::vector<Rim>& rings)
{
    std::vector<Slit> slits;
    for (std::size_t i = 0; i < outline.size(); ++i)
        for (std::size_t j = 0; j < ring.size(); ++j)
            slits.push_back({i, j, ui::distance(outline[i].flat, ring[j].flat)});
    std::stable_sort(slits.begin(), slits.end(), [](const Slit& a, const Slit& b) { return a.length < b.length; });
    const auto is_free = [&](const Slit& slit) {
        const ui::Point a = outline[slit.from].flat, b = ring[slit.to].flat;
        return !meets(a, b, outline) &&
               std::none_of(rings.begin(), rings.end(), [&](const Rim& other) { return meets(a, b, other); });
    };
    const auto found = std::find_if(slits.begin(), slits.end(), is_free);
    return found != slits.end() ? *found : slits.front();
}

/// A corner moved a little towards another.
Corner moved(const Corner& corner, const Corner& toward, double by)
{
    const double apart = ui::distance(corner.flat, toward.flat);
    const double share = apart > 0.0 ? std::min(by / apart, 0.5) : 0.0;
    return {corner.flat + share * (toward.flat - corner.flat), corner.space + share * (toward.space - corner.space)};
}

/// Out to the ring, around it, and back on the other side of the slit, whose ends are moved along the rims.
Rim joined(const Rim& outline, const Rim& ring, const Slit& slit, double width)
{
    const std::size_t n = outline.size(), m = ring.size();
    Rim result(outline.begin(), outline.begin() + static_cast<std::ptrdiff_t>(slit.from + 1));
    for (std::size_t k = 0; k < m; ++k) result.push_back(ring[(slit.to + k) % m]);
    result.push_back(moved(ring[slit.to], ring[(slit.to + m - 1) % m], width));
    result.push_back(moved(outline[slit.from], outline[(slit.from + 1) % n], width));
    result.insert(result.end(), outline.begin() + static_cast<std::ptrdiff_t>(slit.from + 1), outline.end());
    return result;
}

/// The ring that the shortest slit reaches.
std::size_t nearest(const Rim& outline, const std::vector<Rim>& rings)
{
    const auto away = [&](const Rim& ring) {
        double least = std::numeric_limits<double>::infinity();
        for (const Corner& a : outline)
            for (const Corner& b : ring) least = std::min(least, ui::distance(a.flat, b.flat));
        return least;
    };
    std::vector<double> distances(rings.size());
    std::transform(rings.begin(), rings.end(), distances.begin(), away);
    return static_cast<std::size_t>(std::min_element(distances.begin(), distances.end()) - distances.begin());
}

} // namespace

std::vector<Point> joined_by_slits(const std::vector<std::vector<Point>>& rims,
                                   const std::function<ui::Point(const Point&)>& flat, double width)
{
    std::vector<Rim> rings;
    for (const auto& rim : rims) {
        rings.emplace_back();
        for (const Point& p : rim) rings.back().push_back({flat(p), p});
    }
    Rim outline = std::move(rings.front());
    rings.erase(rings.begin());
    while (!rings.empty()) {
        const std::size_t next = nearest(outline, rings);
        outline = joined(outline, rings[next], best_slit(outline, rings[next], rings), width);
        rings.erase(rings.begin() + static_cast<std::ptrdiff_t>(next));
    }
    std::vector<Point> points;
    for (const Corner& corner : outline) points.push_back(corner.space);
    return points;
}

} // namespace euler
