#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include <doctest/doctest.h>

#include "femoop/section/section_properties.h"
#include "femoop/section/shape.h"
#include "tests/femoop/section/outline.h"

using namespace femoop;
using doctest::Approx;

namespace {

using std::numbers::pi;
constexpr double h = 0.37, b = 0.23, bf = 0.19, tf = 0.031, tw = 0.017, t = 0.013, d = 0.29;

SectionShape rectangle()
{
    return {.kind = SectionShapeKind::Rectangle, .b = b, .h = h, .d = {}, .t = {}, .bf = {}, .tf = {}, .tw = {}};
}
SectionShape box()
{
    return {.kind = SectionShapeKind::Box, .b = b, .h = h, .d = {}, .t = t, .bf = {}, .tf = {}, .tw = {}};
}
SectionShape angle()
{
    return {.kind = SectionShapeKind::L, .b = b, .h = h, .d = {}, .t = t, .bf = {}, .tf = {}, .tw = {}};
}
SectionShape round(SectionShapeKind kind, std::optional<Quantity> wall)
{
    return {.kind = kind, .b = {}, .h = {}, .d = d, .t = std::move(wall), .bf = {}, .tf = {}, .tw = {}};
}
SectionShape flanged(SectionShapeKind kind)
{
    return {.kind = kind, .b = {}, .h = h, .d = {}, .t = {}, .bf = bf, .tf = tf, .tw = tw};
}

struct Case {
    SectionShape shape;
    AreaMoments moments;
    double width;
};

/// Every shape of straight edges, with its outline as its picture shows it.
std::vector<Case> straight_shapes()
{
    const auto rect = [](double z0, double z1, double y0, double y1) {
        return std::vector<OutlinePoint>{{z0, y0}, {z1, y0}, {z1, y1}, {z0, y1}};
    };
    const std::vector<OutlinePoint> hole{{t, t}, {t, h - t}, {b - t, h - t}, {b - t, t}};
    const double w0 = (bf - tw) / 2.0, w1 = (bf + tw) / 2.0;
    const std::vector<OutlinePoint> i{{0, 0},  {bf, 0}, {bf, tf},    {w1, tf},     {w1, h - tf}, {bf, h - tf},
                                      {bf, h}, {0, h},  {0, h - tf}, {w0, h - tf}, {w0, tf},     {0, tf}};
    const std::vector<OutlinePoint> tee{{w0, 0}, {w1, 0}, {w1, h - tf}, {bf, h - tf},
                                        {bf, h}, {0, h},  {0, h - tf},  {w0, h - tf}};
    const std::vector<OutlinePoint> l{{0, 0}, {b, 0}, {b, t}, {t, t}, {t, h}, {0, h}};
    const std::vector<OutlinePoint> c{{0, 0}, {bf, 0}, {bf, tf}, {tw, tf}, {tw, h - tf}, {bf, h - tf}, {bf, h}, {0, h}};
    return {{rectangle(), area_moments(rect(0, b, 0, h)), b},
            {box(), area_moments(hole, area_moments(rect(0, b, 0, h))), b},
            {flanged(SectionShapeKind::I), area_moments(i), bf},
            {flanged(SectionShapeKind::T), area_moments(tee), bf},
            {angle(), area_moments(l), b},
            {flanged(SectionShapeKind::C), area_moments(c), bf}};
}

} // namespace

TEST_CASE("Area, centroid and inertias of every straight shape are those of its outline by Green's theorem")
{
    for (const Case& c : straight_shapes()) {
        CAPTURE(name(c.shape.kind));
        const AreaMoments& m = c.moments;
        const SectionProperties s = shape_properties(c.shape);
        CHECK(s.A == Approx(m.A).epsilon(1e-12));
        CHECK(s.yc.value() == Approx(m.y()).epsilon(1e-12));
        CHECK(s.Iz == Approx(m.about_centroid_yy()).epsilon(1e-12));
        CHECK(s.Iy == Approx(m.about_centroid_zz()).epsilon(1e-12));
        CHECK(std::abs(s.Iyz - m.about_centroid_yz()) < 1e-12 * (s.Iy + s.Iz));
        CHECK(s.h.value() == h);
        CHECK(s.Wz.value() == Approx(m.about_centroid_yy() / std::max(m.y(), h - m.y())).epsilon(1e-12));
        CHECK(s.Wy.value() == Approx(m.about_centroid_zz() / std::max(m.z(), c.width - m.z())).epsilon(1e-12));
    }
}

TEST_CASE("Only the angle has a product of inertia, and it is negative with the corner at -y', -z'")
{
    for (const Case& c : straight_shapes()) {
        CAPTURE(name(c.shape.kind));
        const double Iyz = shape_properties(c.shape).Iyz;
        if (c.shape.kind == SectionShapeKind::L) CHECK(Iyz < 0.0);
        else CHECK(Iyz == 0.0);
    }
}

TEST_CASE("A circle has A = pi d^2/4, I = pi d^4/64, J = 2 I and W = pi d^3/32")
{
    const SectionProperties s = shape_properties(round(SectionShapeKind::Circle, std::nullopt));
    CHECK(s.A == Approx(pi * d * d / 4.0));
    CHECK(s.Iz == Approx(pi * std::pow(d, 4) / 64.0));
    CHECK(s.Iy == s.Iz);
    CHECK(s.J == Approx(pi * std::pow(d, 4) / 32.0));
    CHECK(s.Wz.value() == Approx(pi * std::pow(d, 3) / 32.0));
    CHECK(s.yc.value() == d / 2.0);
}

TEST_CASE("A tube is its outer circle less its bore")
{
    const SectionProperties s = shape_properties(round(SectionShapeKind::Tube, t));
    const double bore = d - 2.0 * t;
    CHECK(s.A == Approx(pi * (d * d - bore * bore) / 4.0));
    CHECK(s.Iz == Approx(pi * (std::pow(d, 4) - std::pow(bore, 4)) / 64.0));
    CHECK(s.J == Approx(pi * (std::pow(d, 4) - std::pow(bore, 4)) / 32.0));
    CHECK(s.Wy.value() == Approx(2.0 * s.Iy / d));
}

TEST_CASE("A tube so thin that its bore's d^4 would cancel keeps I = pi d^3 t / 8")
{
    const double wall = 1e-13;
    CHECK(shape_properties(round(SectionShapeKind::Tube, wall)).Iz ==
          Approx(pi * d * d * d * wall / 8.0).epsilon(1e-11));
}

TEST_CASE("J of a rectangle is k1 (2a)^3 (2b) with the k1 of Timoshenko & Goodier, section 109")
{
    constexpr std::array<std::pair<double, double>, 9> table{{{1.0, 0.1406},
                                                              {1.2, 0.166},
                                                              {1.5, 0.196},
                                                              {2.0, 0.229},
                                                              {2.5, 0.249},
                                                              {3.0, 0.263},
                                                              {4.0, 0.281},
                                                              {5.0, 0.291},
                                                              {10.0, 0.312}}};
    for (const auto& row : table) {
        const double ratio = row.first;
        CAPTURE(ratio);
        const SectionShape shape{.kind = SectionShapeKind::Rectangle,
                                 .b = b,
                                 .h = ratio * b,
                                 .d = {},
                                 .t = {},
                                 .bf = {},
                                 .tf = {},
                                 .tw = {}};
        CHECK(shape_properties(shape).J / (ratio * std::pow(b, 4)) == Approx(row.second).epsilon(3e-3));
    }
}

TEST_CASE("J of a rectangle is Saint-Venant's series, summed here term by term, to 1e-12")
{
    for (const double ratio : {1.0, 1.37, 6.1}) {
        CAPTURE(ratio);
        double sum = 0.0; // smallest first; what is left out is below 1 / (8 n^4)
        for (int n = 4001; n >= 1; n -= 2) sum += std::tanh(n * pi * ratio / 2.0) / std::pow(n, 5);
        const double J = ratio * std::pow(b, 4) * (1.0 / 3.0 - 64.0 * sum / (std::pow(pi, 5) * ratio));
        const SectionShape shape{.kind = SectionShapeKind::Rectangle,
                                 .b = ratio * b,
                                 .h = b,
                                 .d = {},
                                 .t = {},
                                 .bf = {},
                                 .tf = {},
                                 .tw = {}};
        CHECK(std::abs(shape_properties(shape).J - J) < 1e-12 * J);
    }
}

TEST_CASE("A strip's J tends to l t^3 / 3 (1 - 0.630 t / l)")
{
    const SectionShape strip{
        .kind = SectionShapeKind::Rectangle, .b = 1e-4 * h, .h = h, .d = {}, .t = {}, .bf = {}, .tf = {}, .tw = {}};
    const double thin = h * std::pow(1e-4 * h, 3) / 3.0;
    CHECK(shape_properties(strip).J == Approx(thin * (1.0 - 0.63025e-4)).epsilon(1e-8));
}

TEST_CASE("J of a box is Bredt's 4 Am^2 t / s on its mid-line")
{
    const double Am = (b - t) * (h - t), s = 2.0 * (b - t) + 2.0 * (h - t);
    CHECK(shape_properties(box()).J == Approx(4.0 * Am * Am * t / s));
}

TEST_CASE("J of an open shape is the sum of l t^3 / 3 over its rectangles")
{
    const auto third = [](double l, double thickness) { return l * std::pow(thickness, 3) / 3.0; };
    const double web = third(h - 2.0 * tf, tw), flange = third(bf, tf);
    CHECK(shape_properties(flanged(SectionShapeKind::I)).J == Approx(web + 2.0 * flange));
    CHECK(shape_properties(flanged(SectionShapeKind::C)).J == Approx(web + 2.0 * flange));
    CHECK(shape_properties(flanged(SectionShapeKind::T)).J == Approx(third(h - tf, tw) + flange));
    CHECK(shape_properties(angle()).J == Approx(third(h, t) + third(b - t, t)));
}

TEST_CASE("Shear areas: 5A/6, 9A/10, A/2, both walls of a box, web and 5/6 of the flanges, 5/6 of each leg")
{
    const auto areas = [](const SectionShape& shape) {
        const SectionProperties s = shape_properties(shape);
        return std::pair(s.Asy.value(), s.Asz.value());
    };
    const auto same = [](std::pair<double, double> found, double y, double z) {
        CHECK(found.first == Approx(y));
        CHECK(found.second == Approx(z));
    };
    same(areas(rectangle()), 5.0 / 6.0 * b * h, 5.0 / 6.0 * b * h);
    same(areas(round(SectionShapeKind::Circle, std::nullopt)), 0.225 * pi * d * d, 0.225 * pi * d * d);
    same(areas(round(SectionShapeKind::Tube, t)), pi * t * (d - t) / 2.0, pi * t * (d - t) / 2.0);
    same(areas(box()), 2.0 * h * t, 2.0 * b * t);
    same(areas(flanged(SectionShapeKind::I)), h * tw, 5.0 / 3.0 * bf * tf);
    same(areas(flanged(SectionShapeKind::C)), h * tw, 5.0 / 3.0 * bf * tf);
    same(areas(flanged(SectionShapeKind::T)), h * tw, 5.0 / 6.0 * bf * tf);
    same(areas(angle()), 5.0 / 6.0 * h * t, 5.0 / 6.0 * b * t);
}

TEST_CASE("The flange of a t lies at the top: the centroid stands above mid-depth")
{
    CHECK(shape_properties(flanged(SectionShapeKind::T)).yc.value() > h / 2.0);
    CHECK(shape_properties(angle()).yc.value() < h / 2.0);
}
