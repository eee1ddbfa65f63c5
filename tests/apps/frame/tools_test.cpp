#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "apps/frame/document/drawing.h"
#include "apps/frame/tools/member_tool.h"
#include "apps/frame/tools/node_tool.h"
#include "apps/frame/tools/typed_place.h"

using Eigen::Vector2d;
using frame::Snap;
using frame::SnapKind;
using frame::SnapOptions;

namespace {

/// Two members that cross at (4, 3) without a node, in a model whose grid is 1.
femoop::Model crossing()
{
    femoop::Model model = frame::starting_document().model;
    model.nodes[0].at = {0, 0};
    model.nodes[1].at = {8, 6};
    model.nodes[2].at = {0, 6};
    model.nodes[3].at = {8, 0};
    model.members[1].nodes = {femoop::NodeId(2), femoop::NodeId(3)};
    model.members.pop_back();
    return model;
}

Snap snapped(double x, double y, SnapOptions options = {.reach = 0.3})
{
    return frame::snap(crossing(), {x, y}, options);
}

Snap at(double x, double y) { return {.place = {x, y}, .kind = SnapKind::Grid}; }

/// Plays what the tool asks for.
void carry_out(frame::Document& document, const std::optional<frame::Change>& change)
{
    if (change) change->command(document);
}

} // namespace

TEST_SUITE("frame tools")
{
    TEST_CASE("The pointer is drawn to the strongest thing within reach")
    {
        CHECK(snapped(0.1, 0.2) == Snap{{0, 0}, SnapKind::Node});
        CHECK(snapped(4.1, 3.2).kind == SnapKind::Intersection);
        CHECK(snapped(4.1, 3.2).place.isApprox(Vector2d(4, 3)));
        CHECK(snapped(5.1, 3.9).kind == SnapKind::OnMember);
        CHECK(snapped(2.2, 5.9) == Snap{{2, 6}, SnapKind::Grid});
        CHECK(snapped(2.5, 5.5) == Snap{{2.5, 5.5}, SnapKind::Free});
    }

    TEST_CASE("The middle of a member is found, and the foot of a line square to it")
    {
        femoop::Model model = crossing();
        model.members.pop_back();
        CHECK(frame::snap(model, {4.2, 3.1}, {.reach = 0.3}).kind == SnapKind::Midpoint);
        const Snap foot = frame::snap(model, {1.1, 0.9}, {.reach = 0.3, .grid = 0.0, .from = Vector2d(0, 2)});
        CHECK(foot.kind == SnapKind::Perpendicular);
        CHECK((foot.place - Vector2d(0, 2)).dot(Vector2d(8, 6)) == doctest::Approx(0.0));
    }

    TEST_CASE("A line is drawn to multiples of 15 degrees and round lengths")
    {
        const Snap ray = snapped(20.0, 5.4, {.reach = 0.3, .grid = 0.0, .from = Vector2d(0, 0)});
        CHECK(ray.kind == SnapKind::Ray);
        CHECK(std::atan2(ray.place.y(), ray.place.x()) == doctest::Approx(std::acos(-1.0) / 12.0));
        const Snap round = snapped(0.1, 9.05, {.reach = 0.3, .grid = 0.0, .from = Vector2d(0.05, 7)});
        CHECK(round.kind == SnapKind::Ray);
        CHECK(round.place.x() == doctest::Approx(0.05));
    }

    TEST_CASE("The grid is round")
    {
        CHECK(frame::round_grid(0.3) == doctest::Approx(0.5));
        CHECK(frame::round_grid(7.0) == doctest::Approx(10.0));
        CHECK(frame::round_grid(1.0) == doctest::Approx(1.0));
        CHECK(frame::round_grid(0.0011) == doctest::Approx(0.002));
    }

    TEST_CASE("A place is typed as coordinates, as a step, as length and angle, or as a length")
    {
        const frame::DrawingHand hand{.from = Vector2d(1, 2), .pointer = Vector2d(4, 6)};
        const auto typed = [&](const char* text) { return frame::place_typed(text, hand); };
        CHECK(typed("6,4") == Vector2d(6, 4));
        CHECK(typed("@3,2") == Vector2d(4, 4));
        CHECK(typed("4<90") == Vector2d(1, 6));
        CHECK(typed("4<30")->isApprox(Vector2d(1 + 4 * std::sqrt(0.75), 4)));
        CHECK(typed("10")->isApprox(Vector2d(7, 10)));
        CHECK(typed("6,5;4,25") == Vector2d(6.5, 4.25));
        CHECK(typed("@-1,5;2") == Vector2d(-0.5, 4));
        CHECK(typed("2,5<180") == Vector2d(-1.5, 2));
    }

    TEST_CASE("What is no place is none, and a step needs a beginning")
    {
        const frame::DrawingHand hand{.from = Vector2d(1, 2), .pointer = Vector2d(4, 6)};
        for (const char* text : {"", "x", "3,", ",", "@", "4<", "<30", "1,2,3", "@4", "nan,1", "1e999,0", "4<x"}) {
            CAPTURE(std::string(text));
            CHECK(!frame::place_typed(text, hand));
        }
        for (const char* text : {"@3,2", "4<30", "4"}) CHECK(!frame::place_typed(text, {}));
    }

    TEST_CASE("Clicks draw a line that goes on from its last place until a second click there")
    {
        frame::Document document;
        frame::MemberTool tool;
        for (const Snap& place : {at(0, 0), at(0, 3), at(5, 3), at(5, 3)}) {
            carry_out(document, tool.press(place));
            carry_out(document, tool.release(place));
        }
        CHECK(document.model.members.size() == 2);
        CHECK(!tool.from());
    }

    TEST_CASE("Dragging draws one member")
    {
        frame::Document document;
        frame::MemberTool tool;
        carry_out(document, tool.press(at(1, 1)));
        tool.move(at(4, 2));
        CHECK(tool.preview().lines.size() == 1);
        carry_out(document, tool.release(at(4, 2)));
        CHECK(document.model.members.size() == 1);
        CHECK(!tool.from());
    }

    TEST_CASE("Esc gives up the line, and then the tool")
    {
        frame::MemberTool tool;
        tool.press(at(1, 1));
        CHECK(tool.escape());
        CHECK(!tool.escape());
        CHECK(tool.preview().lines.empty());
    }

    TEST_CASE("Members are drawn by typing alone")
    {
        frame::Document document;
        frame::MemberTool tool;
        carry_out(document, tool.type({0, 0}));
        carry_out(document, tool.type(*frame::place_typed("4<90", {.from = tool.from()})));
        carry_out(document, tool.type(*frame::place_typed("@6,0", {.from = tool.from()})));
        REQUIRE(document.model.members.size() == 2);
        CHECK(document.model.nodes[2].at[0] == 6.0);
        CHECK(document.model.nodes[2].at[1] == 4.0);
    }

    TEST_CASE("A node clicked on a member cuts it")
    {
        frame::Document document = frame::starting_document();
        frame::NodeTool tool;
        carry_out(document, tool.press({.place = {3, 4}, .kind = SnapKind::Midpoint}));
        CHECK(document.model.members.size() == 4);
    }
}
