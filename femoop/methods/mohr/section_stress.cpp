#include "femoop/methods/mohr/section_stress.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace femoop::mohr {

namespace {

using Points = std::vector<OutlinePoint>;

/// Integrals over a polygon that runs counter-clockwise as seen with y' up and z' to the right.
struct Moments {
    double area = 0.0, first = 0.0, second = 0.0; ///< of 1, y and y^2
};

Moments moments(const Points& points)
{
    Moments m;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const OutlinePoint &p = points[i], &q = points[(i + 1) % points.size()];
        const double cross = p.z * q.y - q.z * p.y;
        m.area += 0.5 * cross;
        m.first += cross * (p.y + q.y) / 6.0;
        m.second += cross * (p.y * p.y + p.y * q.y + q.y * q.y) / 12.0;
    }
    return m;
}

/// The part of a polygon above a height.
Points above(const Points& points, double y)
{
    Points part;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const OutlinePoint &p = points[i], &q = points[(i + 1) % points.size()];
        if (p.y >= y) part.push_back(p);
        if ((p.y >= y) == (q.y >= y)) continue;
        const double t = (y - p.y) / (q.y - p.y);
        part.push_back({.y = y, .z = p.z + t * (q.z - p.z)});
    }
    return part;
}

/// The length of a horizontal line inside a polygon, just above or just below a height.
double width(const Points& points, double y, CutSide side)
{
    double sum = 0.0; // sides that go up bound the figure on the right, sides that go down on the left
    const auto is_over = [&](double corner) { return side == CutSide::Above ? corner > y : corner >= y; };
    for (std::size_t i = 0; i < points.size(); ++i) {
        const OutlinePoint &p = points[i], &q = points[(i + 1) % points.size()];
        if (is_over(p.y) == is_over(q.y)) continue;
        const double z = p.z + (y - p.y) / (q.y - p.y) * (q.z - p.z);
        sum += is_over(q.y) ? z : -z;
    }
    return std::abs(sum);
}

/// Chord and first moment of the part of a disc above a height.
Cut disc_cut(double radius, double y)
{
    const double half = std::sqrt(std::max(0.0, radius * radius - y * y));
    return {y, 2.0 * half, 2.0 / 3.0 * half * half * half};
}

} // namespace

SectionFigure::SectionFigure(SectionOutline outline) : outline_(std::move(outline))
{
    const Moments outer = moments(outline_.outer), hole = moments(outline_.hole); // the hole runs the other way round
    area_ = outer.area + hole.area;
    Iz_ = outer.second + hole.second;
}

SectionFigure::SectionFigure(const Shape& shape) : SectionFigure(femoop::outline(shape))
{
    if (shape.kind != ShapeKind::Circle && shape.kind != ShapeKind::Tube) return;
    const double outer = 0.5 * *shape.d, inner = shape.kind == ShapeKind::Tube ? outer - *shape.t : 0.0;
    ring_ = Ring{outer, inner};
    area_ = std::numbers::pi * (outer * outer - inner * inner);
    Iz_ = 0.25 * std::numbers::pi * (std::pow(outer, 4) - std::pow(inner, 4));
}

Cut SectionFigure::cut(double y, CutSide side) const
{
    if (ring_) {
        const Cut outer = disc_cut(ring_->outer, y), inner = disc_cut(ring_->inner, y);
        return {y, outer.width - inner.width, outer.Q - inner.Q};
    }
    const double Q = moments(above(outline_.outer, y)).first + moments(above(outline_.hole, y)).first;
    return {y, width(outline_.outer, y, side) - width(outline_.hole, y, side), Q};
}

std::vector<double> SectionFigure::corners() const
{
    if (ring_) return {-ring_->outer, ring_->outer};
    std::vector<double> all;
    for (const Points* points : {&outline_.outer, &outline_.hole})
        for (const OutlinePoint& p : *points) all.push_back(p.y);
    std::sort(all.begin(), all.end());
    const double near = 1e-9 * outline_.height();
    all.erase(std::unique(all.begin(), all.end(), [&](double a, double b) { return b - a < near; }), all.end());
    return all;
}

FibreStress stress(const SectionFigure& section, const SectionForces& forces, double y, CutSide side)
{
    const Cut cut = section.cut(y, side);
    FibreStress s{cut, forces.N / section.area() - forces.M * y / section.Iz() + 0.0};
    const double thinnest = 1e-9 * (section.top() - section.bottom()); // at a round top there is no width, and no shear
    if (cut.width > thinnest) s.tau = -forces.V * cut.Q / (section.Iz() * cut.width) + 0.0;
    return s;
}

std::vector<FibreStress> distribution(const SectionFigure& section, const SectionForces& forces, std::size_t n)
{
    std::vector<double> heights = section.corners();
    const double low = section.bottom(), high = section.top();
    const std::vector<double> corners = heights;
    for (std::size_t i = 0; i < n; ++i)
        heights.push_back(low +
                          (high - low) * static_cast<double>(i) / static_cast<double>(std::max<std::size_t>(n, 2) - 1));
    std::sort(heights.begin(), heights.end());
    std::vector<FibreStress> all;
    for (const double y : heights) {
        const bool is_corner = std::find(corners.begin(), corners.end(), y) != corners.end();
        const bool is_end = y <= corners.front() || y >= corners.back();
        all.push_back(stress(section, forces, y, y <= corners.front() ? CutSide::Above : CutSide::Below));
        if (is_corner && !is_end) all.push_back(stress(section, forces, y, CutSide::Above));
    }
    return all;
}

double most_stressed(const SectionFigure& section, const SectionForces& forces, std::size_t n)
{
    double most = 0.0, height = section.bottom();
    for (const FibreStress& one : distribution(section, forces, n)) {
        const FibreStress s = stress(section, forces, one.cut.y);
        const double effort = s.sigma * s.sigma + 3.0 * s.tau * s.tau;
        if (effort <= (1.0 + 1e-9) * most) continue; // rounding makes no fibre the hardest
        most = effort;
        height = s.cut.y;
    }
    return height;
}

} // namespace femoop::mohr
