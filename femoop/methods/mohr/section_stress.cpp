#include "femoop/methods/mohr/section_stress.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "femoop/methods/mohr/rounding.h"
#include "femoop/section/area_integrals.h"
#include "femoop/section/section_properties.h"

namespace femoop::mohr {

namespace {

/// The length of a horizontal line inside a figure, just above or just below a height.
double width(const std::vector<OutlineSide>& sides, double y, CutSide where)
{
    double sum = 0.0; // sides that go up bound the figure on the right, sides that go down on the left
    const auto is_over = [&](double corner) { return where == CutSide::Above ? corner > y : corner >= y; };
    for (const OutlineSide& side : sides)
        if (is_over(side.from.y) != is_over(side.to.y)) sum += (is_over(side.to.y) ? 1.0 : -1.0) * z_at(side, y);
    return std::abs(sum);
}

} // namespace

SectionFigure::SectionFigure(SectionOutline outline) : outline_(std::move(outline))
{
    const AreaIntegrals all = integrals_between(outline_.sides, bottom(), top());
    area_ = all.area;
    Iz_ = all.second;
}

SectionFigure::SectionFigure(const SectionShape& shape) : SectionFigure(femoop::outline(shape)) {}

SectionFigure::SectionFigure(const Section& section, const Units& units)
    : SectionFigure(femoop::outline(section, units).value())
{
    if (!section.profile) return;
    const SectionProperties published = section_properties(section, units);
    area_ = published.A;
    Iz_ = published.Iz;
}

Cut SectionFigure::cut(double y, CutSide side) const
{
    // About the centroid the whole has no first moment, so that the smaller part tells it: 0 at either edge.
    const double Q = y >= 0.0 ? integrals_between(outline_.sides, std::min(y, top()), top()).first
                              : -integrals_between(outline_.sides, bottom(), std::max(y, bottom())).first;
    return {y, width(outline_.sides, y, side), Q};
}

std::vector<double> SectionFigure::corners() const
{
    std::vector<double> all;
    for (const std::vector<OutlinePoint>* points : {&outline_.outer, &outline_.hole})
        for (const OutlinePoint& p : *points) all.push_back(p.y);
    std::sort(all.begin(), all.end());
    const double near = 1e-9 * outline_.height();
    all.erase(std::unique(all.begin(), all.end(), [&](double a, double b) { return b - a < near; }), all.end());
    return all;
}

FibreStress stress(const SectionFigure& section, const SectionForces& forces, double y, CutSide side)
{
    const Cut cut = section.cut(y, side);
    FibreStress s{cut, sum_of({forces.N / section.area(), -forces.M * y / section.Iz()})};
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
