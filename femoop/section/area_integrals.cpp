#include "femoop/section/area_integrals.h"

#include <algorithm>
#include <cmath>

namespace femoop {

namespace {

/// Of an arc z = zc + s sqrt(r^2 - (y - yc)^2).
struct Arc {
    explicit Arc(const OutlineSide& side)
        : yc(side.centre->y),
          zc(side.centre->z),
          r(std::hypot(side.from.y - yc, side.from.z - zc)),
          s(side.from.z + side.to.z >= 2.0 * zc ? 1.0 : -1.0)
    {}
    double half_chord(double u) const { return std::sqrt(std::max(0.0, (r - u) * (r + u))); }

    /// The integrals of s sqrt(r^2 - u^2) (yc + u)^k from the middle to u.
    AreaIntegrals of_bow(double u) const
    {
        const double w = half_chord(u), turn = std::asin(std::clamp(u / r, -1.0, 1.0));
        const double f0 = 0.5 * (u * w + r * r * turn), f1 = -w * w * w / 3.0,
                     f2 = 0.125 * (u * w * (2.0 * u * u - r * r) + r * r * r * r * turn);
        return {s * f0, s * (f1 + yc * f0), s * (f2 + 2.0 * yc * f1 + yc * yc * f0)};
    }

    double yc, zc, r, s;
};

/// Of the area between the y' axis and a straight line from (a, za) to (b, zb).
AreaIntegrals of_line(double a, double za, double b, double zb)
{
    const double d = b - a;
    return {d * (za + zb) / 2.0, d * (za * (2.0 * a + b) + zb * (a + 2.0 * b)) / 6.0,
            d * (za * (3.0 * a * a + 2.0 * a * b + b * b) + zb * (a * a + 2.0 * a * b + 3.0 * b * b)) / 12.0};
}

AreaIntegrals of_arc(const OutlineSide& side, double a, double b)
{
    const Arc arc(side);
    const AreaIntegrals strip = of_line(a, arc.zc, b, arc.zc), to = arc.of_bow(b - arc.yc),
                        from = arc.of_bow(a - arc.yc);
    return {strip.area + to.area - from.area, strip.first + to.first - from.first,
            strip.second + to.second - from.second};
}

} // namespace

double z_at(const OutlineSide& side, double y)
{
    if (side.centre) {
        const Arc arc(side);
        return arc.zc + arc.s * arc.half_chord(y - arc.yc);
    }
    const double t = (y - side.from.y) / (side.to.y - side.from.y);
    return side.from.z + t * (side.to.z - side.from.z);
}

AreaIntegrals integrals_between(const std::vector<OutlineSide>& sides, double low, double high)
{
    AreaIntegrals sum;
    for (const OutlineSide& side : sides) {
        const double a = std::clamp(side.from.y, low, high), b = std::clamp(side.to.y, low, high);
        if (a == b) continue;
        const AreaIntegrals one = side.centre ? of_arc(side, a, b) : of_line(a, z_at(side, a), b, z_at(side, b));
        sum.area += one.area;
        sum.first += one.first;
        sum.second += one.second;
    }
    return sum;
}

} // namespace femoop
