#include "femoop/result/magnitudes.h"

#include <doctest/doctest.h>

#include <string>

#include "femoop/analysis/linear_static.h"
#include "femoop/io/model_file.h"

using namespace femoop;

TEST_SUITE_BEGIN("result");

namespace {

/// A beam of 6.3 m that is held at both ends, under one load on it.
Model held_beam(const std::string& load)
{
    return read_model(R"({"cremona": 1, "analysis": "frame2d", "units": {"length": "m", "force": "kN"},
      "materials": [{"id": "s", "E": 2.1e8, "alpha": 1.2e-5}],
      "sections": [{"id": "c", "A": 0.0117, "Iz": 2e-4, "h": 0.3}],
      "nodes": [{"id": "A", "at": [0.7, 0.1], "support": "fixed"}, {"id": "B", "at": [7, 0.1], "support": "fixed"}],
      "members": [{"id": "AB", "nodes": ["A", "B"], "material": "s", "section": "c"}],
      "load_cases": [{"id": "T", "members": [{"member": "AB", )" +
                      load + "}]}]}");
}

} // namespace

TEST_CASE("What stands on a support passes no member, and is as large as the reaction")
{
    Model model = held_beam(R"("kind": "point", "at": 0, "fy": -17)");
    const Magnitudes most = analyse(model)[CaseId(0)].magnitudes();
    CHECK(most.force == doctest::Approx(17.0));
    CHECK(most.moment >= most.force * 6.3 * (1.0 - 1e-12)); // by the structure's size
}

TEST_CASE("A held beam that only strains of its own load moves nowhere but for round-off")
{
    for (const std::string load :
         {R"("kind": "temperature", "top": 20, "bottom": 20)", R"("kind": "temperature", "top": 20, "bottom": -7.5)",
          R"("kind": "misfit", "elongation": 0.0031)"}) {
        CAPTURE(load);
        const Results results = analyse(held_beam(load));
        const CaseResult result = results[CaseId(0)];
        const Magnitudes most = result.magnitudes();
        for (const double x : {0.61, 1.91, 3.15, 4.77})
            for (const MemberComponent component : {MemberComponent::u, MemberComponent::v}) {
                CAPTURE(x);
                CHECK(without_rounding(result.curve(MemberId(0)).value(component, x), most.of(component)) == 0.0);
            }
    }
}
