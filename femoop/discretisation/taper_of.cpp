#include "femoop/discretisation/taper_of.h"

#include <algorithm>
#include <cmath>

namespace femoop {

namespace {

/// A rectangle B x h without its two openings, which are B - w wide and reach from flange to flange.
struct Walls {
    double B = 0.0, w = 0.0, t = 0.0;
};

Walls walls_of(const SectionShape& shape)
{
    switch (shape.kind) {
    case SectionShapeKind::Rectangle: return {.B = *shape.b, .w = *shape.b};
    case SectionShapeKind::Box: return {.B = *shape.b, .w = 2.0 * *shape.t, .t = *shape.t};
    default: return {.B = *shape.bf, .w = *shape.tw, .t = *shape.tf};
    }
}

} // namespace

Taper taper_of(const Section& section, double first, double second, double length)
{
    const auto [B, w, t] = walls_of(*section.shape);
    const double slope = (second - first) / length, opening = first - 2.0 * t;
    const double A = w * first + 2.0 * (B - w) * t;
    const double Iz_12 = B * std::pow(first, 3) - (B - w) * std::pow(opening, 3);
    Taper taper;
    taper.depth = taper.shear_area = slope / first;
    taper.area = w * slope / A;
    taper.inertia = {3.0 * slope * (B * first * first - (B - w) * opening * opening) / Iz_12,
                     3.0 * slope * slope * (B * first - (B - w) * opening) / Iz_12, slope * slope * slope * w / Iz_12};
    // No zero of Iz, as a complex function of h, has a real part above t; those of A and Asy have none above 0.
    constexpr double share = 1.0 / 6.0; // of the way to the nearest zero
    if (slope != 0.0) taper.longest_piece = share * (std::min(first, second) - t) / std::abs(slope);
    return taper;
}

} // namespace femoop
