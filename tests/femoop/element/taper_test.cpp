// A tapered beam against integrals in closed form, and against Simpson's rule where there is none.
#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <cmath>
#include <functional>

#include "femoop/element/bar.h"
#include "femoop/element/beam.h"

using namespace femoop;

namespace {

constexpr double length = 3.7, EI0 = 5300.0, GAs0 = 910.0, EA0 = 8.3e5, tip_load = 11.0, line_load = 6.1;
constexpr double U = 2.3, c = (U - 1.0) / length; // h(x) = h(0) (1 + c x), 2.3 times as deep at its second end

/// Of a rectangle: A in proportion to h, I to h^3.
Taper rectangle(double growth = c)
{
    const double smallest = std::min(1.0, 1.0 + growth * length);
    return {.depth = growth,
            .area = growth,
            .shear_area = growth,
            .inertia = {3.0 * growth, 3.0 * growth * growth, growth * growth * growth},
            .longest_piece = smallest / std::abs(growth) / 6.0};
}

Beam tapered(double shear_flexibility = 0.0)
{
    return {.EI = EI0, .shear_flexibility = shear_flexibility, .taper = rectangle()};
}

SpanLoading loaded(const Beam& beam, const std::vector<SpanLoad>& loads)
{
    SpanLoading loading;
    const std::array<SpanLoading::Scaled, 1> terms{{{.loads = loads}}};
    beam.cut(loading, length, terms);
    return loading;
}

double simpson(const std::function<double(double)>& f)
{
    constexpr int n = 4000;
    double sum = f(0.0) + f(length);
    for (int i = 1; i < n; ++i) sum += (i % 2 == 1 ? 4.0 : 2.0) * f(length * i / n);
    return sum * length / n / 3.0;
}

double EI_at(double x) { return EI0 * std::pow(1.0 + c * x, 3); }

doctest::Approx near(double value) { return doctest::Approx(value).epsilon(1e-11); }

} // namespace

TEST_SUITE("taper")
{
    TEST_CASE("A tapered cantilever's tip sags P ((U^2 - 1) / 2 - 2 (U - 1) + ln U) / (EI c^3)")
    {
        const Eigen::Vector2d tip = tapered().stiffness(length).bottomRightCorner<2, 2>().inverse() *
                                    Eigen::Vector2d(tip_load, 0.0);
        CHECK(tip[0] == near(tip_load / (EI0 * c * c * c) * (0.5 * (U * U - 1.0) - 2.0 * (U - 1.0) + std::log(U))));
        CHECK(tip[1] == near(simpson([](double x) { return tip_load * (length - x) / EI_at(x); })));
    }

    TEST_CASE("Where it shears too, the tip sags P ln U / (c GAs) more")
    {
        const auto sag = [](const Beam& beam) {
            return (beam.stiffness(length).bottomRightCorner<2, 2>().inverse() * Eigen::Vector2d(tip_load, 0.0))[0];
        };
        CHECK(sag(tapered(1.0 / GAs0)) - sag(tapered()) == near(tip_load * std::log(U) / (c * GAs0)));
    }

    TEST_CASE("A tapered bar lengthens N ln U / (c EA), and its displacement goes with ln (1 + c x)")
    {
        const Bar bar{.EA = EA0, .taper = c};
        CHECK(bar.stiffness(length)(0, 0) == near(EA0 * c / std::log(U)));
        const double x = 0.23; // within one piece
        CHECK(bar.at(x, {.N = tip_load}, {.end = length}, LocalAxis::x, 0.0).u ==
              near(tip_load * std::log(1.0 + c * x) / (c * EA0)));
        CHECK(bar.at(x, {.N = tip_load}, {.begin = 1.7, .end = length}, LocalAxis::x, 0.0).u ==
              near(tip_load * std::log((1.0 + c * (1.7 + x)) / (1.0 + c * 1.7)) / (c * EA0)));
    }

    TEST_CASE("A uniform load's fixed-end moments undo the rotations of the simple span")
    {
        const Beam beam = tapered();
        const Eigen::Vector4d f = beam.fixed_end_forces(
            loaded(beam, {{.to = length, .start = -line_load, .end = -line_load}}), BendingPlane::xy);
        const auto M0 = [](double x) { return 0.5 * line_load * x * (length - x); };
        const Eigen::Vector2d turned(-simpson([&](double x) { return M0(x) * (1.0 - x / length) / EI_at(x); }),
                                     simpson([&](double x) { return M0(x) * x / length / EI_at(x); }));
        const Eigen::Vector2d held = -(beam.chord_stiffness(length) * turned);
        CHECK(f[1] == near(held[0]));
        CHECK(f[3] == near(held[1]));
        CHECK(f[0] == near(0.5 * line_load * length + (held[0] + held[1]) / length));
        CHECK(std::abs(f[3]) > 1.5 * f[1]); // the deep end draws the moment
    }

    TEST_CASE("A temperature's gradient bends it by curvature h(0) / h(x)")
    {
        const Beam beam = tapered();
        const double curvature = 0.013;
        const Eigen::Vector4d f = beam.fixed_end_forces(
            loaded(beam, {{.kind = SpanLoad::Kind::Strain, .start = 0.0, .end = curvature}}), BendingPlane::xy);
        const auto bent = [&](double x) { return curvature / (1.0 + c * x); };
        const Eigen::Vector2d turned(-simpson([&](double x) { return bent(x) * (1.0 - x / length); }),
                                     simpson([&](double x) { return bent(x) * x / length; }));
        const Eigen::Vector2d held = -(beam.chord_stiffness(length) * turned);
        CHECK(f[1] == near(held[0]));
        CHECK(f[3] == near(held[1]));
    }

    TEST_CASE("Read from its other end it is the same beam")
    {
        Beam turned = tapered(1.0 / GAs0);
        turned.EI = EI0 * U * U * U;
        turned.shear_flexibility /= U;
        turned.taper = rectangle((1.0 / U - 1.0) / length);
        const Eigen::Matrix2d S = tapered(1.0 / GAs0).chord_stiffness(length), other = turned.chord_stiffness(length);
        CHECK(S(0, 0) == near(other(1, 1)));
        CHECK(S(1, 1) == near(other(0, 0)));
        CHECK(S(0, 1) == near(other(0, 1)));
    }

    TEST_CASE("A taper that vanishes leaves the prismatic beam")
    {
        Beam beam = tapered(1.0 / GAs0);
        beam.taper = rectangle(1e-9);
        const Beam prismatic{.EI = EI0, .shear_flexibility = 1.0 / GAs0};
        CHECK((beam.stiffness(length) - prismatic.stiffness(length)).norm() <=
              1e-7 * prismatic.stiffness(length).norm());
    }
}
