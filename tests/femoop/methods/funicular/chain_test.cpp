// Which members are a chain from left to right, and which loads a funicular carries.
#include "femoop/methods/funicular/chain.h"

#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "femoop/methods/funicular/vertical_loads.h"
#include "tests/frame_maker.h"

using namespace femoop;
using namespace femoop::funicular;

namespace {

constexpr auto Pin = SupportKind::Pin;

std::vector<MemberId> members_of(const Model& model, const std::vector<std::string>& names)
{
    std::vector<MemberId> found;
    for (const std::string& name : names) found.push_back(*model.find_member(name));
    return found;
}

std::optional<RefusalKind> why_none(const Model& model, const std::vector<std::string>& names)
{
    const auto refusal = why_no_chain(discretise(model), members_of(model, names));
    return refusal ? std::optional(refusal->kind) : std::nullopt;
}

/// Of a case's loads on the chain of all members.
std::optional<Refusal> why_not_carried(const Model& model)
{
    const Discretisation structure = discretise(model);
    const Chain chain = chain_of(structure, members_across(structure));
    return why_no_vertical_loads(model, structure, chain, CaseId(0));
}

/// A portal: columns at x = 0 and 7, a girder of two members.
FrameMaker portal()
{
    FrameMaker made;
    made.node("A", 0, 0, Pin).node("B", 0, 4).node("C", 3, 5).node("D", 7, 4).node("E", 7, 0, Pin);
    made.member("A", "B").member("C", "B").member("C", "D").member("D", "E");
    return made;
}

} // namespace

TEST_SUITE("funicular")
{
    TEST_CASE("Members become a chain from left to right in whatever order and sense they are named")
    {
        const FrameMaker made = portal();
        const Chain chain = chain_of(discretise(made.model), members_of(made.model, {"CD", "CB"}));
        REQUIRE(chain.links.size() == 2);
        CHECK(made.model[chain.links[0].member].id == "CB");
        CHECK(chain.links[0].is_reversed);
        CHECK_FALSE(chain.links[1].is_reversed);
        CHECK(made.model[chain.nodes.back()].id == "D");
        CHECK(chain.span() == 7.0);
        CHECK(chain.height(1.5) == doctest::Approx(4.5));
        CHECK(chain.height(5.0) == doctest::Approx(4.5));
        CHECK(chain.crown()->x() == 3.0);
        CHECK_FALSE(chain.is_three_hinged_arch);
    }

    TEST_CASE("Of a portal the members that do not stand upright are its one chain")
    {
        const FrameMaker made = portal();
        const Discretisation structure = discretise(made.model);
        const std::vector<MemberId> across = members_across(structure);
        CHECK(across == members_of(made.model, {"CB", "CD"}));
        CHECK_FALSE(why_no_chain(structure, across));
    }

    TEST_CASE("Nodes between the ends that a support or another member holds are told")
    {
        FrameMaker made;
        made.node("A", 0, 0, Pin).node("B", 3, 0).node("C", 5, 0, Pin).node("D", 9, 0, Pin).node("E", 3, -2, Pin);
        made.member("A", "B").member("B", "C").member("C", "D").member("E", "B");
        const Discretisation structure = discretise(made.model);
        CHECK(chain_of(structure, members_of(made.model, {"AB", "BC", "CD"})).held ==
              std::vector{*made.model.find_node("B"), *made.model.find_node("C")});
        CHECK(chain_of(structure, members_of(made.model, {"AB"})).held.empty());
    }

    TEST_CASE("Upright members, forks and parts that hang not together are no chain")
    {
        FrameMaker made = portal();
        made.node("F", 7, 6).node("G", 9, 4).node("H", 12, 5).member("C", "F").member("G", "H");
        CHECK(why_none(made.model, {}) == RefusalKind::NoMember);
        CHECK(why_none(made.model, {"AB", "CB"}) == RefusalKind::Upright);
        CHECK(why_none(made.model, {"CB", "CD", "CF"}) == RefusalKind::Fork);
        CHECK(why_none(made.model, {"CD", "GH"}) == RefusalKind::Apart);
        made.model.analysis = AnalysisKind::Grillage;
        CHECK(why_none(made.model, {"CD"}) == RefusalKind::NotPlaneFrame);
    }

    TEST_CASE("An arch with a hinge between two pins is three-hinged, and no more when a support turns no longer")
    {
        FrameMaker made;
        made.node("A", 0, 1, Pin).node("B", 4, 5).node("C", 11, 0, Pin).member("A", "B").member("B", "C");
        const auto is_three_hinged = [&] {
            const Discretisation structure = discretise(made.model);
            return chain_of(structure, members_across(structure)).is_three_hinged_arch;
        };
        CHECK_FALSE(is_three_hinged());
        made.model.members[1].start.release = {Dof::rz};
        CHECK(is_three_hinged());
        made.model.nodes[2].support->kind = SupportKind::Fixed;
        CHECK_FALSE(is_three_hinged());
        made.model.members[1].end.release = {Dof::rz};
        CHECK(is_three_hinged());
    }

    TEST_CASE("Loads that are not vertical are refused with where they act and how large they are")
    {
        FrameMaker made;
        made.node("A", 0, 0, Pin).node("B", 3, 4).node("C", 8, 2, Pin).member("A", "B").member("B", "C");
        CHECK(why_not_carried(made.model)->kind == RefusalKind::NoLoad);
        made.force("C", Dof::ux, 17.0).point("AB", 0.0, -23.0); // straight into the supports
        CHECK(why_not_carried(made.model)->kind == RefusalKind::NoLoad);

        FrameMaker pushed = made;
        pushed.uniform("BC", -6.0).force("B", Dof::ux, 13.0);
        REQUIRE(why_not_carried(pushed.model)->kind == RefusalKind::NotVertical);
        CHECK(pushed.model[why_not_carried(pushed.model)->nodes.front()].id == "B");
        CHECK(why_not_carried(pushed.model)->value == doctest::Approx(13.0));

        FrameMaker square = made; // 5 across the member to its right: 4 of it to the left, of a slope of 3 to 4
        square.load("AB", DistributedLoad{.values = {{.dof = Dof::uy, .start = 5.0}}, .axes = LoadAxes::Local});
        REQUIRE(why_not_carried(square.model)->kind == RefusalKind::NotVertical);
        CHECK(square.model[why_not_carried(square.model)->members.front()].id == "AB");
        CHECK(why_not_carried(square.model)->is_distributed);
        CHECK(why_not_carried(square.model)->value == doctest::Approx(-5.0 * 4.0 / 5.0));

        FrameMaker turned = made;
        turned.uniform("BC", -6.0).force("B", Dof::rz, 9.0);
        REQUIRE(why_not_carried(turned.model)->kind == RefusalKind::Couple);
        CHECK(why_not_carried(turned.model)->value == doctest::Approx(9.0));
    }

    TEST_CASE("A load of a sloping member's length counts for its projection, whichever way the member is named")
    {
        for (const bool is_reversed : {false, true}) {
            CAPTURE(is_reversed);
            FrameMaker made;
            made.node("A", 0, 0, Pin).node("B", 3, 4, Pin); // 5 long, 3 across
            if (is_reversed) made.member("B", "A");
            else made.member("A", "B");
            made.model.load_cases[0].members.push_back(
                {.member = MemberId(0), .load = DistributedLoad{.values = {{Dof::uy, -6.0, Quantity(-12.0)}}}});
            const Discretisation structure = discretise(made.model);
            const Chain chain = chain_of(structure, members_across(structure));
            const VerticalLoads loads = vertical_loads(made.model, structure, chain, CaseId(0));
            REQUIRE(loads.stretches.size() == 1);
            const Stretch& part = loads.stretches.front();
            CHECK(part.from == 0.0);
            CHECK(part.to == doctest::Approx(3.0));
            CHECK(part.start == doctest::Approx((is_reversed ? 12.0 : 6.0) * 5.0 / 3.0));
            CHECK(part.total() == doctest::Approx(9.0 * 5.0));
            CHECK(part.place() == doctest::Approx(is_reversed ? 3.0 * 4.0 / 9.0 : 3.0 * 5.0 / 9.0));
        }
    }
}
