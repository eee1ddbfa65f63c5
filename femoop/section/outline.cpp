#include "femoop/section/outline.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "femoop/section/profile.h"
#include "femoop/section/shape.h"

namespace femoop {

namespace {

using Points = std::vector<OutlinePoint>;

/// From the lower left corner of the box around the figure: z to the right, y up.
struct Corner {
    double z, y;
};

Points polygon(std::initializer_list<Corner> corners)
{
    Points points;
    for (const Corner& corner : corners) points.push_back({.y = corner.y, .z = corner.z});
    return points;
}

Points circle(double centre, double radius)
{
    constexpr int n = 72;
    Points points;
    for (int i = 0; i < n; ++i) {
        const double t = 2.0 * std::numbers::pi * i / n;
        points.push_back({.y = centre + radius * std::sin(t), .z = centre + radius * std::cos(t)});
    }
    return points;
}

Points reversed(Points points)
{
    std::ranges::reverse(points);
    return points;
}

struct Flanged {
    double h, bf, tf, tw, r = 0.0;
};

/// A quarter of a circle of radius r about (z, y), from the angle `begin` on, clockwise: the fillet of an inner corner.
void add_fillet(Points& points, const Corner& centre, double r, double begin)
{
    const int n = r > 0.0 ? 6 : 0;
    for (int i = 0; i <= n; ++i) {
        const double t = begin - 0.5 * std::numbers::pi * i / std::max(n, 1);
        points.push_back({.y = centre.y + r * std::sin(t), .z = centre.z + r * std::cos(t)});
    }
}

Points rolled_i(const Flanged& f)
{
    constexpr double right_angle = 0.5 * std::numbers::pi;
    const double web = 0.5 * (f.bf + f.tw), back = 0.5 * (f.bf - f.tw), under = f.h - f.tf;
    Points points = polygon({{0, 0}, {f.bf, 0}, {f.bf, f.tf}});
    add_fillet(points, {web + f.r, f.tf + f.r}, f.r, -right_angle);
    add_fillet(points, {web + f.r, under - f.r}, f.r, 2.0 * right_angle);
    for (const Corner& corner : {Corner{f.bf, under}, {f.bf, f.h}, {0, f.h}, {0, under}})
        points.push_back({.y = corner.y, .z = corner.z});
    add_fillet(points, {back - f.r, under - f.r}, f.r, right_angle);
    add_fillet(points, {back - f.r, f.tf + f.r}, f.r, 0.0);
    points.push_back({.y = f.tf, .z = 0.0});
    return points;
}

Points rolled_c(const Flanged& f)
{
    constexpr double right_angle = 0.5 * std::numbers::pi;
    Points points = polygon({{0, 0}, {f.bf, 0}, {f.bf, f.tf}});
    add_fillet(points, {f.tw + f.r, f.tf + f.r}, f.r, -right_angle);
    add_fillet(points, {f.tw + f.r, f.h - f.tf - f.r}, f.r, 2.0 * right_angle);
    for (const Corner& corner : {Corner{f.bf, f.h - f.tf}, {f.bf, f.h}, {0, f.h}})
        points.push_back({.y = corner.y, .z = corner.z});
    return points;
}

Points tee(const Flanged& f)
{
    const double left = 0.5 * (f.bf - f.tw), right = 0.5 * (f.bf + f.tw), under = f.h - f.tf;
    return polygon(
        {{left, 0}, {right, 0}, {right, under}, {f.bf, under}, {f.bf, f.h}, {0, f.h}, {0, under}, {left, under}});
}

Points angle(double h, double b, double t) { return polygon({{0, 0}, {b, 0}, {b, t}, {t, t}, {t, h}, {0, h}}); }

Points rectangle(double b, double h, double inset = 0.0)
{
    return polygon({{inset, inset}, {b - inset, inset}, {b - inset, h - inset}, {inset, h - inset}});
}

/// Area and its first moments, by Green's theorem: exact for straight edges.
struct FirstMoments {
    double A = 0.0, y = 0.0, z = 0.0;

    void add(const Points& points)
    {
        for (std::size_t i = 0; i < points.size(); ++i) {
            const auto& [y1, z1] = points[i];
            const auto& [y2, z2] = points[(i + 1) % points.size()];
            const double cross = z1 * y2 - z2 * y1;
            A += cross / 2.0;
            y += cross * (y1 + y2) / 6.0;
            z += cross * (z1 + z2) / 6.0;
        }
    }
};

SectionOutline about_centroid(Points outer, Points hole = {})
{
    FirstMoments moments;
    moments.add(outer);
    moments.add(hole);
    for (Points* const points : {&outer, &hole})
        for (OutlinePoint& point : *points) {
            point.y -= moments.y / moments.A;
            point.z -= moments.z / moments.A;
        }
    const auto [bottom, top] = std::ranges::minmax(outer, {}, &OutlinePoint::y);
    const auto [left, right] = std::ranges::minmax(outer, {}, &OutlinePoint::z);
    return {std::move(outer), std::move(hole), top.y, bottom.y, left.z, right.z};
}

SectionOutline of_profile(const Profile& p, const Units& units)
{
    const double k = metres(p.unit) / metres(units.length);
    const Flanged f{k * p.h, k * p.bf, k * p.tf, k * p.tw, k * p.r};
    return about_centroid(p.family == ProfileFamily::UPN ? rolled_c(f) : rolled_i(f));
}

} // namespace

SectionOutline outline(const Shape& shape)
{
    if (const auto fault = why_not(shape)) throw std::invalid_argument(message(*fault));
    const auto flanged = [&] { return Flanged{.h = *shape.h, .bf = *shape.bf, .tf = *shape.tf, .tw = *shape.tw}; };
    switch (shape.kind) {
    case ShapeKind::Rectangle: return about_centroid(rectangle(*shape.b, *shape.h));
    case ShapeKind::Circle: return about_centroid(circle(*shape.d / 2.0, *shape.d / 2.0));
    case ShapeKind::Tube:
        return about_centroid(circle(*shape.d / 2.0, *shape.d / 2.0),
                              reversed(circle(*shape.d / 2.0, *shape.d / 2.0 - *shape.t)));
    case ShapeKind::Box:
        return about_centroid(rectangle(*shape.b, *shape.h), reversed(rectangle(*shape.b, *shape.h, *shape.t)));
    case ShapeKind::I: return about_centroid(rolled_i(flanged()));
    case ShapeKind::T: return about_centroid(tee(flanged()));
    case ShapeKind::L: return about_centroid(angle(*shape.h, *shape.b, *shape.t));
    case ShapeKind::C: return about_centroid(rolled_c(flanged()));
    }
    throw std::invalid_argument("no such shape");
}

std::optional<SectionOutline> outline(const Section& section, const Units& units)
{
    if (section.shape) return why_not(*section.shape) ? std::nullopt : std::optional(outline(*section.shape));
    const Profile* const profile = section.profile ? find_profile(*section.profile) : nullptr;
    return profile != nullptr ? std::optional(of_profile(*profile, units)) : std::nullopt;
}

} // namespace femoop
