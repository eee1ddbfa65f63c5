#include "ui/paint/mesh/mesh.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace ui {

namespace {

Point place(const Mesh::Vertex& v) { return {static_cast<double>(v.x), static_cast<double>(v.y)}; }

struct Weights {
    double a, b, c;

    double mean(float at_a, float at_b, float at_c) const
    {
        return a * static_cast<double>(at_a) + b * static_cast<double>(at_b) + c * static_cast<double>(at_c);
    }
};

/// Barycentric coordinates of a point inside.
std::optional<Weights> weights(Point p, Point a, Point b, Point c)
{
    const double area = cross(b - a, c - a);
    if (area == 0.0) return std::nullopt;
    const Weights w{cross(b - p, c - p) / area, cross(c - p, a - p) / area, cross(a - p, b - p) / area};
    if (w.a < 0.0 || w.b < 0.0 || w.c < 0.0) return std::nullopt;
    return w;
}

} // namespace

double Mesh::coverage_at(Point p) const
{
    double bare = 1.0;
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
        const Vertex &a = vertices[indices[i]], &b = vertices[indices[i + 1]], &c = vertices[indices[i + 2]];
        const auto w = weights(p, place(a), place(b), place(c));
        if (!w) continue;
        double coverage = w->mean(a.coverage, b.coverage, c.coverage);
        if (a.reach > 0.0F) {
            const double left = w->mean(a.reach, b.reach, c.reach) - std::abs(w->mean(a.across, b.across, c.across));
            coverage *= std::clamp(left, 0.0, 1.0);
        }
        bare *= 1.0 - coverage;
    }
    return 1.0 - bare;
}

} // namespace ui
