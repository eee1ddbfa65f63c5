// The funicular over a closing line: parabola and polygon, and the thrust of a three-hinged arch.
#include "femoop/methods/funicular/funicular.h"

#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <vector>

#include "femoop/analysis/linear_static.h"
#include "femoop/io/model_file.h"
#include "tests/frame_maker.h"

using namespace femoop;
using namespace femoop::funicular;

namespace {

constexpr double A = 2.0, B = 13.0, L = B - A; // where the span begins and ends

/// Under forces and a load that grows.
SimpleSpan loaded_span()
{
    return SimpleSpan(A, B, {.forces = {{5.0, 30.0}, {9.0, -7.0}}, .stretches = {{3.0, 8.0, 4.0, 10.0}}});
}

Chain whole_chain(const Model& model)
{
    const Discretisation structure = discretise(model);
    return chain_of(structure, members_across(structure));
}

SimpleSpan span_of(const Model& model, const Chain& chain, CaseId load_case)
{
    return SimpleSpan(chain.left().x(), chain.right().x(), vertical_loads(model, discretise(model), chain, load_case));
}

/// A parabolic arch of `n` members on supports at unequal heights, with a hinge at its middle.
FrameMaker hinged_arch(int n)
{
    FrameMaker made;
    const auto name = [](int i) { return std::string(1, static_cast<char>('A' + i)); };
    for (int i = 0; i <= n; ++i) {
        const double x = L * i / n;
        const bool is_end = i == 0 || i == n;
        made.node(name(i), A + x, 0.3 * x + 4.0 * 2.5 * x * (L - x) / (L * L),
                  is_end ? std::optional(SupportKind::Pin) : std::nullopt);
    }
    for (int i = 0; i < n; ++i) made.member(name(i), name(i + 1));
    made.model.nodes[static_cast<std::size_t>(n / 2)].hinge = true;
    return made;
}

} // namespace

TEST_SUITE("funicular")
{
    TEST_CASE("Under a uniform load it is a parabola of the rise q L^2 / 8 H")
    {
        constexpr double q = 12.0, H = 45.0;
        const Funicular funicular{SimpleSpan(A, B, {.forces = {}, .stretches = {{A, B, q, q}}}), {1.0, 3.2}, H};
        CHECK(funicular.rise() == doctest::Approx(q * L * L / (8.0 * H)));
        CHECK(funicular.span.largest_moment().x == doctest::Approx(0.5 * (A + B)));
        CHECK(funicular.span.left_reaction() == doctest::Approx(0.5 * q * L));
        for (const double x : {2.7, 6.1, 11.9}) {
            CAPTURE(x);
            const double wanted = 1.0 + 2.2 * (x - A) / L + q * (x - A) * (B - x) / (2.0 * H);
            CHECK(funicular.height(x) == doctest::Approx(wanted).epsilon(1e-13));
        }
    }

    TEST_CASE("The moment of the simple span has the loads as its curvature, and is 0 at both ends")
    {
        const SimpleSpan span = loaded_span();
        CHECK(span.left_reaction() + span.right_reaction() == doctest::Approx(30.0 - 7.0 + 7.0 * 5.0));
        CHECK(span.moment(A) == 0.0);
        CHECK(span.moment(B - 1e-9) == doctest::Approx(0.0));
        const double q = 4.0 + 6.0 * (6.5 - 3.0) / 5.0, h = 1e-3;
        CHECK((span.moment(6.5 + h) - 2.0 * span.moment(6.5) + span.moment(6.5 - h)) / (h * h) ==
              doctest::Approx(-q).epsilon(1e-6));
        CHECK(span.moment(2.6) == doctest::Approx(span.left_reaction() * 0.6));
        CHECK(span.moment(11.0) == doctest::Approx(span.right_reaction() * 2.0));
        const double largest = span.largest_moment().value;
        for (int i = 0; i < 200; ++i) CHECK(std::abs(span.moment(A + L * i / 200.0)) <= largest * (1.0 + 1e-12));
    }

    TEST_CASE("Its closing line shifted and tilted, the ordinates stay")
    {
        const Funicular before{loaded_span(), {0.0, 0.0}, 17.0}, after{loaded_span(), {3.7, -1.9}, 17.0};
        for (const double x : {2.3, 5.0, 7.7, 12.1}) {
            CAPTURE(x);
            CHECK(after.height(x) - after.closing(x) == doctest::Approx(before.height(x)).epsilon(1e-13));
            CHECK(after.ordinate(x) * 17.0 == doctest::Approx(loaded_span().moment(x)));
        }
    }

    TEST_CASE("The rays of the force polygon are parallel to the sides of the funicular polygon under point loads")
    {
        for (const double H : {23.0, -23.0}) {
            CAPTURE(H);
            const VerticalLoads loads{.forces = {{4.0, 11.0}, {6.5, 19.0}, {10.0, 5.0}}, .stretches = {}};
            const Funicular funicular{SimpleSpan(A, B, loads), {1.5, -0.8}, H};
            const ForcePolygon polygon = force_polygon(funicular);
            CHECK(polygon.pole.x() == -H);
            CHECK(polygon.levels.back() == doctest::Approx(-35.0));
            CHECK((polygon.pole.y() - polygon.closing_level) / polygon.pole.x() == doctest::Approx(-2.3 / L));
            const std::vector<Eigen::Vector2d> corners = polygon.corners(funicular);
            REQUIRE(corners.size() == 5);
            for (const Eigen::Vector2d& corner : corners) {
                CAPTURE(corner.x());
                CHECK(corner.y() == doctest::Approx(funicular.height(corner.x())).epsilon(1e-13));
            }
        }
    }

    TEST_CASE("The sides of the polygon of resultants touch the curve of a distributed load where it begins and ends")
    {
        const Funicular funicular{loaded_span(), {0.6, 2.0}, 31.0};
        const std::vector<Eigen::Vector2d> corners = force_polygon(funicular).corners(funicular);
        CHECK(corners.back().x() == B);
        CHECK(corners.back().y() == doctest::Approx(2.0));
        CHECK(corners[1].y() > funicular.height(corners[1].x())); // the force is at 5, in the stretch from 3 to 8
    }

    TEST_CASE("The rise gives H, and a rise on the other side a cable that pulls")
    {
        const SimpleSpan span = loaded_span();
        const double H = thrust_of_rise(span, 2.4);
        CHECK(Funicular{span, {}, H}.rise() == doctest::Approx(2.4));
        CHECK(H == doctest::Approx(span.largest_moment().value / 2.4));
        CHECK(thrust_of_rise(span, -2.4) == doctest::Approx(-H));
    }

    TEST_CASE("The H of three points is M0 / f of the one between, and there is none on the closing line")
    {
        const SimpleSpan span = loaded_span();
        const ClosingLine line{1.0, 4.0};
        const Eigen::Vector2d point(7.3, 6.1);
        const auto H = thrust_through(span, line, point);
        REQUIRE(H);
        CHECK(*H == doctest::Approx(span.moment(7.3) / (6.1 - (1.0 + 3.0 * 5.3 / L))));
        CHECK(Funicular{span, line, *H}.height(7.3) == doctest::Approx(6.1));
        CHECK_FALSE(thrust_through(span, line, {7.3, 1.0 + 3.0 * 5.3 / L}));
        CHECK_FALSE(thrust_through(span, line, {B, 6.1}));
    }

    TEST_CASE("Through the hinges H is the thrust of the analysis, and H e the moment along the arch")
    {
        FrameMaker made = hinged_arch(6);
        made.force("C", Dof::uy, -37.0).uniform("DE", -8.0).point("BC", 0.7, -21.0).uniform("AB", -3.0);
        for (const Model& model : {read_model_file("examples/three_hinged_arch.json"), made.model}) {
            const Results results = analyse(model);
            const Chain chain = whole_chain(model);
            REQUIRE(chain.is_three_hinged_arch);
            for (std::size_t i = 0; i < model.n_cases(); ++i) {
                CAPTURE(model.case_name(CaseId(i)));
                const SimpleSpan span = span_of(model, chain, CaseId(i));
                const ClosingLine line{chain.left().y(), chain.right().y()};
                const auto H = thrust_through(span, line, *chain.hinge);
                REQUIRE(H);
                CHECK(*H ==
                      doctest::Approx(results[CaseId(i)].reaction(chain.nodes.front())[index(Dof::ux)]).epsilon(1e-9));
                const Funicular funicular{span, line, *H};
                CHECK(funicular.height(chain.hinge->x()) == doctest::Approx(chain.hinge->y()).epsilon(1e-12));
                for (const Chain::Link& link : chain.links)
                    for (const double share : {0.0, 0.37, 0.81}) {
                        const MemberGeometry geometry = results.geometry(link.member);
                        const double x = geometry.at(share * geometry.length).x();
                        const double M = results[CaseId(i)].curve(link.member).forces(share * geometry.length).Mz;
                        const double e = funicular.height(x) - chain.height(x);
                        CHECK(std::abs(*H * e - M) < 1e-9 * span.largest_moment().value);
                    }
            }
        }
    }
}
