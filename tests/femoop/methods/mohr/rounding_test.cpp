// Zeros are 0 by the magnitude of what they come from; nothing is 0 because it is small.
#include <doctest/doctest.h>

#include <array>
#include <cmath>

#include "femoop/methods/mohr/criterion.h"
#include "femoop/methods/mohr/hooke.h"
#include "femoop/methods/mohr/rosette.h"
#include "femoop/methods/mohr/rounding.h"
#include "femoop/methods/mohr/space_construction.h"
#include "femoop/methods/mohr/space_state.h"
#include "tests/femoop/methods/mohr/degree.h"

using namespace femoop::mohr;
using doctest::Approx;

TEST_SUITE_BEGIN("femoop mohr");

namespace {

/// Units in which the same state is told, from strains of stars to those of atoms.
constexpr std::array scales{1e-90, 1e-26, 1e-20, 1e-9, 1.0, 1e12, 1e80};

} // namespace

TEST_CASE("Terms that cancel but for their rounding are 0 and a small number by itself is not")
{
    CHECK(sum_of({0.1, 0.2, -0.3}) == 0.0);
    CHECK(sum_of({1e-300}) == 1e-300);
    CHECK(sum_of({1.0, 1e-12, -1.0}) != 0.0);
    CHECK(without_rounding(1e-20, 1e-20) == 1e-20);
}

TEST_CASE("In a principal direction there is no shear, in that of largest shear the normals are the centre")
{
    for (const double k : scales)
        for (const PlaneState& s :
             {PlaneState{50.0 * k, -10.0 * k, 40.0 * k}, PlaneState{0.3 * k, 0.7 * k, -0.1 * k},
              PlaneState{-13.0 * k, 13.0 * k, 7.0 * k}, PlaneState{29.0 * k, 11.0 * k, 0.013 * k}}) {
            CAPTURE(s.x);
            CHECK(rotated(s, *principal(s).angle).xy == 0.0);
            const PlaneState sheared = rotated(s, *largest_shear_angle(s));
            if (circle(s).centre == 0.0) CHECK(sheared.x == 0.0);
            CHECK(sheared.x == Approx(circle(s).centre));
        }
}

TEST_CASE("Turned by whole degrees pure shear has no normal component where its planes are principal for the other")
{
    for (const double k : scales) {
        CHECK(rotated({0.0, 0.0, 35.0 * k}, 90.0 * degree).x == 0.0);
        CHECK(rotated({35.0 * k, -35.0 * k, 0.0}, 45.0 * degree).x == 0.0);
        CHECK(rotated({35.0 * k, -35.0 * k, 0.0}, -135.0 * degree).y == 0.0);
        CHECK(rotated({35.0 * k, 0.0, 0.0}, 180.0 * degree) == PlaneState{35.0 * k, 0.0, 0.0});
    }
}

TEST_CASE("One principal value alone leaves 0 for the other, in the plane and in space")
{
    for (const double k : scales)
        for (const double angle : {17.0, 30.0, 71.3}) {
            const double c = std::cos(angle * degree), s = std::sin(angle * degree);
            const PlaneState state{83.0 * k * c * c, 83.0 * k * s * s, 83.0 * k * s * c};
            CHECK(principal(state).second == 0.0);
            const SpacePrincipal p = principal(in_space(state, 0.0));
            CHECK(p.values[1] == 0.0);
            CHECK(p.values[2] == 0.0);
            CHECK(p.values[0] == principal(state).first);
        }
}

TEST_CASE("A small component beside a large one is a principal value, not a rounding")
{
    const PlaneState state{1.0, 1e-20, 0.0};
    CHECK(principal(state).second == 1e-20);
    CHECK(rotated(state, 0.0).y == 1e-20);
    CHECK(rotated(state, 90.0 * degree).x == 1e-20);
    CHECK(principal(in_space(state, 0.0)).values[1] == 1e-20);
}

TEST_CASE("A state of 1e-20 alone keeps every result that a state of 1 has, in its unit")
{
    const SpaceState one{-19.0, 4.6, -8.3, -4.7, 11.8, 6.45};
    for (const double k : {1e-26, 1e-20, 1e20}) {
        const SpaceState small{k * one.x, k * one.y, k * one.z, k * one.xy, k * one.yz, k * one.zx};
        const Deviator a = deviator(principal(one)), b = deviator(principal(small));
        CHECK(b.J3 == Approx(k * k * k * a.J3).epsilon(1e-12));
        CHECK(b.mean == Approx(k * a.mean).epsilon(1e-12));
        CHECK(invariants(small).I3 == Approx(k * k * k * invariants(one).I3).epsilon(1e-12));
        CHECK(on_plane(small, {1, 2, 3}).shear == Approx(k * on_plane(one, {1, 2, 3}).shear).epsilon(1e-12));
        CHECK(deviator(principal(small)).equivalent != 0.0);
    }
}

TEST_CASE("Pure shear in space has no mean, no third invariant and Lode's angle of 30 degrees")
{
    for (const double k : scales) {
        const SpacePrincipal p = principal(SpaceState{.xy = 0.3 * k, .yz = 0.0, .zx = 0.4 * k});
        CHECK(p.values[1] == 0.0);
        CHECK(deviator(p).mean == 0.0);
        CHECK(deviator(p).values[1] == 0.0);
        CHECK(deviator(p).J3 == 0.0);
        CHECK(circles(p)[0].centre == 0.0);
        CHECK(*deviator(p).lode == Approx(30.0 * degree));
    }
}

TEST_CASE("The same pressure from all sides, in axes turned anyhow, never fails by Tresca or von Mises")
{
    SpacePrincipal p{.values = {0.7, 0.7, 0.7}};
    p = with_direction(p, 0, {0.3, 0.5, -0.8});
    const SpacePrincipal again = principal(from_principal(p));
    CHECK(absolute_largest_shear(again) == 0.0);
    CHECK_FALSE(safety(Criterion::Tresca, {.fy = 250.0}, again).factor);
    CHECK_FALSE(safety(Criterion::VonMises, {.fy = 250.0}, again).factor);
    CHECK_FALSE(deviator(again).lode);
}

TEST_CASE("On the plane of a principal direction there is no shear in any axes")
{
    const SpaceState s{-19.0, 4.6, -8.3, -4.7, 11.8, 6.45};
    const SpacePrincipal p = principal(s);
    for (int i = 0; i < 3; ++i) {
        CHECK(on_plane(s, p.directions.col(i)).shear == 0.0);
        CHECK(construction(p, p.directions.col(i)).back().points.front().at.shear == 0.0);
    }
}

TEST_CASE("Strains that cancel across leave no stress: ex = -nu ey gives sx = 0")
{
    CHECK(plane_stress({.x = -0.3 * 700.0, .y = 700.0, .xy = 0.0}, {.E = 200.0, .nu = 0.3}).x == 0.0);
    CHECK(free_surface_third({.x = 0.1 + 0.2, .y = -0.3, .xy = 0.0}, 0.3) == 0.0);
    CHECK(plane_strain_third({.x = 0.1 + 0.2, .y = -0.3, .xy = 0.0}, 0.3) == 0.0);
}

TEST_CASE(
    "A rosette of a uniaxial strain or of pure shear has the zeros of that strain in all directions of its gauges")
{
    for (const double begin : {0.0, 20.0, -35.0})
        for (const double step : {45.0, 60.0}) {
            CAPTURE(begin);
            const PlaneState sheared{0.0, 0.0, 350.0}, pulled{700.0, 0.0, 0.0};
            for (const PlaneState& real : {sheared, pulled}) {
                Rosette rosette;
                for (std::size_t i = 0; i < 3; ++i) {
                    rosette.angles[i] = (begin + step * static_cast<double>(i)) * degree;
                    const double c = std::cos(2.0 * rosette.angles[i]), s = std::sin(2.0 * rosette.angles[i]);
                    rosette.readings[i] = 0.5 * real.x * (1.0 + c) + real.xy * s;
                }
                const PlaneState found = strain(rosette);
                CHECK(found.y == 0.0);
                if (real.x == 0.0) CHECK(found.x == 0.0);
                else CHECK(found.xy == 0.0);
            }
        }
}

TEST_SUITE_END();
