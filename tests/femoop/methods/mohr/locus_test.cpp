#include "femoop/methods/mohr/locus.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "femoop/methods/mohr/criterion_names.h"
#include "femoop/methods/mohr/plane_state.h"

using namespace femoop::mohr;
using doctest::Approx;

TEST_SUITE_BEGIN("femoop mohr");

namespace {

using std::numbers::pi;
const Strength strength{.fy = 250.0, .ft = 40.0, .fc = 120.0, .c = 60.0, .phi = 0.5, .sci = 150.0, .m = 10.0, .s = 0.7};

} // namespace

TEST_CASE("Von Mises bounds a plane stress by the ellipse s1^2 - s1 s2 + s2^2")
{
    for (const auto& [a, b] : failing_pairs(Criterion::VonMises, strength, 0.0, 1e4, 90))
        CHECK(std::sqrt(a * a - a * b + b * b) == Approx(250.0));
}

TEST_CASE("Tresca bounds a plane stress by a hexagon")
{
    for (const auto& [a, b] : failing_pairs(Criterion::Tresca, strength, 0.0, 1e4, 64))
        CHECK(std::max({std::abs(a), std::abs(b), std::abs(a - b)}) == Approx(250.0));
}

TEST_CASE("In plane strain equal stresses never fail by von Mises where the volume is kept")
{
    const auto pairs = failing_pairs(Criterion::VonMises, strength, 0.5, 9e3, 8);
    CHECK(std::hypot(pairs[1].first, pairs[1].second) == Approx(9e3));
    CHECK(pairs[3].second - pairs[3].first == Approx(2.0 * 250.0 / std::numbers::sqrt3));
}

TEST_CASE("The deviator at failure is a circle of von Mises and a hexagon of Tresca")
{
    const double mises = std::sqrt(2.0 / 3.0) * 250.0;
    for (const double lode : {0.0, 0.3, pi / 6.0, 1.0, pi / 3.0}) {
        CHECK(*failing_deviator(Criterion::VonMises, strength, -37.0, lode) == Approx(mises));
        const double tresca = mises * std::cos(pi / 6.0) / std::cos(lode - pi / 6.0);
        CHECK(*failing_deviator(Criterion::Tresca, strength, 80.0, lode) == Approx(tresca));
    }
}

TEST_CASE("A stress on the deviatoric boundary has the safety factor 1")
{
    for (const Criterion criterion : all_criteria)
        for (const double mean : {-200.0, -10.0, 5.0})
            for (const double lode : {0.1, 0.6, 1.0}) {
                CAPTURE(word(criterion));
                CAPTURE(mean);
                const auto size = failing_deviator(criterion, strength, mean, lode);
                if (!size || *size == 0.0) continue;
                const double reach = std::sqrt(2.0 / 3.0) * *size, turn = 2.0 * pi / 3.0;
                const SpacePrincipal p{.values = {mean + reach * std::cos(lode), mean + reach * std::cos(lode - turn),
                                                  mean + reach * std::cos(lode + turn)}};
                CHECK(*safety(criterion, strength, p).factor == Approx(1.0).epsilon(1e-6));
            }
}

TEST_CASE("A mean tension beyond the apex of the cone fails alone")
{
    CHECK(*failing_deviator(Criterion::MohrCoulomb, strength, 60.0 / std::tan(0.5) + 1.0, 0.4) == 0.0);
    CHECK(*failing_deviator(Criterion::DruckerPrager, strength, 60.0 / std::tan(0.5) + 1.0, 0.4) == 0.0);
}

TEST_CASE("The envelope of a plane strain touches every circle at failure")
{
    for (const Criterion criterion : {Criterion::VonMises, Criterion::DruckerPrager})
        for (const double nu : {0.0, 0.2, 0.3, 0.45}) {
            const auto curve = envelope(criterion, strength, -400.0, 400.0, nu).front();
            const PlaneState state{-120.0, -40.0, 55.0};
            const auto principal_of = [&](double k) {
                return principal(
                    in_space(PlaneState{k * state.x, k * state.y, k * state.xy}, nu * k * (state.x + state.y)));
            };
            const double k = *safety(criterion, strength, principal_of(1.0)).factor;
            const Circle c = circle({k * state.x, k * state.y, k * state.xy});
            double gap = 1e9;
            for (std::size_t i = 1; i < curve.size(); ++i) // the chord's distance from the centre
                for (const double share : {0.0, 0.25, 0.5, 0.75}) {
                    const double x = curve[i - 1].normal + share * (curve[i].normal - curve[i - 1].normal);
                    const double y = curve[i - 1].shear + share * (curve[i].shear - curve[i - 1].shear);
                    gap = std::min(gap, std::hypot(x - c.centre, y) - c.radius);
                }
            CAPTURE(word(criterion));
            CAPTURE(nu);
            CHECK(std::abs(gap) < 0.01 * c.radius);
        }
}

TEST_SUITE_END();
