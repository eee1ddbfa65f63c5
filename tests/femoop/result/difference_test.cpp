// Two results held against each other, part by part.
#include <doctest/doctest.h>

#include <cstddef>
#include <string>
#include <variant>

#include "femoop/analysis/linear_static.h"
#include "femoop/io/model_file.h"
#include "femoop/result/difference.h"

using namespace femoop;

namespace {

/// A cantilever AB of length L with a force P at its end.
Model cantilever(const char* L)
{
    const std::string text = std::string(
                                 R"({"cremona": 1, "analysis": "frame2d", "units": {"length": "m", "force": "kN"},
      "materials": [{"id": "m", "E": 2e8}], "sections": [{"id": "s", "A": 0.01, "Iz": 1e-4}],
      "nodes": [{"id": "A", "at": [0, 0], "support": "fixed"}, {"id": "B", "at": [)") +
                             L + R"(, 0]}],
      "members": [{"id": "AB", "nodes": ["A", "B"], "material": "m", "section": "s"}],
      "load_cases": [{"id": "P", "nodes": [{"node": "B", "fy": -7}]}, {"id": "H", "nodes": [{"node": "B", "fx": 5}]}]})";
    return read_model(text);
}

Difference of(const Differences& all, ComparedQuantity quantity, std::variant<Dof, MemberComponent> component)
{
    for (std::size_t i = 0; i < all.size(); ++i)
        if (const Difference one = all[i]; one.quantity == quantity && one.component == component) return one;
    FAIL("not compared");
    return all[0];
}

} // namespace

TEST_SUITE("differences")
{
    TEST_CASE("A cantilever of 4 m instead of 3 m has P (4 - 3) more moment, and the same shear")
    {
        const Model now = cantilever("4"), then = cantilever("3");
        const Results present = analyse(now), former = analyse(then);
        const Differences all({&now, present.at("P")}, {&then, former.at("P")});
        const Difference M = of(all, ComparedQuantity::SectionForce, MemberComponent::Mz);
        CHECK(M.now == doctest::Approx(-28.0));
        CHECK(*M.then == doctest::Approx(-21.0));
        CHECK(*M.change() == doctest::Approx(-7.0));
        CHECK_FALSE(M.is_as_long);
        CHECK(*of(all, ComparedQuantity::SectionForce, MemberComponent::Vy).change() == doctest::Approx(0.0));
        CHECK(*of(all, ComparedQuantity::Reaction, Dof::rz).change() == doctest::Approx(7.0));
    }

    TEST_CASE("A case compared with itself differs nowhere, with another by that one's results")
    {
        const Model model = cantilever("4");
        const Results results = analyse(model);
        const Differences none({&model, results.at("P")}, {&model, results.at("P")});
        CHECK(none.size() == 12); // 3 section forces, 3 reactions, 2 x 3 displacements
        for (std::size_t i = 0; i < none.size(); ++i) {
            CHECK(*none[i].change() == 0.0);
            CHECK(none[i].is_as_long);
        }
        const Differences all({&model, results.at("H")}, {&model, results.at("P")});
        CHECK(*of(all, ComparedQuantity::SectionForce, MemberComponent::N).change() == doctest::Approx(5.0));
        CHECK(of(all, ComparedQuantity::SectionForce, MemberComponent::Mz).now == 0.0);
    }

    TEST_CASE("Section forces are held against each other at one section, where they differ most")
    {
        // P at the tip of 4 m beside a couple of 100 there: M = -P (L - x) and 100, apart by 128 at the clamp
        Model model = cantilever("4");
        model.load_cases[1].nodes[0].components = {{Dof::rz, Quantity(100.0)}};
        const Results results = analyse(model);
        const Differences all({&model, results.at("H")}, {&model, results.at("P")});
        const Difference M = of(all, ComparedQuantity::SectionForce, MemberComponent::Mz);
        CHECK(M.share == 0.0);
        CHECK(M.now == doctest::Approx(100.0));
        CHECK(*M.then == doctest::Approx(-28.0));
        CHECK(*M.change() == doctest::Approx(128.0));
    }

    TEST_CASE("A part that was not there has nothing to be compared with, and another analysis nothing at all")
    {
        const Model then = cantilever("3");
        Model now = cantilever("3");
        now.members[0].id = "beam";
        const Results present = analyse(now), former = analyse(then);
        const Differences all({&now, present.at("P")}, {&then, former.at("P")});
        CHECK_FALSE(of(all, ComparedQuantity::SectionForce, MemberComponent::Mz).change());
        CHECK(of(all, ComparedQuantity::Reaction, Dof::uy).change());
        Model other = then;
        other.analysis = AnalysisKind::Truss2d;
        CHECK(Differences({&now, present.at("P")}, {&other, former.at("P")}).size() == 0);
    }
}
