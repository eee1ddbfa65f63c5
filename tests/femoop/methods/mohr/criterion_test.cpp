#include "femoop/methods/mohr/criterion.h"

#include <doctest/doctest.h>

#include <cmath>

#include "tests/femoop/methods/mohr/degree.h"

using namespace femoop::mohr;
using doctest::Approx;

TEST_SUITE_BEGIN("femoop mohr");

namespace {

constexpr SpaceState loaded_state{-19.0, 24.6, -58.3, -14.7, 11.8, 16.45};
constexpr Strength strengths{
    .fy = 250.0, .ft = 31.0, .fc = 290.0, .c = 21.0, .phi = 33.0 * degree, .sci = 120.0, .m = 9.0, .s = 0.7};
constexpr Criterion all[] = {Criterion::Tresca,      Criterion::VonMises,      Criterion::Rankine,
                             Criterion::MohrCoulomb, Criterion::DruckerPrager, Criterion::HoekBrown};

SpacePrincipal scaled(double k)
{
    SpaceState s = loaded_state;
    for (double SpaceState::*part :
         {&SpaceState::x, &SpaceState::y, &SpaceState::z, &SpaceState::xy, &SpaceState::yz, &SpaceState::zx})
        s.*part *= k;
    return principal(s);
}

/// How far the shear lies below the curve there; positive inside.
double room_below(const std::vector<Curve>& curves, double normal, double shear)
{
    double room = 1e9;
    for (const Curve& curve : curves)
        for (std::size_t i = 1; i < curve.size(); ++i) {
            const auto [lower, upper] = std::minmax(curve[i - 1].normal, curve[i].normal);
            if (normal < lower || normal > upper || upper == lower) continue;
            const double t = (normal - curve[i - 1].normal) / (curve[i].normal - curve[i - 1].normal);
            room = std::min(room, curve[i - 1].shear + t * (curve[i].shear - curve[i - 1].shear) - shear);
        }
    return room;
}

} // namespace

TEST_CASE("A stress that is multiplied by its safety factor fails by every criterion: the factor there is 1")
{
    for (const Criterion criterion : all) {
        CAPTURE(static_cast<int>(criterion));
        const auto factor = safety(criterion, strengths, scaled(1.0)).factor;
        REQUIRE(factor);
        CHECK(*safety(criterion, strengths, scaled(*factor)).factor == Approx(1.0));
        CHECK(*safety(criterion, strengths, scaled(0.5)).factor == Approx(2.0 * *factor));
    }
}

TEST_CASE("Uniaxial tension and compression fail at the strengths that are known of the criteria")
{
    const auto factor = [](Criterion criterion, double stress) {
        return safety(criterion, strengths, principal(SpaceState{.x = stress})).factor;
    };
    CHECK(*factor(Criterion::Tresca, 100.0) == Approx(2.5));
    CHECK(*factor(Criterion::VonMises, -100.0) == Approx(2.5));
    CHECK(*factor(Criterion::Rankine, 31.0) == Approx(1.0));
    CHECK(*factor(Criterion::Rankine, -290.0) == Approx(1.0));
    const double fc = 2.0 * 21.0 * std::tan(45.0 * degree + 16.5 * degree);
    CHECK(*factor(Criterion::MohrCoulomb, -fc) == Approx(1.0));
    CHECK(*factor(Criterion::MohrCoulomb, 2.0 * 21.0 / std::tan(61.5 * degree)) == Approx(1.0));
    CHECK(*factor(Criterion::DruckerPrager, -fc) == Approx(1.0));
    CHECK(*factor(Criterion::HoekBrown, -120.0 * std::sqrt(0.7)) == Approx(1.0));
}

TEST_CASE("In pure shear von Mises fails at fy over root three and Tresca at half of fy")
{
    const SpacePrincipal shear = principal(SpaceState{.xy = 100.0});
    CHECK(*safety(Criterion::VonMises, strengths, shear).factor == Approx(2.5 / std::sqrt(3.0)));
    CHECK(*safety(Criterion::Tresca, strengths, shear).factor == Approx(1.25));
}

TEST_CASE("Hydrostatic pressure never fails and hydrostatic tension fails where the criterion has a tip")
{
    const SpacePrincipal pressure = principal(SpaceState{.x = -5.0, .y = -5.0, .z = -5.0});
    for (const Criterion criterion : {Criterion::Tresca, Criterion::VonMises, Criterion::MohrCoulomb,
                                      Criterion::DruckerPrager, Criterion::HoekBrown}) {
        CAPTURE(static_cast<int>(criterion));
        CHECK_FALSE(safety(criterion, strengths, pressure).factor);
        CHECK(safety(criterion, strengths, pressure).planes.empty());
    }
    const auto tension = [](Criterion criterion, double t) {
        return safety(criterion, strengths, principal(SpaceState{.x = t, .y = t, .z = t})).factor;
    };
    CHECK(*tension(Criterion::MohrCoulomb, 21.0 / std::tan(33.0 * degree)) == Approx(1.0));
    CHECK(*tension(Criterion::HoekBrown, 0.7 * 120.0 / 9.0) == Approx(1.0));
    CHECK_FALSE(tension(Criterion::VonMises, 7.0));
}

TEST_CASE("On a failing plane of Mohr and Coulomb the shear is the cohesion less the friction")
{
    const double k = *safety(Criterion::MohrCoulomb, strengths, scaled(1.0)).factor;
    const auto planes = safety(Criterion::MohrCoulomb, strengths, scaled(k)).planes;
    REQUIRE(planes.size() == 2);
    for (const auto& normal : planes) {
        const OnPlane on = on_plane(loaded_state, normal);
        CHECK(k * on.shear == Approx(21.0 - k * on.normal_component * std::tan(33.0 * degree)));
    }
}

TEST_CASE("A failing plane touches the envelope and every other plane lies below it")
{
    for (const Criterion criterion : {Criterion::Tresca, Criterion::MohrCoulomb, Criterion::HoekBrown}) {
        CAPTURE(static_cast<int>(criterion));
        const Safety s = safety(criterion, strengths, scaled(1.0));
        const SpacePrincipal failing = scaled(*s.factor);
        const auto curves = envelope(criterion, strengths, -400.0, 400.0);
        const Circle circle = circles(failing)[0];
        double tightest = 1e9;
        for (int i = 0; i <= 720; ++i) {
            const double t = i * 0.25 * degree;
            tightest = std::min(
                tightest, room_below(curves, circle.centre + circle.radius * std::cos(t), circle.radius * std::sin(t)));
        }
        CHECK(std::abs(tightest) < 0.02 * circle.radius);
        const OnPlane on = on_plane(loaded_state, s.planes.front());
        CHECK(std::abs(room_below(curves, *s.factor * on.normal_component, *s.factor * on.shear)) <
              0.02 * circle.radius);
    }
}

TEST_CASE("Circles of failing plane stresses touch von Mises' ellipse and Drucker and Prager's curve")
{
    for (const Criterion criterion : {Criterion::VonMises, Criterion::DruckerPrager})
        for (const SpaceState& plane :
             {SpaceState{.x = 30.0, .y = -50.0, .xy = 20.0}, SpaceState{.x = -30.0, .y = -80.0, .xy = 5.0}}) {
            CAPTURE(static_cast<int>(criterion));
            const double k = *safety(criterion, strengths, principal(plane)).factor;
            const Circle c = circle({k * plane.x, k * plane.y, k * plane.xy});
            const auto curves = envelope(criterion, strengths, -600.0, 600.0);
            double tightest = 1e9;
            for (int i = 1; i < 720; ++i) {
                const double t = i * 0.25 * degree;
                tightest = std::min(tightest,
                                    room_below(curves, c.centre + c.radius * std::cos(t), c.radius * std::sin(t)));
            }
            CHECK(std::abs(tightest) < 0.02 * c.radius);
        }
}

TEST_CASE("A strength that a criterion cannot use is named")
{
    Strength wrong = strengths;
    wrong.phi = 90.0 * degree;
    CHECK(why_not(Criterion::MohrCoulomb, wrong)->flaw == StrengthFlaw::AngleOutOfRange);
    CHECK_FALSE(why_not(Criterion::Tresca, wrong));
    wrong.fy = std::nan("");
    CHECK(why_not(Criterion::VonMises, wrong)->value == &Strength::fy);
    wrong.s = 1.1;
    CHECK(why_not(Criterion::HoekBrown, wrong)->flaw == StrengthFlaw::AboveOne);
    for (const Criterion criterion : all) CHECK_FALSE(why_not(criterion, strengths));
}

TEST_SUITE_END();
