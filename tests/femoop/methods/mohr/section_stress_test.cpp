#include "femoop/methods/mohr/section_stress.h"

#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "femoop/section/profile.h"
#include "femoop/section/section_properties.h"

using namespace femoop;
using namespace femoop::mohr;
using doctest::Approx;

TEST_SUITE_BEGIN("femoop mohr");

namespace {

constexpr SectionForces forces{.N = 30e3, .V = -70e3, .M = 19e6}; // N, N mm

SectionShape i_shape()
{
    SectionShape shape;
    shape.kind = SectionShapeKind::I;
    shape.h = 300.0;
    shape.bf = 150.0;
    shape.tf = 12.0;
    shape.tw = 8.0;
    return shape;
}

SectionShape rectangle()
{
    SectionShape shape;
    shape.kind = SectionShapeKind::Rectangle;
    shape.b = 90.0;
    shape.h = 210.0;
    return shape;
}

SectionShape round(SectionShapeKind kind)
{
    SectionShape shape;
    shape.kind = kind;
    shape.d = 120.0;
    if (kind == SectionShapeKind::Tube) shape.t = 9.0;
    return shape;
}

SectionShape t_shape()
{
    SectionShape shape = i_shape();
    shape.kind = SectionShapeKind::T;
    return shape;
}

constexpr Units newtons_and_mm{.length = LengthUnit::mm, .force = ForceUnit::N};

SectionFigure rolled(std::string_view profile)
{
    return {Section{.id = "s", .profile = std::string(profile)}, newtons_and_mm};
}

/// Integrals of the distribution over the depth by the trapezoidal rule: N, V, M again.
SectionForces resultants(const SectionFigure& section, std::size_t n = 4001)
{
    SectionForces sum;
    const auto all = distribution(section, forces, n);
    for (std::size_t i = 1; i < all.size(); ++i) {
        const FibreStress &a = all[i - 1], &b = all[i];
        const double step = 0.5 * (b.cut.y - a.cut.y);
        sum.N += step * (a.sigma * a.cut.width + b.sigma * b.cut.width);
        sum.V -= step * (a.tau * a.cut.width + b.tau * b.cut.width);
        sum.M -= step * (a.sigma * a.cut.y * a.cut.width + b.sigma * b.cut.y * b.cut.width);
    }
    return sum;
}

} // namespace

TEST_CASE("A rectangle's largest shear is three halves of the mean and its edges have the moment over the modulus")
{
    const SectionFigure section(rectangle());
    CHECK(section.Iz() == Approx(90.0 * std::pow(210.0, 3) / 12.0));
    CHECK(std::abs(stress(section, forces, 0.0).tau) == Approx(1.5 * 70e3 / (90.0 * 210.0)));
    CHECK(stress(section, forces, 105.0).tau == Approx(0.0));
    const double W = 90.0 * 210.0 * 210.0 / 6.0;
    CHECK(stress(section, forces, -105.0).sigma == Approx(30e3 / (90.0 * 210.0) + 19e6 / W)); // M stretches -y'
    CHECK(stress(section, forces, 0.0).tau > 0.0);                                            // V < 0 acts along +y'
}

TEST_CASE("A circle's largest shear is four thirds of the mean and a thin tube's nearly twice it")
{
    const SectionFigure circle(round(SectionShapeKind::Circle)), tube(round(SectionShapeKind::Tube));
    CHECK(stress(circle, forces, 0.0).tau == Approx(4.0 / 3.0 * 70e3 / circle.area()));
    const double R = 60.0, r = 51.0;
    CHECK(stress(tube, forces, 0.0).tau ==
          Approx(4.0 / 3.0 * 70e3 / tube.area() * (R * R + R * r + r * r) / (R * R + r * r)));
    CHECK(stress(circle, forces, R).tau == 0.0);
    CHECK(circle.top() == R);
    CHECK(tube.bottom() == -R);
}

TEST_CASE("Where flange meets web the shear jumps by the ratio of the widths and the normal stress does not")
{
    const SectionFigure section(i_shape());
    const FibreStress flange = stress(section, forces, 138.0, CutSide::Above),
                      web = stress(section, forces, 138.0, CutSide::Below);
    CHECK(web.tau == Approx(flange.tau * 150.0 / 8.0));
    CHECK(web.sigma == Approx(flange.sigma));
    CHECK(section.cut(138.0).Q == Approx(150.0 * 12.0 * 144.0));
    CHECK(section.cut(0.0).Q == Approx(150.0 * 12.0 * 144.0 + 8.0 * 138.0 * 69.0));
}

TEST_CASE("Area and inertia of every shape are those of its properties")
{
    for (const SectionShape& shape :
         {rectangle(), i_shape(), t_shape(), round(SectionShapeKind::Circle), round(SectionShapeKind::Tube)}) {
        const SectionFigure section(shape);
        const SectionProperties expected = shape_properties(shape);
        CHECK(section.area() == Approx(expected.A));
        CHECK(section.Iz() == Approx(expected.Iz));
    }
}

TEST_CASE("The stresses over the depth add up to the section forces that they come from")
{
    for (const SectionShape& shape :
         {rectangle(), i_shape(), t_shape(), round(SectionShapeKind::Circle), round(SectionShapeKind::Tube)}) {
        const SectionForces sum = resultants(SectionFigure(shape));
        CAPTURE(static_cast<int>(shape.kind));
        CHECK(sum.N == Approx(forces.N).epsilon(1e-3));
        CHECK(sum.V == Approx(forces.V).epsilon(1e-3));
        CHECK(sum.M == Approx(forces.M).epsilon(1e-3));
    }
}

TEST_CASE("Above the top edge of any section there is nothing so no first moment and no shear")
{
    const SectionFigure section(t_shape());
    CHECK(std::abs(section.cut(section.top()).Q) < 1e-9 * section.Iz());
    CHECK(std::abs(section.cut(section.bottom(), CutSide::Above).Q) < 1e-9 * section.Iz());
}

TEST_CASE("Bending alone stresses the extreme fibre most and shear alone the neutral axis")
{
    const SectionFigure section(rectangle());
    CHECK(std::abs(most_stressed(section, {.N = 0.0, .V = 0.0, .M = 19e6})) == Approx(105.0));
    CHECK(most_stressed(section, {.N = 0.0, .V = -70e3, .M = 0.0}) == Approx(0.0));
    CHECK(most_stressed(section, {.N = 30e3, .V = 0.0, .M = 19e6}) == Approx(-105.0)); // tension adds to tension
}

namespace {

/// How far printed numbers of a family may be from those of the outline: the figures that its table prints.
double rounding_of(ProfileFamily family)
{
    return family == ProfileFamily::W ? 0.0105 : family == ProfileFamily::UPN ? 0.004 : 0.00055;
}

} // namespace

TEST_CASE("An IPE 400 under 100 kN m has 86.47 MPa at its edge, by the second moment that its standard publishes")
{
    const SectionFigure section = rolled("IPE 400");
    const double sigma = stress(section, {.M = 100e6}, 200.0).sigma;
    CHECK(sigma == Approx(-100e6 * 200.0 / 23130e4).epsilon(1e-12));
    CHECK(std::round(100.0 * sigma) == -8647.0);
}

TEST_CASE("An IPE 400 on its side is stressed by its weak axis, and its flanges share the shear")
{
    const SectionFigure section(Section{.id = "s", .profile = "IPE 400", .turned = true}, newtons_and_mm);
    CHECK(stress(section, {.M = 100e6}, 90.0).sigma == Approx(-100e6 * 90.0 / 1318e4).epsilon(1e-12));
    CHECK(section.cut(80.0).width == Approx(2.0 * 13.5));
    CHECK(section.cut(0.0).width == Approx(400.0));
}

TEST_CASE("Every rolled profile is stressed by the area and the second moment that the analysis has of it")
{
    for (const Profile& profile : profiles()) {
        CAPTURE(profile.name);
        const SectionProperties s = section_properties({.id = "s", .profile = std::string(profile.name)},
                                                       newtons_and_mm);
        const SectionFigure section = rolled(profile.name);
        CHECK(section.area() == s.A);
        CHECK(section.Iz() == s.Iz);
        const double y = -0.31 * *s.h;
        CHECK(stress(section, forces, y).sigma == Approx(forces.N / s.A - forces.M * y / s.Iz).epsilon(1e-12));
    }
}

TEST_CASE("Above the axis of every rolled profile lies half its plastic modulus, and its outline has its second moment")
{
    for (const Profile& profile : profiles()) {
        CAPTURE(profile.name);
        const double k = metres(profile.unit) * 1e3, tolerance = rounding_of(profile.family);
        const SectionFigure published = rolled(profile.name), drawn(published.outline());
        if (profile.family == ProfileFamily::L) continue; // no plastic modulus is known
        const double misprint = profile.name == "UPN350" ? 0.022 : tolerance;
        CHECK(2.0 * published.cut(0.0).Q == Approx(profile.Zz * k * k * k).epsilon(misprint));
        CHECK(drawn.Iz() == Approx(published.Iz()).epsilon(tolerance));
        CHECK(drawn.area() == Approx(published.area()).epsilon(profile.family == ProfileFamily::W ? 0.0075 : 0.003));
    }
}

TEST_CASE("The shear stresses of every rolled profile add up to V, but for the rounding of its table")
{
    for (const Profile& profile : profiles()) {
        CAPTURE(profile.name);
        const SectionForces sum = resultants(rolled(profile.name), 401);
        CHECK(sum.V == Approx(forces.V).epsilon(rounding_of(profile.family) + 5e-4));
    }
}

TEST_CASE("At both edges of every rolled profile there is no shear, to the last digit")
{
    for (const Profile& profile : profiles()) {
        CAPTURE(profile.name);
        const SectionFigure section = rolled(profile.name);
        for (const double y : {section.top(), section.bottom()}) {
            CHECK(stress(section, forces, y).tau == 0.0);
            CHECK(stress(section, forces, y, CutSide::Above).tau == 0.0);
        }
    }
}

TEST_CASE("A normal force and a moment that cancel at a fibre leave nothing there")
{
    const SectionFigure section(rectangle());
    const double y = 35.0, M = 19e6, N = M * y * section.area() / section.Iz();
    CHECK(stress(section, {.N = N, .M = M}, y).sigma == 0.0);
    CHECK(stress(section, {.N = 1e-20, .M = 0.0}, y).sigma == Approx(1e-20 / section.area()).epsilon(1e-12));
}

TEST_SUITE_END();
