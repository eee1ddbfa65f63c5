#include "femoop/section/section_properties.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>

#include "femoop/section/profile.h"
#include "femoop/section/shape.h"

namespace femoop {

namespace {

using std::numbers::pi;
constexpr double squared(double x) { return x * x; }
constexpr double cubed(double x) { return x * x * x; }

double rectangle_torsion(double b, double h)
{
    const double a = std::max(b, h);
    const double c = std::min(b, h);
    // The sum of tanh(n pi a / 2 c) / n^5 = sum of 1 / n^5, known, less 2 / (n^5 (exp(n pi a / c) + 1)), which
    // dies out like exp(-n pi): six terms reach the last bit even for the square.
    constexpr double zeta_5 = 1.0369277551433699263;
    double sum = 31.0 / 32.0 * zeta_5;
    for (int n = 1; n <= 11; n += 2) sum -= 2.0 / (std::pow(n, 5) * (std::exp(n * pi * a / c) + 1.0));
    return a * cubed(c) * (1.0 / 3.0 - 64.0 * c * sum / (std::pow(pi, 5) * a));
}

SectionProperties rectangle_properties(double b, double h)
{
    const double A = b * h;
    return {.A = A,
            .Iy = h * cubed(b) / 12.0,
            .Iz = b * cubed(h) / 12.0,
            .J = rectangle_torsion(b, h),
            .Asy = 5.0 / 6.0 * A,
            .Asz = 5.0 / 6.0 * A,
            .h = h,
            .yc = h / 2.0,
            .b = b,
            .zc = b / 2.0,
            .Wy = h * squared(b) / 6.0,
            .Wz = b * squared(h) / 6.0};
}

/// A ring of outer diameter d; t = d/2 makes the full circle.
SectionProperties ring_properties(double d, double t, double shear_factor)
{
    const double A = pi * t * (d - t);
    const double I = A / 16.0 * (squared(d) + squared(d - 2.0 * t));
    const double As = shear_factor * A;
    const double W = 2.0 * I / d;
    const double r = d / 2.0;
    return {.A = A,
            .Iy = I,
            .Iz = I,
            .J = 2.0 * I,
            .Asy = As,
            .Asz = As,
            .h = d,
            .yc = r,
            .b = d,
            .zc = r,
            .Wy = W,
            .Wz = W};
}

SectionProperties box(double b, double h, double t)
{
    const double bi = b - 2.0 * t;
    const double hi = h - 2.0 * t;
    const double Iy = (h * cubed(b) - hi * cubed(bi)) / 12.0;
    const double Iz = (b * cubed(h) - bi * cubed(hi)) / 12.0;
    return {.A = 2.0 * t * (b + h - 2.0 * t),
            .Iy = Iy,
            .Iz = Iz,
            .J = 2.0 * t * squared((b - t) * (h - t)) / (b + h - 2.0 * t),
            .Asy = 2.0 * h * t,
            .Asz = 2.0 * b * t,
            .h = h,
            .yc = h / 2.0,
            .b = b,
            .zc = b / 2.0,
            .Wy = 2.0 * Iy / b,
            .Wz = 2.0 * Iz / h};
}

/// One straight part of an open shape; y from the -y' fibre, z from the -z' fibre.
struct RectanglePart {
    double y, z;   ///< its centre
    double dy, dz; ///< its sides along y' and z'
};

/// All of an open shape but its shear areas.
SectionProperties built_up(std::span<const RectanglePart> parts, double h, double b)
{
    SectionProperties s;
    double y = 0.0;
    double z = 0.0;
    for (const RectanglePart& p : parts) {
        s.A += p.dy * p.dz;
        y += p.dy * p.dz * p.y;
        z += p.dy * p.dz * p.z;
        s.J += std::max(p.dy, p.dz) * cubed(std::min(p.dy, p.dz)) / 3.0;
    }
    y /= s.A;
    z /= s.A;
    for (const RectanglePart& p : parts) {
        const double area = p.dy * p.dz;
        s.Iz += area * (squared(p.dy) / 12.0 + squared(p.y - y));
        s.Iy += area * (squared(p.dz) / 12.0 + squared(p.z - z));
        s.Iyz += area * (p.y - y) * (p.z - z);
    }
    s.h = h;
    s.yc = y;
    s.b = b;
    s.zc = z;
    s.Wz = s.Iz / std::max(y, h - y);
    s.Wy = s.Iy / std::max(z, b - z);
    return s;
}

SectionProperties with_shear_areas(SectionProperties s, double Asy, double Asz)
{
    s.Asy = Asy;
    s.Asz = Asz;
    return s;
}

struct FlangedShape {
    double h, bf, tf, tw;
};

double web_area(const FlangedShape& f) { return f.h * f.tw; }
double flange_area(const FlangedShape& f) { return 5.0 / 6.0 * f.bf * f.tf; }

/// i and c differ in where the web stands: its centre is at z.
SectionProperties two_flanges(const FlangedShape& f, double z)
{
    const std::array parts{RectanglePart{f.h - f.tf / 2.0, f.bf / 2.0, f.tf, f.bf},
                           RectanglePart{f.h / 2.0, z, f.h - 2.0 * f.tf, f.tw},
                           RectanglePart{f.tf / 2.0, f.bf / 2.0, f.tf, f.bf}};
    SectionProperties s = built_up(parts, f.h, f.bf);
    s.yc = f.h / 2.0; // symmetric: no rounding may say otherwise
    s.Wz = 2.0 * s.Iz / f.h;
    s.Iyz = 0.0;
    return with_shear_areas(s, web_area(f), 2.0 * flange_area(f));
}

SectionProperties tee_properties(const FlangedShape& f)
{
    const double stem = f.h - f.tf;
    const std::array parts{RectanglePart{f.h - f.tf / 2.0, f.bf / 2.0, f.tf, f.bf},
                           RectanglePart{stem / 2.0, f.bf / 2.0, stem, f.tw}};
    SectionProperties s = built_up(parts, f.h, f.bf);
    s.Iyz = 0.0;
    return with_shear_areas(s, web_area(f), flange_area(f));
}

SectionProperties angle_properties(double h, double b, double t)
{
    const std::array parts{RectanglePart{h / 2.0, t / 2.0, h, t}, RectanglePart{t / 2.0, (b + t) / 2.0, t, b - t}};
    return with_shear_areas(built_up(parts, h, b), 5.0 / 6.0 * h * t, 5.0 / 6.0 * b * t);
}

SectionProperties scaled_properties(SectionProperties s, double k)
{
    const double k2 = squared(k);
    for (double* I : {&s.Iy, &s.Iz, &s.J, &s.Iyz}) *I *= squared(k2);
    for (std::optional<double>* W : {&s.Wy, &s.Wz})
        if (*W) **W *= k2 * k;
    for (std::optional<double>* As : {&s.Asy, &s.Asz})
        if (*As) **As *= k2;
    for (std::optional<double>* length : {&s.h, &s.yc, &s.b, &s.zc})
        if (*length) **length *= k;
    s.A *= k2;
    return s;
}

/// As of the shape that the profile is like: i, c, l, tube or box.
SectionProperties with_shear_areas(const SectionProperties& s, const Profile& p)
{
    const FlangedShape f{p.h, p.bf, p.tf, p.tw};
    switch (p.family) {
    case ProfileFamily::L: return with_shear_areas(s, 5.0 / 6.0 * p.h * p.tw, 5.0 / 6.0 * p.bf * p.tf);
    case ProfileFamily::CHS: return with_shear_areas(s, 0.5 * p.A, 0.5 * p.A);
    case ProfileFamily::SHS:
    case ProfileFamily::RHS: return with_shear_areas(s, 2.0 * p.h * p.tw, 2.0 * p.bf * p.tf);
    case ProfileFamily::IPE:
    case ProfileFamily::HEA:
    case ProfileFamily::HEB:
    case ProfileFamily::HEM:
    case ProfileFamily::UPN:
    case ProfileFamily::W:
    case ProfileFamily::WMetric:
    case ProfileFamily::HPMetric: break;
    }
    return with_shear_areas(s, web_area(f), 2.0 * flange_area(f));
}

SectionProperties profile_properties(const std::string& text, const Units& units)
{
    const Profile* profile = find_profile(text);
    if (profile == nullptr) throw std::invalid_argument("no profile \"" + text + "\"");
    const Profile& p = *profile;
    const SectionProperties s = with_shear_areas({.A = p.A,
                                                  .Iy = p.Iy,
                                                  .Iz = p.Iz,
                                                  .J = p.J,
                                                  .Iyz = p.Iyz,
                                                  .h = p.h,
                                                  .yc = p.yc,
                                                  .b = p.bf,
                                                  .zc = p.zc,
                                                  .Wy = p.Wy,
                                                  .Wz = p.Wz},
                                                 p);
    return p.unit == units.length ? s : scaled_properties(s, metres(p.unit) / metres(units.length));
}

void override_depth(SectionProperties& s, const Section& section)
{
    if (section.h) {
        const double centre = s.h && s.yc ? *s.yc / *s.h : 0.5;
        s.h = *section.h;
        s.yc = centre * *s.h;
    }
    if (section.yc) s.yc = *section.yc;
    if (section.Iz || section.h || section.yc)
        s.Wz = s.h ? std::optional(s.Iz / std::max(*s.yc, *s.h - *s.yc)) : std::nullopt;
}

} // namespace

SectionProperties shape_properties(const SectionShape& shape)
{
    if (const auto fault = why_not(shape)) throw std::invalid_argument(message(*fault));
    const auto flanged = [&] { return FlangedShape{.h = *shape.h, .bf = *shape.bf, .tf = *shape.tf, .tw = *shape.tw}; };
    switch (shape.kind) {
    case SectionShapeKind::Rectangle: return rectangle_properties(*shape.b, *shape.h);
    case SectionShapeKind::Circle: return ring_properties(*shape.d, *shape.d / 2.0, 0.9);
    case SectionShapeKind::Tube: return ring_properties(*shape.d, *shape.t, 0.5);
    case SectionShapeKind::Box: return box(*shape.b, *shape.h, *shape.t);
    case SectionShapeKind::I: return two_flanges(flanged(), *shape.bf / 2.0);
    case SectionShapeKind::T: return tee_properties(flanged());
    case SectionShapeKind::L: return angle_properties(*shape.h, *shape.b, *shape.t);
    case SectionShapeKind::C: return two_flanges(flanged(), *shape.tw / 2.0);
    }
    throw std::invalid_argument("no such shape");
}

SectionProperties turned(const SectionProperties& upright)
{
    SectionProperties s = upright;
    std::swap(s.Iy, s.Iz);
    std::swap(s.Asy, s.Asz);
    std::swap(s.Wy, s.Wz);
    s.Iyz = 0.0 - upright.Iyz; // and no negative zero
    s.h = upright.b;
    s.yc = upright.zc;
    s.b = upright.h;
    if (upright.h && upright.yc) s.zc = *upright.h - *upright.yc;
    return s;
}

SectionProperties section_properties(const Section& section, const Units& units)
{
    SectionProperties s;
    if (section.shape) s = shape_properties(*section.shape);
    else if (section.profile) s = profile_properties(*section.profile, units);
    if (section.turned) s = turned(s);

    if (section.A) s.A = *section.A;
    if (section.Iy) {
        s.Iy = *section.Iy;
        s.Wy.reset();
    }
    if (section.Iz) s.Iz = *section.Iz;
    if (section.J) s.J = *section.J;
    if (section.Asy) s.Asy = *section.Asy;
    if (section.Asz) s.Asz = *section.Asz;
    override_depth(s, section);
    return s;
}

} // namespace femoop
