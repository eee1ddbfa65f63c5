// What moment distribution cannot do is refused by name, before anything is distributed.
#include <doctest/doctest.h>

#include <string>

#include "femoop/methods/cross/problem.h"
#include "femoop/model/fault/fault.h"
#include "femoop/model/fault/fault_kind.h"
#include "tests/femoop/methods/cross/frames.h"

using namespace femoop;
using namespace femoop::cross;

namespace {

Model refused_spans()
{
    FrameMaker made;
    made.node("A", 0, 0, fixed).node("B", 4, 0, roller).node("C", 9, 0, fixed).member("A", "B").member("B", "C");
    made.uniform("AB", -12);
    return made.model;
}

/// The only fault that the method finds in a case of a model.
Fault found_in(const Model& model, CaseId load_case = CaseId(0))
{
    try {
        problem_of(model, load_case);
    } catch (const ModelError& error) {
        REQUIRE(error.faults().size() == 1);
        return error.faults().front();
    }
    FAIL("nothing was found");
    return {};
}

FaultKind refusal_of(const Model& model) { return found_in(model).kind; }

/// Two spans between fixed ends, with a cause of their own in every case.
Model held_spans()
{
    Model model = refused_spans();
    model.materials[0].alpha = 1.2e-5;
    model.sections[0].h = 0.3;
    model.add(LoadCase{.id = "warm", .members = {{.member = MemberId(1), .load = TemperatureLoad{20.0, 20.0}}}});
    model.add(LoadCase{.id = "bent", .members = {{.member = MemberId(1), .load = TemperatureLoad{-20.0, 20.0}}}});
    model.add(LoadCase{.id = "drawn apart",
                       .settlements = {{.node = NodeId(2), .components = {{.dof = Dof::ux, .value = 0.01}}}}});
    model.combinations.push_back({.id = "both", .terms = {{CaseId(0), 1.4}, {CaseId(1), 0.6}}});
    return model;
}

} // namespace

TEST_CASE("Moment distribution refuses other structures than plane frames")
{
    FrameMaker made;
    made.model.analysis = AnalysisKind::Truss2d;
    made.node("A", 0, 0, pin).node("B", 4, 0, roller).node("C", 2, 3);
    made.member("A", "B").member("B", "C").member("C", "A");
    CHECK(refusal_of(made.model) == FaultKind::CrossNeedsPlaneFrame);
}

TEST_CASE("Moment distribution refuses members that have no stiffness factor")
{
    Model rigid = refused_spans(), skew = refused_spans(), sprung = refused_spans();
    rigid.members[1].rigid = true;
    skew.members[1].start.offset = {0.0, 0.3};
    sprung.members[1].end.springs.push_back({.dof = Dof::ux, .stiffness = 500.0});
    CHECK(refusal_of(rigid) == FaultKind::CrossRigidMember);
    CHECK(refusal_of(skew) == FaultKind::CrossSkewOffset);
    CHECK(refusal_of(sprung) == FaultKind::CrossAxialSpring);
}

TEST_CASE("Moment distribution refuses models without a load case and models beyond its size")
{
    Model idle = refused_spans();
    idle.load_cases.clear();
    CHECK(refusal_of(idle) == FaultKind::CrossWithoutCase);
    FrameMaker made;
    for (std::size_t i = 0; i <= most_nodes; ++i)
        made.node("n" + std::to_string(i), 3.0 * static_cast<double>(i), 0, i == 0 ? fixed : roller);
    for (std::size_t i = 0; i < most_nodes; ++i) made.member("n" + std::to_string(i), "n" + std::to_string(i + 1));
    CHECK(refusal_of(made.model) == FaultKind::CrossTooLarge);
}

TEST_CASE("A temperature that lengthens a member between held ends is refused with the member and the case")
{
    const Model model = held_spans();
    const Fault warm = found_in(model, CaseId(1)), both = found_in(model, CaseId(4));
    CHECK(warm == Fault{FaultKind::CrossHeldElongation, {"BC", "warm"}});
    CHECK(both == Fault{FaultKind::CrossHeldElongation, {"BC", "both"}});
    CHECK_NOTHROW(problem_of(model, CaseId(0)));
    CHECK_NOTHROW(problem_of(model, CaseId(2))); // it bends alone
}

TEST_CASE("A settlement along axially rigid members is refused with them and the case")
{
    CHECK(found_in(held_spans(), CaseId(3)) ==
          Fault{FaultKind::CrossHeldSettlement, {listed({"AB", "BC"}), "drawn apart"}});
}

TEST_CASE("A temperature goes through where an end may slide")
{
    Model model = held_spans();
    model.load_cases.erase(model.load_cases.begin() + 3); // what draws apart needs the fixed end
    model.combinations.clear();
    model.nodes[2].support = Support{.kind = SupportKind::Roller};
    CHECK_NOTHROW(problem_of(model, CaseId(1)));
}
