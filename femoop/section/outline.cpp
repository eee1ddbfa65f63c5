#include "femoop/section/outline.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "femoop/section/area_integrals.h"
#include "femoop/section/profile.h"
#include "femoop/section/shape.h"

namespace femoop {

namespace {

constexpr int pieces_of_fillet = 6, pieces_of_quarter_circle = 18;

/// From the lower left corner of the box around the figure: z to the right, y up.
struct Corner {
    double z, y;
};

OutlinePoint point(const Corner& corner) { return {.y = corner.y, .z = corner.z}; }

/// A closed line, walked from side to side.
class Walk {
public:
    explicit Walk(const Corner& begin) : at_(point(begin)), begin_(at_) {}

    Walk& to(const Corner& corner)
    {
        if (point(corner) != at_) sides_.push_back({.from = at_, .to = point(corner)});
        at_ = point(corner);
        return *this;
    }
    /// Along a circle; of radius 0 it goes nowhere.
    Walk& around(const Corner& centre, const Corner& end, int pieces = pieces_of_fillet)
    {
        if (point(end) != at_)
            sides_.push_back({.from = at_, .to = point(end), .centre = point(centre), .pieces = pieces});
        at_ = point(end);
        return *this;
    }
    std::vector<OutlineSide> closed()
    {
        to({begin_.z, begin_.y});
        return std::move(sides_);
    }

private:
    OutlinePoint at_, begin_;
    std::vector<OutlineSide> sides_;
};

using Sides = std::vector<OutlineSide>;

Sides polygon(std::initializer_list<Corner> corners)
{
    Walk walk(*corners.begin());
    for (const Corner& corner : corners) walk.to(corner);
    return walk.closed();
}

Sides circle(double middle, double radius)
{
    const Corner centre{middle, middle};
    constexpr int n = pieces_of_quarter_circle;
    return Walk({middle + radius, middle})
        .around(centre, {middle, middle + radius}, n)
        .around(centre, {middle - radius, middle}, n)
        .around(centre, {middle, middle - radius}, n)
        .around(centre, {middle + radius, middle}, n)
        .closed();
}

Sides reversed(Sides sides)
{
    std::ranges::reverse(sides);
    for (OutlineSide& side : sides) std::swap(side.from, side.to);
    return sides;
}

struct Flanged {
    double h, bf, tf, tw, r = 0.0;
};

Sides rolled_i(const Flanged& f)
{
    const double web = 0.5 * (f.bf + f.tw), back = 0.5 * (f.bf - f.tw), under = f.h - f.tf, r = f.r;
    return Walk({0, 0})
        .to({f.bf, 0})
        .to({f.bf, f.tf})
        .to({web + r, f.tf})
        .around({web + r, f.tf + r}, {web, f.tf + r})
        .to({web, under - r})
        .around({web + r, under - r}, {web + r, under})
        .to({f.bf, under})
        .to({f.bf, f.h})
        .to({0, f.h})
        .to({0, under})
        .to({back - r, under})
        .around({back - r, under - r}, {back, under - r})
        .to({back, f.tf + r})
        .around({back - r, f.tf + r}, {back - r, f.tf})
        .to({0, f.tf})
        .closed();
}

Sides c(const Flanged& f)
{
    const double under = f.h - f.tf;
    return polygon(
        {{0, 0}, {f.bf, 0}, {f.bf, f.tf}, {f.tw, f.tf}, {f.tw, under}, {f.bf, under}, {f.bf, f.h}, {0, f.h}});
}

/// The inner face of a flange falls from the web to the toe; both ends are rounded.
struct TaperedFlange {
    TaperedFlange(const Flanged& f, double slope, double at)
        : root{f.tw + f.r, 0.0}, toe{f.bf - 0.5 * f.r, 0.0}, root_end{}, toe_end{}
    {
        const double n = std::hypot(1.0, slope); // (slope, 1)/n is square to the face
        root.y = f.tf + slope * (at - root.z) + f.r * n;
        toe.y = f.tf + slope * (at - toe.z) - 0.5 * f.r * n;
        root_end = {root.z - f.r * slope / n, root.y - f.r / n};
        toe_end = {toe.z + 0.5 * f.r * slope / n, toe.y + 0.5 * f.r / n};
    }
    Corner root, toe;         ///< centres
    Corner root_end, toe_end; ///< where the arcs meet the face
};

Sides rolled_c(const Flanged& f, double slope, double at)
{
    const TaperedFlange low(f, slope, at);
    const auto high = [&](const Corner& corner) { return Corner{corner.z, f.h - corner.y}; };
    return Walk({0, 0})
        .to({f.bf, 0})
        .to({f.bf, low.toe.y})
        .around(low.toe, low.toe_end)
        .to(low.root_end)
        .around(low.root, {f.tw, low.root.y})
        .to(high({f.tw, low.root.y}))
        .around(high(low.root), high(low.root_end))
        .to(high(low.toe_end))
        .around(high(low.toe), high({f.bf, low.toe.y}))
        .to({f.bf, f.h})
        .to({0, f.h})
        .closed();
}

Sides tee(const Flanged& f)
{
    const double left = 0.5 * (f.bf - f.tw), right = 0.5 * (f.bf + f.tw), under = f.h - f.tf;
    return polygon(
        {{left, 0}, {right, 0}, {right, under}, {f.bf, under}, {f.bf, f.h}, {0, f.h}, {0, under}, {left, under}});
}

Sides angle(double h, double b, double t) { return polygon({{0, 0}, {b, 0}, {b, t}, {t, t}, {t, h}, {0, h}}); }

Sides rolled_angle(const Flanged& f)
{
    const double toe = 0.5 * f.r, t = f.tw, r = f.r;
    return Walk({0, 0})
        .to({f.bf, 0})
        .to({f.bf, t - toe})
        .around({f.bf - toe, t - toe}, {f.bf - toe, t})
        .to({t + r, t})
        .around({t + r, t + r}, {t, t + r})
        .to({t, f.h - toe})
        .around({t - toe, f.h - toe}, {t - toe, f.h})
        .to({0, f.h})
        .closed();
}

/// With rounded corners, `inset` from a box of b and h.
Sides rounded_rectangle(double b, double h, double r, double inset = 0.0)
{
    const double left = inset, right = b - inset, low = inset, high = h - inset;
    return Walk({left + r, low})
        .to({right - r, low})
        .around({right - r, low + r}, {right, low + r})
        .to({right, high - r})
        .around({right - r, high - r}, {right - r, high})
        .to({left + r, high})
        .around({left + r, high - r}, {left, high - r})
        .to({left, low + r})
        .around({left + r, low + r}, {left + r, low})
        .closed();
}

Sides rectangle(double b, double h, double inset = 0.0)
{
    return polygon({{inset, inset}, {b - inset, inset}, {b - inset, h - inset}, {inset, h - inset}});
}

/// The same figure with y' and z' exchanged, so that integrals over y' are those over z'; it runs the other way round.
Sides exchanged(Sides sides)
{
    for (OutlineSide& side : sides) {
        std::swap(side.from.y, side.from.z);
        std::swap(side.to.y, side.to.z);
        if (side.centre) std::swap(side.centre->y, side.centre->z);
    }
    return sides;
}

/// The centroid's height in a figure that begins at 0; that of a symmetric one has no rounding.
double centroid(const Sides& sides)
{
    double size = 0.0;
    for (const OutlineSide& side : sides) size = std::max(size, side.to.y);
    const AreaIntegrals sums = integrals_between(sides, 0.0, size);
    const double height = sums.first / sums.area, middle = 0.5 * size;
    return std::abs(height - middle) < 1e-12 * size ? middle : height;
}

/// Corners, and the points between them along arcs.
std::vector<OutlinePoint> points_of(const Sides& sides)
{
    std::vector<OutlinePoint> points;
    for (const OutlineSide& side : sides) {
        points.push_back(side.from);
        if (!side.centre) continue;
        const auto [y, z] = *side.centre;
        const double r = std::hypot(side.from.y - y, side.from.z - z),
                     begin = std::atan2(side.from.y - y, side.from.z - z),
                     turn = std::remainder(std::atan2(side.to.y - y, side.to.z - z) - begin, 2.0 * std::numbers::pi);
        for (int i = 1; i < side.pieces; ++i) {
            const double t = begin + turn * i / side.pieces;
            points.push_back({.y = y + r * std::sin(t), .z = z + r * std::cos(t)});
        }
    }
    return points;
}

SectionOutline about_centroid(Sides outer, Sides hole = {})
{
    Sides all = outer;
    all.insert(all.end(), hole.begin(), hole.end());
    const double y = centroid(all), z = centroid(exchanged(all));
    for (Sides* const sides : {&outer, &hole, &all})
        for (OutlineSide& side : *sides) {
            for (OutlinePoint* const point : {&side.from, &side.to}) *point = {point->y - y, point->z - z};
            if (side.centre) side.centre = OutlinePoint{side.centre->y - y, side.centre->z - z};
        }
    const auto points = points_of(outer);
    const auto [bottom, top] = std::ranges::minmax(points, {}, &OutlinePoint::y);
    const auto [left, right] = std::ranges::minmax(points, {}, &OutlinePoint::z);
    return {std::move(all), points, points_of(hole), top.y, bottom.y, left.z, right.z};
}

SectionOutline of_upn(const Flanged& f, double h_cm)
{
    const bool is_small = h_cm < 30.5; // up to UPN 300
    return about_centroid(is_small ? rolled_c(f, 0.08, 0.5 * f.bf) : rolled_c(f, 0.05, 0.5 * (f.bf + f.tw)));
}

SectionOutline of_tube(double d, double t)
{
    return about_centroid(circle(0.5 * d, 0.5 * d), reversed(circle(0.5 * d, 0.5 * d - t)));
}

SectionOutline of_profile(const Profile& p, const Units& units)
{
    const double k = metres(p.unit) / metres(units.length);
    const Flanged f{k * p.h, k * p.bf, k * p.tf, k * p.tw, k * p.r};
    switch (p.family) {
    case ProfileFamily::UPN: return of_upn(f, p.h);
    case ProfileFamily::L: return about_centroid(rolled_angle(f));
    case ProfileFamily::CHS: return of_tube(f.h, f.tw);
    case ProfileFamily::SHS:
    case ProfileFamily::RHS:
        return about_centroid(rounded_rectangle(f.bf, f.h, f.r), reversed(rounded_rectangle(f.bf, f.h, f.tw, f.tw)));
    case ProfileFamily::IPE:
    case ProfileFamily::HEA:
    case ProfileFamily::HEB:
    case ProfileFamily::HEM:
    case ProfileFamily::W:
    case ProfileFamily::WMetric:
    case ProfileFamily::HPMetric: break;
    }
    return about_centroid(rolled_i(f));
}

} // namespace

SectionOutline outline(const SectionShape& shape)
{
    if (const auto fault = why_not(shape)) throw std::invalid_argument(message(*fault));
    const auto flanged = [&] { return Flanged{.h = *shape.h, .bf = *shape.bf, .tf = *shape.tf, .tw = *shape.tw}; };
    switch (shape.kind) {
    case SectionShapeKind::Rectangle: return about_centroid(rectangle(*shape.b, *shape.h));
    case SectionShapeKind::Circle: return about_centroid(circle(*shape.d / 2.0, *shape.d / 2.0));
    case SectionShapeKind::Tube: return of_tube(*shape.d, *shape.t);
    case SectionShapeKind::Box:
        return about_centroid(rectangle(*shape.b, *shape.h), reversed(rectangle(*shape.b, *shape.h, *shape.t)));
    case SectionShapeKind::I: return about_centroid(rolled_i(flanged()));
    case SectionShapeKind::T: return about_centroid(tee(flanged()));
    case SectionShapeKind::L: return about_centroid(angle(*shape.h, *shape.b, *shape.t));
    case SectionShapeKind::C: return about_centroid(c(flanged()));
    }
    throw std::invalid_argument("no such shape");
}

SectionOutline turned(const SectionOutline& upright)
{
    const auto turn = [](OutlinePoint& point) { point = {.y = point.z, .z = -point.y}; };
    SectionOutline all = upright;
    for (OutlineSide& side : all.sides) {
        turn(side.from);
        turn(side.to);
        if (side.centre) turn(*side.centre);
    }
    for (OutlinePoint& point : all.outer) turn(point);
    for (OutlinePoint& point : all.hole) turn(point);
    all.top = upright.right;
    all.bottom = upright.left;
    all.left = -upright.top;
    all.right = -upright.bottom;
    return all;
}

namespace {

std::optional<SectionOutline> upright_outline(const Section& section, const Units& units)
{
    if (section.shape) return why_not(*section.shape) ? std::nullopt : std::optional(outline(*section.shape));
    const Profile* const profile = section.profile ? find_profile(*section.profile) : nullptr;
    return profile != nullptr ? std::optional(of_profile(*profile, units)) : std::nullopt;
}

} // namespace

std::optional<SectionOutline> outline(const Section& section, const Units& units)
{
    const auto upright = upright_outline(section, units);
    return upright && section.turned ? std::optional(turned(*upright)) : upright;
}

} // namespace femoop
