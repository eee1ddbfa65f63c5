#include "topology/modeling/lamina.h"

#include <cmath>
#include <numbers>

namespace topology {

HalfEdgeId wire(EulerOperator& op, HalfEdgeId corner, const std::vector<Point>& points)
{
    for (const Point& p : points) corner = op.mev(corner, p).plus;
    return corner;
}

Lamina lamina(EulerOperator& op, const std::vector<Point>& points)
{
    const LoneVertex first = op.mvfs(points.front());
    const HalfEdgeId last = wire(op, first.half_edge, {points.begin() + 1, points.end()});
    const NewFace front = op.mef(first.half_edge, last);
    return {front.face, first.face, first.half_edge};
}

std::vector<Point> arc_points(const Arc& arc, int n)
{
    std::vector<Point> points;
    for (int i = 0; i <= n; ++i) {
        const double angle = arc.from + (arc.to - arc.from) * i / n;
        points.push_back({arc.radius * std::cos(angle), 0.0, arc.radius * std::sin(angle)});
    }
    return points;
}

std::vector<Point> regular_polygon(int n, double radius)
{
    std::vector<Point> points;
    for (int i = 0; i < n; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / n;
        points.push_back({radius * std::cos(angle), radius * std::sin(angle), 0.0});
    }
    return points;
}

} // namespace topology
