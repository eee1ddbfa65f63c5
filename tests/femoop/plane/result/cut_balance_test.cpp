// What acts on a cut by the equilibrium of what lies on either side of it.
#include <doctest/doctest.h>

#include <string>

#include "femoop/plane/result/cut_balance.h"
#include "tests/femoop/plane/result/plane_case.h"

using namespace femoop::plane;

namespace {

constexpr double cantilever = 10.0, P = 3.0 * 2.0 * 0.5; // m, kN: plane_test::cantilever_text

} // namespace

TEST_CASE("On every cut through a cantilever equilibrium gives V = P and M = -P (L - x), by either side")
{
    const PlaneResults results = analyse(read_plane_model(plane_test::cantilever_text(7, 2)));
    for (const double x : {2.3, 5.1, 7.7}) {
        CAPTURE(x);
        const Cut cut{{x, -1.4}, {x, 1.3}};
        const auto balance = cut_balance(results, results[femoop::CaseId{}], cut);
        REQUIRE(balance);
        for (const CutForces& by : {balance->by_first, balance->by_second}) {
            CHECK(by.N == doctest::Approx(0.0).scale(P).epsilon(1e-9));
            CHECK(by.V == doctest::Approx(P).epsilon(1e-9));
            CHECK(by.M == doctest::Approx(-P * (cantilever - x)).epsilon(1e-9));
        }
        CHECK_FALSE(cut_warning(results, results[femoop::CaseId{}], cut));
    }
}

TEST_CASE("A cut the other way round carries the same N and M, and V with the other sign of its axis")
{
    const PlaneResults results = analyse(read_plane_model(plane_test::cantilever_text(7, 2)));
    const auto balance = cut_balance(results, results[femoop::CaseId{}], {{4.4, 1.3}, {4.4, -1.4}});
    REQUIRE(balance);
    CHECK(balance->mean().V == doctest::Approx(P).epsilon(1e-9));
    CHECK(balance->mean().M == doctest::Approx(P * (cantilever - 4.4)).epsilon(1e-9));
}

TEST_CASE("A cut that ends in the material parts no body, and nothing is said of its equilibrium")
{
    const PlaneResults results = analyse(read_plane_model(plane_test::cantilever_text(7, 2)));
    CHECK_FALSE(cut_balance(results, results[femoop::CaseId{}], {{5.1, -1.4}, {5.1, 0.3}}));
    CHECK_FALSE(cut_balance(results, results[femoop::CaseId{}], {{5.1, 3.0}, {5.1, 4.0}}));
}

TEST_CASE("Elements that lock miss the shear on a cut, and what equilibrium gives is told beside them")
{
    // linear quadrilaterals of Q8's mesh: the middle nodes are left out
    PlaneModel model = read_plane_model(plane_test::cantilever_text(7, 1));
    for (PlaneElement& element : model.elements) {
        element.kind = femoop::ShapeKind::Q4;
        element.points.resize(4);
    }
    const PlaneResults results = analyse(model);
    for (const Cut& cut : {Cut{{3.9, -1.4}, {3.9, 1.3}}, Cut{{3.9, -1.02}, {3.9, 1.01}}}) { // ends near the body too
        const auto warning = cut_warning(results, results[femoop::CaseId{}], cut);
        REQUIRE(warning);
        CHECK(warning->balanced.V == doctest::Approx(P).epsilon(1e-9));
        CHECK(warning->missed > 0.02);
        CHECK(warning->digits <= 1);
    }
}

TEST_CASE("What is applied to the elements that a cut crosses may be on either side, so that nothing is told of it")
{
    PlaneModel model = read_plane_model(plane_test::cantilever_text(7, 2));
    BodyForce weight;
    weight.by = Field{femoop::Quantity(-4.0)};
    model.load_cases[0].regions.push_back({.regions = {RegionId(0)}, .load = weight});
    const PlaneResults results = analyse(model);
    for (const double x : {0.6, 5.1, 9.5}) {
        CAPTURE(x);
        const Cut cut{{x, -1.4}, {x, 1.3}};
        const auto balance = cut_balance(results, results[femoop::CaseId{}], cut);
        REQUIRE(balance);
        CHECK_FALSE(balance->is_exact(cut));
        CHECK_FALSE(cut_warning(results, results[femoop::CaseId{}], cut));
    }
}

TEST_CASE("A part that nothing strains has no forces on a cut, whatever rounding leaves")
{
    std::string text = plane_test::cantilever_text(7, 2);
    const std::string at_end = R"("curves": [{"curve": "right", "kind": "traction", "qy": -3}])";
    text.replace(text.find(at_end), at_end.size(), R"("points": [{"point": "n6_4", "fx": 1, "fy": -3}])");
    const PlaneResults results = analyse(read_plane_model(text));
    const Cut before{{2.0, -1.4}, {2.0, 1.3}}, beyond{{7.7, -1.4}, {7.7, 1.3}};
    CHECK(cut_balance(results, results[femoop::CaseId{}], before)->mean().V == doctest::Approx(3.0).epsilon(1e-9));
    CHECK_FALSE(cut_warning(results, results[femoop::CaseId{}], beyond));
}
