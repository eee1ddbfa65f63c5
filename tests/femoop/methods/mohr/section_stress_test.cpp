#include "femoop/methods/mohr/section_stress.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "femoop/section/section_properties.h"

using namespace femoop;
using namespace femoop::mohr;
using doctest::Approx;

TEST_SUITE_BEGIN("femoop mohr");

namespace {

constexpr SectionForces forces{.N = 30e3, .V = -70e3, .M = 19e6}; // N, N mm

Shape i_shape()
{
    Shape shape;
    shape.kind = ShapeKind::I;
    shape.h = 300.0;
    shape.bf = 150.0;
    shape.tf = 12.0;
    shape.tw = 8.0;
    return shape;
}

Shape rectangle()
{
    Shape shape;
    shape.kind = ShapeKind::Rectangle;
    shape.b = 90.0;
    shape.h = 210.0;
    return shape;
}

Shape round(ShapeKind kind)
{
    Shape shape;
    shape.kind = kind;
    shape.d = 120.0;
    if (kind == ShapeKind::Tube) shape.t = 9.0;
    return shape;
}

Shape t_shape()
{
    Shape shape = i_shape();
    shape.kind = ShapeKind::T;
    return shape;
}

/// Integrals of the distribution over the depth by the trapezoidal rule: N, V, M again.
SectionForces resultants(const SectionFigure& section)
{
    SectionForces sum;
    const auto all = distribution(section, forces, 4001);
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
    const SectionFigure circle(round(ShapeKind::Circle)), tube(round(ShapeKind::Tube));
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
    for (const Shape& shape : {rectangle(), i_shape(), t_shape(), round(ShapeKind::Circle), round(ShapeKind::Tube)}) {
        const SectionFigure section(shape);
        const SectionProperties expected = shape_properties(shape);
        CHECK(section.area() == Approx(expected.A));
        CHECK(section.Iz() == Approx(expected.Iz));
    }
}

TEST_CASE("The stresses over the depth add up to the section forces that they come from")
{
    for (const Shape& shape : {rectangle(), i_shape(), t_shape(), round(ShapeKind::Circle), round(ShapeKind::Tube)}) {
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
