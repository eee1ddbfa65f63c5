#include <doctest/doctest.h>

#include <Eigen/Dense>

#include "femoop/element/beam.h"

using namespace femoop;

namespace {

constexpr double L = 3.7, EI = 5300.0, GAs = 910.0, q = 6.1, P = 11.0, a = 1.3; // no two equal, none 1

SpanLoading loaded(const std::vector<SpanLoad>& loads, double length = L,
                   double longest = std::numeric_limits<double>::infinity(), double settling = SpanLoading::no_settling)
{
    SpanLoading loading;
    const std::array<SpanLoading::Scaled, 1> terms{{{.loads = loads}}};
    loading.assign(length, terms, longest, settling);
    return loading;
}

SpanLoad uniform(double value) { return {.from = 0.0, .to = L, .start = value, .end = value}; }

SpanLoad point(LocalAxis axis, double at, double value)
{
    return {.kind = SpanLoad::Kind::Point, .axis = axis, .from = at, .to = at, .start = value};
}

} // namespace

TEST_SUITE("beam")
{
    TEST_CASE("A uniform load needs q L / 2 and q L^2 / 12 to hold both ends, sheared or not")
    {
        for (const double flexibility : {0.0, 1.0 / GAs}) {
            CAPTURE(flexibility);
            const Beam beam{.EI = EI, .shear_flexibility = flexibility};
            const Eigen::Vector4d f = beam.fixed_end_forces(loaded({uniform(-q)}), BendingPlane::xy);
            CHECK(f[0] == doctest::Approx(q * L / 2.0));
            CHECK(f[1] == doctest::Approx(q * L * L / 12.0));
            CHECK(f[2] == doctest::Approx(q * L / 2.0));
            CHECK(f[3] == doctest::Approx(-q * L * L / 12.0));
        }
    }

    TEST_CASE("A point load P at a needs the moments P a b^2 / L^2 and P a^2 b / L^2")
    {
        const double b = L - a;
        const Eigen::Vector4d f = Beam{.EI = EI}.fixed_end_forces(loaded({point(LocalAxis::y, a, -P)}),
                                                                  BendingPlane::xy);
        CHECK(f[0] == doctest::Approx(P * b * b * (3.0 * a + b) / (L * L * L)));
        CHECK(f[1] == doctest::Approx(P * a * b * b / (L * L)));
        CHECK(f[2] == doctest::Approx(P * a * a * (a + 3.0 * b) / (L * L * L)));
        CHECK(f[3] == doctest::Approx(-P * a * a * b / (L * L)));
    }

    TEST_CASE("A couple C at a needs the moments C b (2 a - b) / L^2 and C a (2 b - a) / L^2")
    {
        const double C = 4.3;
        const double b = L - a;
        const Eigen::Vector4d f = Beam{.EI = EI}.fixed_end_forces(loaded({point(LocalAxis::rz, a, C)}),
                                                                  BendingPlane::xy);
        CHECK(f[1] == doctest::Approx(C * b * (2.0 * a - b) / (L * L)));
        CHECK(f[3] == doctest::Approx(C * a * (2.0 * b - a) / (L * L)));
        CHECK(f[0] == doctest::Approx(6.0 * C * a * b / (L * L * L)));
    }

    TEST_CASE("A triangular load that grows from nothing to q needs q L^2 / 30 and q L^2 / 20")
    {
        const SpanLoad triangle{.from = 0.0, .to = L, .start = 0.0, .end = -q};
        const Eigen::Vector4d f = Beam{.EI = EI}.fixed_end_forces(loaded({triangle}), BendingPlane::xy);
        CHECK(f[0] == doctest::Approx(3.0 * q * L / 20.0));
        CHECK(f[1] == doctest::Approx(q * L * L / 30.0));
        CHECK(f[2] == doctest::Approx(7.0 * q * L / 20.0));
        CHECK(f[3] == doctest::Approx(-q * L * L / 20.0));
    }

    TEST_CASE("Loads on the ends themselves are held where they act")
    {
        const Eigen::Vector4d f = Beam{.EI = EI}.fixed_end_forces(
            loaded({point(LocalAxis::y, 0.0, -P), point(LocalAxis::rz, L, 5.0)}), BendingPlane::xy);
        CHECK(f[0] == doctest::Approx(P));
        CHECK(f[1] == doctest::Approx(0.0));
        CHECK(f[2] == doctest::Approx(0.0));
        CHECK(f[3] == doctest::Approx(-5.0));
    }

    TEST_CASE("A sheared cantilever sags P L^3 / 3 EI + P L / GAs at its tip")
    {
        const Eigen::Matrix2d K = Beam{.EI = EI, .shear_flexibility = 1.0 / GAs}.stiffness(L).bottomRightCorner<2, 2>();
        const Eigen::Vector2d tip = K.inverse() * Eigen::Vector2d(-P, 0.0);
        CHECK(tip[0] == doctest::Approx(-P * L * L * L / (3.0 * EI) - P * L / GAs));
        CHECK(tip[1] == doctest::Approx(-P * L * L / (2.0 * EI)));
    }

    TEST_CASE("A vanishing foundation leaves the beam's own stiffness")
    {
        for (const double shear : {0.0, 1.0 / GAs}) {
            CAPTURE(shear);
            const Beam beam{.EI = EI, .shear_flexibility = shear, .foundation = 1e-9};
            const Beam bare{.EI = EI, .shear_flexibility = shear};
            const FoundationBeam on(beam, loaded({}, L, beam.longest_piece()), BendingPlane::xy, 0.0);
            CHECK((on.stiffness() - bare.stiffness(L)).norm() < 1e-10 * bare.stiffness(L).norm());
        }
    }

    TEST_CASE("A long beam on a foundation is as stiff at its end as Hetenyi's half-infinite beam")
    {
        // [Hetenyi1946, art. 11]: end force P and moment M0 give v = 2 P b / k, v' = -2 P b^2 / k; M0: 2 M0 b^2 / k ...
        const double k = 730.0;
        const double b = std::pow(k / (4.0 * EI), 0.25);
        const Beam beam{.EI = EI, .foundation = k};
        const double length = 30.0 / b;
        const FoundationBeam on(beam, loaded({}, length, beam.longest_piece()), BendingPlane::xy, 0.0);
        const Eigen::Matrix4d& K = on.stiffness();
        const Eigen::Matrix2d flexibility = K.topLeftCorner<2, 2>().inverse();
        CHECK(flexibility(0, 0) == doctest::Approx(2.0 * b / k).epsilon(1e-10));
        CHECK(flexibility(0, 1) == doctest::Approx(-2.0 * b * b / k).epsilon(1e-10));
        CHECK(flexibility(1, 1) == doctest::Approx(4.0 * b * b * b / k).epsilon(1e-10));
        CHECK(K.bottomLeftCorner<2, 2>().norm() < 1e-9 * K.norm());
        CHECK((K - K.transpose()).norm() < 1e-12 * K.norm());
    }

    TEST_CASE("Cutting a beam on a foundation into more pieces changes nothing")
    {
        const Beam beam{.EI = EI, .shear_flexibility = 1.0 / GAs, .foundation = 4200.0};
        const std::vector<SpanLoad> loads{uniform(-q), point(LocalAxis::y, a, -P), point(LocalAxis::rz, 2.0, 3.0)};
        const double longest = beam.longest_piece();
        const FoundationBeam coarse(beam, loaded(loads, L, longest), BendingPlane::xy, 0.013);
        const FoundationBeam fine(beam, loaded(loads, L, longest / 3.7), BendingPlane::xy, 0.013);
        CHECK((coarse.stiffness() - fine.stiffness()).norm() < 1e-11 * fine.stiffness().norm());
        CHECK((coarse.fixed_end_forces() - fine.fixed_end_forces()).norm() < 1e-11 * fine.fixed_end_forces().norm());
    }

    TEST_CASE("A stiff foundation takes few pieces, and its beam is the one of many pieces")
    {
        const std::vector<SpanLoad> loads{uniform(-q), point(LocalAxis::y, a, -P), point(LocalAxis::rz, 2.0, 3.0)};
        for (const double shear : {0.0, 1e-12 / EI}) {
            const Beam beam{.EI = EI, .shear_flexibility = shear, .foundation = EI * std::pow(500.0 / L, 4.0)};
            const double longest = beam.longest_piece();
            const SpanLoading few = loaded(loads, L, longest, beam.settling()), many = loaded(loads, L, longest);
            CHECK(few.pieces().size() < many.pieces().size());
            const FoundationBeam settled(beam, few, BendingPlane::xy, 0.013),
                chain(beam, many, BendingPlane::xy, 0.013);
            CHECK((settled.stiffness() - chain.stiffness()).norm() < 1e-11 * chain.stiffness().norm());
            CHECK((settled.fixed_end_forces() - chain.fixed_end_forces()).norm() <
                  1e-11 * chain.fixed_end_forces().norm());
        }
        const Beam stiffest{.EI = EI, .foundation = Beam{.EI = EI}.stiffest_foundation(L)};
        CHECK(loaded(loads, L, stiffest.longest_piece(), stiffest.settling()).pieces().size() < 400);
    }

    TEST_CASE("On a foundation a load that comes near an end does what it does at the end")
    {
        for (const double shear : {0.0, 1.0 / GAs}) {
            const Beam beam{.EI = EI, .shear_flexibility = shear, .foundation = 4200.0};
            const auto held_by = [&](double x) {
                const std::vector<SpanLoad> loads{point(LocalAxis::y, x, -P)};
                return FoundationBeam(beam, loaded(loads, L, beam.longest_piece()), BendingPlane::xy, 0.0);
            };
            for (const double near : {1e-4, 1e-6, 1e-8, 1e-10}) {
                const Eigen::Vector4d first = held_by(near * L).fixed_end_forces();
                CHECK((first - Eigen::Vector4d(P, 0.0, 0.0, 0.0)).norm() < 10.0 * near * P * L);
                const Eigen::Vector4d second = held_by(L - near * L).fixed_end_forces();
                CHECK((second - Eigen::Vector4d(0.0, 0.0, P, 0.0)).norm() < 10.0 * near * P * L);
                const Eigen::Vector4d d(0.0, 0.001, 0.0, 0.0);
                const auto states = held_by(near * L).states(d);
                CHECK(states[1].v == doctest::Approx(d[1] * near * L));
            }
        }
    }

    TEST_CASE("A foundation beam under q sinks q / k when its ends go along")
    {
        const double k = 730.0;
        const Beam beam{.EI = EI, .foundation = k};
        const FoundationBeam on(beam, loaded({uniform(-q)}, L, beam.longest_piece()), BendingPlane::xy, 0.0);
        const Eigen::Vector4d d(-q / k, 0.0, -q / k, 0.0);
        const Eigen::Vector4d ends = on.stiffness() * d + on.fixed_end_forces();
        CHECK(ends.norm() < 1e-9 * on.fixed_end_forces().norm());
    }

    TEST_CASE("Statics of a simple span: q L / 2 at both ends, a couple C gives -C / L and C / L")
    {
        const Eigen::Vector2d r = Beam::simple_span_forces(loaded({uniform(-q)}), BendingPlane::xy);
        CHECK(r[0] == doctest::Approx(q * L / 2.0));
        CHECK(r[1] == doctest::Approx(q * L / 2.0));
        const Eigen::Vector2d c = Beam::simple_span_forces(loaded({point(LocalAxis::rz, a, 7.0)}), BendingPlane::xy);
        CHECK(c[0] == doctest::Approx(7.0 / L));
        CHECK(c[1] == doctest::Approx(-7.0 / L));
    }
}
