// Drawing members: crossings, nodes on the way, lines drawn twice.
#include <doctest/doctest.h>

#include "femoop/edit/draw.h"
#include "femoop/edit/member_line.h"
#include "femoop/model/check/check.h"

using namespace femoop;

namespace {

using Point = Eigen::Vector3d;

Model beam_from(Point start, Point end)
{
    Model model;
    model.add(Material{.id = "steel", .E = 210e6});
    model.add(Section{.id = "s", .A = 0.01, .Iz = 1e-4});
    draw_member(model, start, end, Member{.material = MaterialId(0), .section = SectionId(0)});
    return model;
}

std::vector<MemberId> draw(Model& model, Point start, Point end)
{
    return draw_member(model, start, end, Member{.material = MaterialId(0), .section = SectionId(0)});
}

/// No member crosses or passes another one's node, none lies on another.
void check_is_clean(const Model& model)
{
    for (const Fault& fault : check(model)) {
        CAPTURE(message(fault));
        CHECK(fault.kind != FaultKind::MembersCross);
        CHECK(fault.kind != FaultKind::MembersOverlap);
        CHECK(fault.kind != FaultKind::MemberPassesNode);
        CHECK(fault.kind != FaultKind::CoincidentNodes);
    }
}

} // namespace

TEST_SUITE("edit: drawing")
{
    TEST_CASE("The first member of an empty model brings its two nodes")
    {
        const Model model = beam_from({0, 0, 0}, {4, 3, 0});
        REQUIRE(model.nodes.size() == 2);
        REQUIRE(model.members.size() == 1);
        CHECK(model.nodes[0].id == "A");
        CHECK(model.members[0].id == "AB");
        CHECK(model.nodes[1].at[1] == 3.0);
    }

    TEST_CASE("A member can be drawn across another without a node")
    {
        Model model = beam_from({0, 0, 0}, {10, 0, 0});
        draw_member(model, {4, -2, 0}, {4, 3, 0}, Member{.material = MaterialId(0), .section = SectionId(0)},
                    Crossings::Keep);
        CHECK(model.members.size() == 2);
        CHECK(model.nodes.size() == 4);
    }

    TEST_CASE("Crossing members are both cut and share a node")
    {
        Model model = beam_from({0, 0, 0}, {10, 0, 0});
        const auto drawn = draw(model, {4, -2, 0}, {4, 3, 0});
        CHECK(drawn.size() == 2);
        CHECK(model.members.size() == 4);
        REQUIRE(model.nodes.size() == 5);
        const NodeId middle = place_node(model, {4, 0, 0});
        CHECK(model.nodes.size() == 5);
        CHECK(member_between(model, NodeId(0), middle));
        CHECK(member_between(model, middle, NodeId(1)));
        check_is_clean(model);
    }

    TEST_CASE("A node placed on a member cuts it")
    {
        Model model = beam_from({0, 0, 0}, {10, 5, 0});
        const NodeId node = place_node(model, {4, 2, 0});
        CHECK(model.members.size() == 2);
        CHECK(member_between(model, NodeId(0), node));
        check_is_clean(model);
    }

    TEST_CASE("A line drawn twice is one, in either direction")
    {
        Model model = beam_from({0, 0, 0}, {10, 0, 0});
        const Model once = model;
        draw(model, {0, 0, 0}, {10, 0, 0});
        draw(model, {10, 0, 0}, {0, 0, 0});
        CHECK(model == once);
    }

    TEST_CASE("A line over part of another adds only what is new")
    {
        Model model = beam_from({0, 0, 0}, {10, 0, 0});
        const auto drawn = draw(model, {6, 0, 0}, {15, 0, 0});
        CHECK(drawn.size() == 2);
        CHECK(model.members.size() == 3);
        CHECK(model.nodes.size() == 4);
        check_is_clean(model);
    }

    TEST_CASE("A line passes through the nodes on its way")
    {
        Model model = beam_from({3, 0, 0}, {3, 4, 0});
        const auto drawn = draw(model, {0, 4, 0}, {9, 4, 0});
        REQUIRE(drawn.size() == 2);
        CHECK(model[drawn[0]].nodes[1] == NodeId(1));
        check_is_clean(model);
    }

    TEST_CASE("A grid drawn line by line has a node at each crossing and no member twice")
    {
        Model model = beam_from({0, 0, 0}, {12, 0, 0});
        for (int i = 1; i < 4; ++i) draw(model, {0, 1.7 * i, 0}, {12, 1.7 * i, 0});
        for (int i = 0; i < 5; ++i) draw(model, {3.0 * i, 0, 0}, {3.0 * i, 5.1, 0});
        CHECK(model.nodes.size() == 4 * 5);
        CHECK(model.members.size() == 4 * 4 + 3 * 5);
        check_is_clean(model);
    }

    TEST_CASE("A line without length is refused and changes nothing")
    {
        Model model = beam_from({0, 0, 0}, {10, 0, 0});
        const Model before = model;
        CHECK_THROWS_AS(draw(model, {2, 1, 0}, {2, 1, 0}), std::invalid_argument);
        CHECK(model == before);
    }

    TEST_CASE("Names go on in the manner of the others")
    {
        Model model = beam_from({0, 0, 0}, {4, 0, 0});
        model.nodes[0].id = "1";
        model.nodes[1].id = "2";
        model.members[0].id = "7";
        draw(model, {4, 0, 0}, {4, 3, 0});
        CHECK(model.nodes[2].id == "3");
        CHECK(model.members[1].id == "8");
    }

    TEST_CASE("After Z the names begin anew with a number")
    {
        Model model;
        for (int i = 0; i < 27; ++i) place_node(model, {1.0 * i, 0, 0});
        CHECK(model.nodes[25].id == "Z");
        CHECK(model.nodes[26].id == "A1");
    }
}
