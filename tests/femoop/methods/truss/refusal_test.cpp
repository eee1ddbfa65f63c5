#include <doctest/doctest.h>

#include "femoop/analysis/linear_static.h"
#include "femoop/methods/truss/reciprocal.h"
#include "femoop/methods/truss/section_method.h"
#include "femoop/typical/typical.h"
#include "tests/femoop/methods/truss/random_truss.h"

using namespace femoop;
using namespace femoop::truss;

namespace {

TrussMaker square()
{
    TrussMaker made;
    made.node("A", {0, 0}, Pin).node("B", {4, 0}, Roller).node("C", {4, 3}).node("D", {0, 3});
    made.bars({"AB", "BC", "CD", "DA"});
    return made;
}

RefusalKind kind_of(const std::optional<Refusal>& refusal)
{
    REQUIRE(refusal.has_value());
    return refusal->kind;
}

} // namespace

TEST_CASE("A frame is no truss")
{
    Model model = square().bars({"AC"}).load("C", {1, 2}).model;
    model.analysis = AnalysisKind::Frame2d;
    model.sections[0].Iz = 1e-4;
    CHECK(kind_of(why_no_truss(model, analyse(model))) == RefusalKind::NotPlaneTruss);
}

TEST_CASE("Two diagonals are one too many, and the degree is told")
{
    const Model model = square().bars({"AC", "BD"}).load("C", {1, 2}).model;
    const auto refusal = why_no_truss(model, analyse(model));
    CHECK(kind_of(refusal) == RefusalKind::Indeterminate);
    CHECK(refusal->degree == 1);
}

TEST_CASE("A truss without a load case has no forces to find")
{
    Model model = square().bars({"AC"}).model;
    model.load_cases.clear();
    CHECK(kind_of(why_no_truss(model, analyse(model))) == RefusalKind::NoCase);
}

TEST_CASE("An unloaded truss has no diagram")
{
    CHECK(kind_of(why_no_reciprocal(truss_in(square().bars({"AC"}).model))) == RefusalKind::NoForce);
}

TEST_CASE("Bars that cross without a joint have no diagram: both are named, and the place")
{
    // Determinate with both diagonals, as the side BC is left out.
    TrussMaker made;
    made.node("A", {0, 0}, Pin).node("B", {4, 0}, Roller).node("C", {4, 3}).node("D", {0, 3});
    made.bars({"AB", "CD", "DA", "AC", "BD"}).load("C", {1, -2});
    const auto refusal = why_no_reciprocal(truss_in(made.model));
    CHECK(kind_of(refusal) == RefusalKind::BarsCross);
    CHECK(refusal->bars == std::vector{MemberId(3), MemberId(4)});
    CHECK((*refusal->at - Eigen::Vector2d(2.0, 1.5)).norm() < 1e-12);
}

TEST_CASE("A bar that runs over a joint without being joined there has no diagram")
{
    TrussMaker made;
    made.node("A", {0, 0}, Pin).node("B", {6, 0}, Roller).node("C", {3, 4}).node("M", {2, 0});
    made.bars({"AB", "BC", "CA", "AM", "MC"}).load("C", {1, -2}).load("M", {0, -3});
    const auto refusal = why_no_reciprocal(truss_in(made.model));
    CHECK(kind_of(refusal) == RefusalKind::BarPassesJoint);
    CHECK(refusal->joints == std::vector{NodeId(3)});
}

TEST_CASE("Two trusses that no bar joins have no common diagram")
{
    TrussMaker made = square().bars({"AC"}).load("C", {1, -2});
    made.node("P", {8, 0}, Pin).node("Q", {11, 0}, Roller).node("R", {9, 2}).bars({"PQ", "QR", "RP"});
    const auto refusal = why_no_reciprocal(truss_in(made.model));
    CHECK(kind_of(refusal) == RefusalKind::FallsApart);
    CHECK(refusal->joints.size() == 3);
}

TEST_CASE("A load within the outline has no place among the spaces, and its joint is named")
{
    TrussMaker made;
    made.node("A", {0, 0}, Pin).node("B", {6, 0}, Roller).node("C", {3, 5}).node("M", {3, 2});
    made.bars({"AB", "BC", "CA", "AM", "BM"}).load("M", {0, -3}).load("C", {1, 0});
    const auto refusal = why_no_reciprocal(truss_in(made.model));
    CHECK(kind_of(refusal) == RefusalKind::ForceInside);
    CHECK(refusal->joints == std::vector{NodeId(3)});
}

TEST_CASE("A cut has to go through: too few bars, not all the way, a bar at one side, all through one joint")
{
    const Model model = square().bars({"AC"}).load("C", {1, 2}).model;
    const Truss truss = truss_in(model);
    const auto bar = [&](const std::string& id) { return *model.find_member(id); };
    CHECK(kind_of(why_no_cut(truss, {bar("A-B")})) == RefusalKind::CutTooSmall);
    CHECK(kind_of(why_no_cut(truss, {bar("A-B"), bar("A-C")})) == RefusalKind::CutNotThrough);
    CHECK(kind_of(why_no_cut(truss, {bar("C-D"), bar("D-A"), bar("A-C")})) == RefusalKind::CutAtOneSide);
    CHECK(kind_of(why_no_cut(truss, {bar("A-B"), bar("A-C"), bar("D-A")})) == RefusalKind::CutConcurrent);
}

TEST_CASE("A joint of two bars cut free gives both, as a joint does")
{
    const Model model = square().bars({"AC"}).load("C", {1, 2}).model;
    const Truss truss = truss_in(model);
    const std::vector bars{*model.find_member("A-B"), *model.find_member("B-C")};
    REQUIRE(!why_no_cut(truss, bars));
    for (const CutEquation& equation : ritter_cut(truss, bars).equations)
        CHECK(equation.force == doctest::Approx(truss[equation.bar].force));
}
