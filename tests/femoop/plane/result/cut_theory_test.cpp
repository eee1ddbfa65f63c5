// The theory of beams beside the stresses on a cut.
#include <doctest/doctest.h>

#include <cmath>

#include "femoop/plane/result/cut_theory.h"
#include "tests/femoop/plane/result/plane_case.h"

using namespace femoop::plane;

TEST_CASE("On a cut through a cantilever the theory gives N/A - M y/I and V Q/(I t) of its rectangle")
{
    const PlaneResults results = analyse(read_plane_model(plane_test::cantilever_text(10, 2)));
    const PlaneCase result = results[femoop::CaseId{}];
    constexpr double x = 6.2, h = 2.0, t = 0.5, P = 3.0 * h * t, I = t * h * h * h / 12.0, A = h * t;
    const Cut cut{{x, -1.4}, {x, 1.3}};
    const CutTheory theory = beam_theory(results, result, cut);
    const CutForces forces = result.forces(cut);
    CHECK(forces.M == doctest::Approx(-P * (10.0 - x)).epsilon(0.01)); // the fibre below is compressed
    CHECK(std::abs(forces.V) == doctest::Approx(P).epsilon(0.01));
    const double M = forces.M, V = forces.V;
    CHECK(theory.centroid == doctest::Approx(1.4));
    for (const auto& [s, sigma, tau] : theory.stations) {
        const double y = s - 1.4;
        CAPTURE(y);
        CHECK(sigma == doctest::Approx(forces.N / A - M * y / I).epsilon(1e-9));
        CHECK(tau == doctest::Approx(-V * 1.5 / A * (1.0 - 4.0 * y * y / (h * h))).epsilon(1e-9));
    }
}

TEST_CASE("Far from both ends of a slender cantilever its elements and the theory agree on sigma")
{
    const PlaneResults results = analyse(read_plane_model(plane_test::cantilever_text(20, 4)));
    const PlaneCase result = results[femoop::CaseId{}];
    const Cut cut{{5.2, -1.0}, {5.2, 1.0}};
    const CutTheory theory = beam_theory(results, result, cut, 3);
    const std::vector<CutStation> stations = result.stations(cut);
    REQUIRE(stations.size() == theory.stations.size());
    for (std::size_t i = 0; i < stations.size(); ++i)
        CHECK(stations[i].sx == doctest::Approx(theory.stations[i].sigma).epsilon(0.01));
}

TEST_CASE("A tie of two strips shares its pull by their stiffnesses")
{
    const PlaneResults results = analyse(read_plane_model(R"({"cremona": 1, "analysis": "plane_stress",
      "units": {"length": "m", "force": "kN"},
      "materials": [{"id": "soft", "E": 2000, "nu": 0}, {"id": "stiff", "E": 6000, "nu": 0}],
      "regions": [{"id": "a", "material": "soft", "thickness": 0.7}, {"id": "b", "material": "stiff", "thickness": 0.7}],
      "points": [{"id": "1", "at": [0, 0], "support": "pin"}, {"id": "2", "at": [3, 0]}, {"id": "3", "at": [0, 1]},
                 {"id": "4", "at": [3, 1]}, {"id": "5", "at": [0, 2]}, {"id": "6", "at": [3, 2]}],
      "elements": [{"id": "1", "kind": "Q4", "points": ["1", "2", "4", "3"], "region": "a"},
                   {"id": "2", "kind": "Q4", "points": ["3", "4", "6", "5"], "region": "b"}],
      "curves": [{"id": "left", "kind": "edges", "points": ["5", "3", "1"], "support": {"fixed": ["ux"]}},
                 {"id": "right", "kind": "edges", "points": ["2", "4", "6"], "tie": ["ux"]}],
      "load_cases": [{"id": "P", "points": [{"point": "4", "fx": 14}]}]})"));
    const CutTheory theory = beam_theory(results, results[femoop::CaseId{}], {{1.3, 0.0}, {1.3, 2.0}});
    CHECK(theory.centroid == doctest::Approx((2.0 * 0.5 + 6.0 * 1.5) / 8.0));
    // stretched evenly, 14 / (0.7 (2000 + 6000)), whatever bends it: the elements' own moment is that of an even strain
    CHECK(theory.stations.front().sigma == doctest::Approx(2000.0 * 14.0 / (0.7 * 8000.0)));
    CHECK(theory.stations.back().sigma == doctest::Approx(6000.0 * 14.0 / (0.7 * 8000.0)));
}
