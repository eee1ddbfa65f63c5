// What each support does to the body as a whole.
#include <doctest/doctest.h>

#include <cmath>

#include "femoop/plane/result/support_resultants.h"
#include "tests/femoop/plane/plane_text.h"
#include "tests/femoop/plane/result/plane_case.h"

using namespace femoop::plane;

TEST_CASE("The wall of a cantilever carries P upwards, and P L about its middle")
{
    constexpr double P = 3.0 * 2.0 * 0.5, L = 10.0; // kN, m: plane_test::cantilever_text
    const PlaneResults results = analyse(read_plane_model(plane_test::cantilever_text(7, 2)));
    const auto all = support_resultants(results[femoop::CaseId{}]);
    REQUIRE(all.size() == 1);
    CHECK(all[0].curve.has_value());
    CHECK(all[0].at.x() == doctest::Approx(0.0));
    CHECK(all[0].at.y() == doctest::Approx(0.0));
    CHECK(all[0].force.x() == doctest::Approx(0.0).scale(P));
    CHECK(all[0].force.y() == doctest::Approx(P));
    CHECK(all[0].moment == doctest::Approx(P * L));
}

TEST_CASE("A node of two supports counts with one of them, so that all resultants sum to the reactions")
{
    PlaneModel model = read_plane_model(plane_test::cantilever_text(7, 2));
    PlaneSupport pin;
    pin.kind = PlaneSupportKind::Pin;
    model.points[0].support = pin; // the lower end of the wall
    const PlaneResults results = analyse(model);
    const PlaneCase result = results[femoop::CaseId{}];
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    for (const SupportResultant& one : support_resultants(result)) sum += one.force;
    CHECK(sum.x() == doctest::Approx(result.equilibrium().sum_reactions[0]).scale(1.0));
    CHECK(sum.y() == doctest::Approx(result.equilibrium().sum_reactions[1]));
}

TEST_CASE("A roller at the end of a held side takes nothing of what the side holds: a pull has no moment there")
{
    PlaneModel model = read_plane_model(
        PlaneText{.curves = R"([{"id": "left", "kind": "edges", "points": ["D", "A"], "support": "symmetry"},
                      {"id": "right", "kind": "edges", "points": ["C", "F"]}])",
                  .load_case = R"(, "curves": [{"curve": "right", "kind": "traction", "qx": 13}])"}
            .text());
    PlaneSupport roller;
    roller.kind = PlaneSupportKind::Roller;
    model.points[0].support = roller;
    const PlaneResults results = analyse(model);
    const auto all = support_resultants(results[femoop::CaseId{}]);
    REQUIRE(all.size() == 2);
    CHECK(all[0].point.has_value());
    CHECK(all[0].force.norm() < 1e-9);
    CHECK(all[1].force.x() == doctest::Approx(-13.0 * 2.0 * 0.4)); // of PlaneText
    CHECK(std::abs(all[1].moment) < 1e-9);
}
