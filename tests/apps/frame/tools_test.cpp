#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "apps/drawing/grid.h"
#include "apps/frame/document/drawing.h"
#include "apps/frame/document/load_cases.h"
#include "apps/frame/document/loading.h"
#include "apps/frame/document/number.h"
#include "apps/frame/tools/dimension_tool.h"
#include "apps/frame/tools/kept_settings.h"
#include "apps/frame/tools/load_tool.h"
#include "apps/frame/tools/member_tool.h"
#include "apps/frame/tools/node_tool.h"
#include "apps/frame/tools/part_tools.h"
#include "apps/frame/tools/select_tool.h"
#include "apps/frame/tools/tool_controller.h"
#include "apps/frame/tools/tool_loads.h"
#include "apps/frame/tools/typed_place.h"
#include "tests/frame_maker.h"
#include "ui/history/history.h"

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

frame::Aim aim_at(double x, double y)
{
    return {.pointer = {x, y},
            .on_sheet = {100.0 * x, -100.0 * y},
            .snap = {.place = {x, y}, .kind = SnapKind::Grid},
            .pixel = 0.01};
}

/// A document that tools work on, as the app's session holds it.
class Bench {
public:
    explicit Bench(frame::Document start = {}) : history(std::move(start)) {}

    void press(frame::Tool& tool, const frame::Aim& aim) { carry_out(tool.press(work(), aim)); }
    void move(frame::Tool& tool, const frame::Aim& aim) { carry_out(tool.move(work(), aim)); }
    void release(frame::Tool& tool, const frame::Aim& aim)
    {
        carry_out(tool.release(work(), aim));
        history.settle();
    }
    void click(frame::Tool& tool, const frame::Aim& aim)
    {
        press(tool, aim);
        release(tool, aim);
    }
    void drag(frame::Tool& tool, const frame::Aim& from, const frame::Aim& to)
    {
        press(tool, from);
        move(tool, to);
        release(tool, to);
    }
    void carry_out(const std::optional<frame::Change>& change)
    {
        if (!change) return;
        frame::Document next = change->step == frame::Step::Drag ? history.settled() : history.current();
        change->command(next);
        if (change->step == frame::Step::Drag) history.drag(next, change->label);
        else history.apply(next, change->label);
    }
    frame::Work work() { return {history.settled(), selection}; }
    const femoop::Model& model() const { return history.current().model; }

    ui::History<frame::Document> history;
    frame::Selection selection;
};

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

    TEST_CASE("Where nothing draws it, the pointer keeps to tenths of the grid, and along a member too")
    {
        CHECK(snapped(2.4637, 5.5182).place.isApprox(Vector2d(2.5, 5.5)));
        const Snap held = frame::snap(crossing(), {2.4637, 5.5182}, {.reach = 0.3, .is_off = true});
        CHECK(held == Snap{{2.4637, 5.5182}, SnapKind::Free});
        const double along = snapped(5.13, 3.92).place.norm(); // of the member that begins at the origin
        CHECK(along == doctest::Approx(6.5));
    }

    TEST_CASE("What began beside the grid goes on upright or level, unless the pointer is nearer to a line of the grid")
    {
        const femoop::Model empty;
        const SnapOptions options{.reach = 0.5, .grid = 1.0, .fine = 0.1, .from = Vector2d(0.55, 0.2)};
        CHECK(frame::snap(empty, {0.56, 7.9}, options) == Snap{{0.55, 8.0}, SnapKind::Ray});
        CHECK(frame::snap(empty, {8.1, 0.21}, options) == Snap{{8.0, 0.2}, SnapKind::Ray});
        CHECK(frame::snap(empty, {0.95, 7.9}, options) == Snap{{1.0, 8.0}, SnapKind::Grid});
        SnapOptions on_grid = options;
        on_grid.from = Vector2d(1.0, 0.0);
        CHECK(frame::snap(empty, {1.05, 7.9}, on_grid).place == Vector2d(1.0, 8.0));
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

    TEST_CASE("What is drawn level or upright ends on the grid's lines, else at tenths of them, from wherever it began")
    {
        const frame::SnapOptions from_column{.reach = 0.3, .grid = 1.0, .fine = 0.1, .from = Vector2d(20.23, 4.75)};
        CHECK(snapped(20.28, 9.18, from_column) == Snap{{20.23, 9.0}, SnapKind::Ray});
        CHECK(snapped(20.28, 9.43, from_column).place.isApprox(Vector2d(20.23, 9.4)));
        CHECK(snapped(24.63, 4.81, from_column).place.isApprox(Vector2d(24.6, 4.75)));
        const Snap slanting = snapped(23.1, 7.6, from_column); // at 45 degrees, 4.06 long
        CHECK((slanting.place - *from_column.from).norm() == doctest::Approx(4.0));
    }

    TEST_CASE("How drawing snaps is remembered in words, and the typed grid is as wide in a model of other units")
    {
        frame::ToolSettings left;
        left.draws_to_parts = false;
        left.spacing = "0.75 m";
        CHECK(frame::kept_words(left) == "grid on 0.75 m snap off");
        frame::ToolSettings begun;
        frame::take_up(begun, frame::kept_words(left));
        CHECK(frame::kept_words(begun) == frame::kept_words(left));
        CHECK(frame::typed_spacing(begun, femoop::Units{.length = femoop::LengthUnit::mm}) == 750.0);
        frame::take_up(begun, frame::kept_words(frame::ToolSettings{}));
        CHECK_FALSE(frame::typed_spacing(begun, {}));
        for (const char* const words : {"", "mesh off", "grid perhaps 7 mules snap"}) {
            CAPTURE(words);
            frame::ToolSettings settings;
            frame::take_up(settings, words);
            CHECK(settings.draws_to_grid);
            CHECK(settings.draws_to_parts);
            CHECK_FALSE(frame::typed_spacing(settings, {}));
        }
    }

    TEST_CASE("The grid is round")
    {
        CHECK(frame::round_grid(0.3) == doctest::Approx(0.5));
        CHECK(frame::round_grid(7.0) == doctest::Approx(10.0));
        CHECK(frame::round_grid(1.0) == doctest::Approx(1.0));
        CHECK(frame::round_grid(0.0011) == doctest::Approx(0.002));
    }

    TEST_CASE("The grid is counted, and ends where a place has no digits left for it")
    {
        CHECK(drawing::multiples_between(-1.2, 2.6, 0.5) ==
              std::vector<double>{-1.0, -0.5, 0.0, 0.5, 1.0, 1.5, 2.0, 2.5});
        CHECK(drawing::multiples_between(1e30 - 3.0, 1e30 + 3.0, 0.5).empty());
        CHECK(drawing::multiples_between(0.0, std::numeric_limits<double>::infinity(), 0.5).empty());
    }

    TEST_CASE("A place is typed as coordinates, as a step, as length and angle, or as a length")
    {
        const frame::DrawingHand tool_controller{.from = Vector2d(1, 2), .pointer = Vector2d(4, 6)};
        const auto typed = [&](const char* text) { return frame::place_typed(text, tool_controller); };
        CHECK(typed("6,4") == Vector2d(6, 4));
        CHECK(typed("@3,2") == Vector2d(4, 4));
        CHECK(typed("4<90") == Vector2d(1, 6));
        CHECK(typed("4<30")->isApprox(Vector2d(1 + 4 * std::sqrt(0.75), 4)));
        CHECK(typed("10")->isApprox(Vector2d(7, 10)));
        CHECK(typed("6,5;4,25") == Vector2d(6.5, 4.25));
        CHECK(typed("@-1,5;2") == Vector2d(-0.5, 4));
        CHECK(typed("2,5<180") == Vector2d(-1.5, 2));
    }

    TEST_CASE("Where numbers have decimal commas, one of them is a length once a line has begun")
    {
        const ui::DisplayUnits with_commas(ui::UnitSystem::KnM, {}, {.mark = ui::DecimalMark::Comma});
        const frame::DrawingHand begun{.from = Vector2d(0, 0), .pointer = Vector2d(1, 0), .shown = with_commas};
        CHECK(frame::place_typed("4,5", begun) == Vector2d(4.5, 0));
        CHECK(frame::place_typed("4,5;2", begun) == Vector2d(4.5, 2));
        CHECK(frame::place_typed("4, 5", begun) == Vector2d(4, 5));
        CHECK(frame::place_typed("@4,5", begun) == Vector2d(4, 5));
        CHECK(frame::place_typed("4,5", {.shown = with_commas}) == Vector2d(4, 5));
        CHECK(frame::place_typed_in_space("4,5", {.from = Eigen::Vector3d::Zero(),
                                                  .pointer = Eigen::Vector3d::UnitZ(),
                                                  .shown = with_commas}) == Eigen::Vector3d(0, 0, 4.5));
    }

    TEST_CASE("The angle of a typed place may have a unit")
    {
        const frame::DrawingHand tool_controller{.from = Vector2d(1, 2), .pointer = Vector2d(4, 6)};
        const auto typed = [&](const char* text) { return frame::place_typed(text, tool_controller); };
        const Vector2d up(1, 6), slanting(1 + 4 * std::sqrt(0.75), 4);
        for (const char* text : {"4<90 deg", "4<90°", "400 cm < 90 deg", "4<-270 deg", "4<180/2 °"}) {
            CAPTURE(std::string(text));
            CHECK(typed(text) == up);
        }
        for (const char* text : {"4<30 deg", "4<30°", "4 m<30 deg", "4<30,0°"}) {
            CAPTURE(std::string(text));
            REQUIRE(typed(text));
            CHECK(typed(text)->isApprox(slanting));
        }
        CHECK(typed("4<0.5 rad")->isApprox(Vector2d(1 + 4 * std::cos(0.5), 2 + 4 * std::sin(0.5))));
        for (const char* text : {"4<30 m", "4<30 deg deg", "4<deg", "4<1e999 deg", "4<30 grad"}) {
            CAPTURE(std::string(text));
            CHECK(!typed(text));
        }
    }

    TEST_CASE("What is no place is none, and a step needs a beginning")
    {
        const frame::DrawingHand tool_controller{.from = Vector2d(1, 2), .pointer = Vector2d(4, 6)};
        for (const char* text : {"", "x", "3,", ",", "@", "4<", "<30", "1,2,3", "@4", "nan,1", "1e999,0", "4<x"}) {
            CAPTURE(std::string(text));
            CHECK(!frame::place_typed(text, tool_controller));
        }
        for (const char* text : {"@3,2", "4<30", "4"}) CHECK(!frame::place_typed(text, {}));
    }

    TEST_CASE("A typed place is in the unit that is shown, or in one of its own")
    {
        const femoop::Units feet{.length = femoop::LengthUnit::ft, .force = femoop::ForceUnit::kip};
        const ui::DisplayUnits metres(ui::UnitSystem::KnM, frame::base_units(feet), {});
        const frame::DrawingHand tool_controller{.from = Vector2d(0, 0), .file = feet, .shown = metres};
        CHECK(frame::place_typed("0,3.048", tool_controller)->isApprox(Vector2d(0, 10)));
        CHECK(frame::place_typed("120 in,2*1.524", tool_controller)->isApprox(Vector2d(10, 10)));
        CHECK(frame::place_typed("10 ft<90", tool_controller)->isApprox(Vector2d(0, 10)));
        CHECK(!frame::place_typed("3 kN,2", tool_controller));
    }

    TEST_CASE("In space a place is typed as three coordinates, or in the working plane")
    {
        const Eigen::Vector3d from(1.0, 2.0, 3.0), pointer(1.0, 2.0, 8.0);
        const frame::WorkingPlane upright{.normal = frame::WorkingPlane::Normal::Y, .level = 7.0};
        const frame::SpaceHand tool_controller{.from = from, .pointer = pointer, .plane = upright};
        const auto typed = [&](const char* text) { return frame::place_typed_in_space(text, tool_controller); };
        CHECK(typed("6,4,-5")->isApprox(Eigen::Vector3d(6, 4, -5)));
        CHECK(typed("6,5;4;2*1.5")->isApprox(Eigen::Vector3d(6.5, 4, 3)));
        CHECK(typed("@0,0,3")->isApprox(Eigen::Vector3d(1, 2, 6)));
        CHECK(typed("6,4")->isApprox(Eigen::Vector3d(6, 7, 4)));   // x and z, at the level of the plane
        CHECK(typed("@6,4")->isApprox(Eigen::Vector3d(7, 2, 7)));  // x and z from where drawing began
        CHECK(typed("4<90")->isApprox(Eigen::Vector3d(1, 2, 7)));  // up
        CHECK(typed("2.5")->isApprox(Eigen::Vector3d(1, 2, 5.5))); // towards the pointer
        for (const char* text : {"", "6,4,5,3", "a,b,c", "@", "1,2,x"}) {
            CAPTURE(text);
            CHECK(!typed(text));
        }
        for (const char* text : {"@1,2,3", "@3,2", "4<30", "4"}) {
            CAPTURE(text);
            CHECK(!frame::place_typed_in_space(text, {}));
        }
    }

    TEST_CASE("Clicks draw a line that goes on from its last place until a second click there")
    {
        Bench bench;
        frame::MemberTool tool;
        for (const auto& place : {aim_at(0, 0), aim_at(0, 3), aim_at(5, 3), aim_at(5, 3)}) bench.click(tool, place);
        CHECK(bench.model().members.size() == 2);
        CHECK(!tool.from());
    }

    TEST_CASE("Dragging draws one member")
    {
        Bench bench;
        frame::MemberTool tool;
        bench.press(tool, aim_at(1, 1));
        bench.move(tool, aim_at(4, 2));
        CHECK(tool.preview().lines.size() == 1);
        bench.release(tool, aim_at(4, 2));
        CHECK(bench.model().members.size() == 1);
        CHECK(!tool.from());
    }

    TEST_CASE("A hand that trembles clicks, though its place is drawn elsewhere when the button is released")
    {
        Bench bench;
        frame::MemberTool tool;
        frame::Aim pressed = aim_at(7.263, 5.114), released = aim_at(7.28, 5.1);
        pressed.snap.place = {7.25, 5.1};
        released.snap.place = {7.272, 5.078};
        bench.press(tool, pressed);
        bench.release(tool, released);
        CHECK(bench.model().members.empty());
        CHECK(tool.from() == Vector2d(7.25, 5.1));
        bench.click(tool, aim_at(9, 6));
        CHECK(bench.model().members.size() == 1);
    }

    TEST_CASE("Drawing is drawn to where it began, and without parts to the grid alone")
    {
        CHECK(snapped(10.63, 9.57, {.reach = 0.3, .from = Vector2d(10.5, 9.5)}) == Snap{{10.5, 9.5}, SnapKind::Node});
        CHECK(snapped(0.1, 0.2, {.reach = 0.3, .to_parts = false}) == Snap{{0, 0}, SnapKind::Grid});
        CHECK(snapped(4.1, 3.2, {.reach = 0.3, .grid = 0.0, .to_parts = false}).kind == SnapKind::Free);
        CHECK(snapped(2.46, 5.93, {.reach = 0.3, .grid = 0.0, .fine = 0.25}).place.isApprox(Vector2d(2.5, 6.0)));
    }

    TEST_CASE("Esc gives up the line, and then the tool")
    {
        frame::ToolController tool_controller;
        tool_controller.select(frame::ToolKind::Member);
        Bench bench;
        bench.press(tool_controller.tool(), aim_at(1, 1));
        CHECK(tool_controller.escape());
        CHECK(tool_controller.kind() == frame::ToolKind::Member);
        CHECK(tool_controller.escape());
        CHECK(tool_controller.kind() == frame::ToolKind::Select);
        CHECK(!tool_controller.escape());
    }

    TEST_CASE("Members are drawn by typing alone, and what is no place stays to be mended")
    {
        frame::ToolController tool_controller;
        CHECK(!tool_controller.type("4"));
        tool_controller.select(frame::ToolKind::Member);
        Bench bench;
        for (const char* place : {"0,0", "4<90", "@6,0"}) {
            CHECK(tool_controller.type(place));
            bench.carry_out(tool_controller.enter(bench.work()));
            CHECK(tool_controller.typed().empty());
        }
        REQUIRE(bench.model().members.size() == 2);
        CHECK(bench.model().nodes[2].at[0] == 6.0);
        CHECK(bench.model().nodes[2].at[1] == 4.0);
        tool_controller.type("4<");
        CHECK(!tool_controller.enter(bench.work()));
        CHECK(tool_controller.typed() == "4<");
        tool_controller.backspace();
        CHECK(tool_controller.typed() == "4");
        tool_controller.type("<30°");
        tool_controller.backspace();
        CHECK(tool_controller.typed() == "4<30");
    }

    TEST_CASE("A dimension line is drawn from node to node, then to where it runs; more nodes go on along it")
    {
        Bench bench(frame::starting_document());
        frame::DimensionTool tool;
        const auto on = [](std::size_t i) {
            frame::Aim aim = aim_at(0, 0);
            aim.node = femoop::NodeId(i);
            return aim;
        };
        bench.click(tool, on(0));
        bench.click(tool, on(2)); // (0, 0) and (6, 4)
        bench.move(tool, aim_at(3, -1.01));
        REQUIRE(tool.preview().dimension);
        CHECK(tool.preview().dimension->direction == frame::DimensionDirection::Horizontal);
        bench.click(tool, aim_at(3, -1.01));
        const auto& lines = bench.history.current().companion.dimensions;
        REQUIRE(lines.size() == 1);
        CHECK(lines[0].nodes == std::vector<std::string>{"A", "C"});
        CHECK(lines[0].offset == doctest::Approx(-1.0)); // a round one
        bench.click(tool, on(3));
        CHECK(bench.history.current().companion.dimensions[0].nodes.size() == 3);
        CHECK(bench.history.n_states() == 3);
        bench.click(tool, on(3)); // the node that it has: the line ends
        CHECK(tool.preview().lines.empty());
        bench.click(tool, on(1));
        bench.click(tool, on(3));
        frame::Aim exact = aim_at(-0.513, 2);
        exact.is_exact = true;
        bench.click(tool, exact);
        CHECK(bench.history.current().companion.dimensions.size() == 2);
    }

    TEST_CASE("After an undo the next node begins another dimension line")
    {
        Bench bench(frame::starting_document());
        frame::ToolController tool_controller;
        tool_controller.select(frame::ToolKind::Dimension);
        for (const char* place : {"0,0", "6,0", "3,-0.8"}) {
            tool_controller.type(place);
            bench.carry_out(tool_controller.enter(bench.work()));
        }
        REQUIRE(bench.history.current().companion.dimensions.size() == 1);
        CHECK(bench.history.current().companion.dimensions[0].offset == doctest::Approx(-0.8));
        bench.history.undo();
        tool_controller.type("0,4");
        bench.carry_out(tool_controller.enter(bench.work()));
        CHECK(bench.history.current().companion.is_empty());
        tool_controller.type("6,4");
        tool_controller.enter(bench.work());
        tool_controller.tool().move(bench.work(), aim_at(2, 5));
        tool_controller.point_at(aim_at(2, 5));
        tool_controller.type("0.75"); // so far off, on the side of the pointer
        bench.carry_out(tool_controller.enter(bench.work()));
        REQUIRE(bench.history.current().companion.dimensions.size() == 1);
        CHECK(bench.history.current().companion.dimensions[0].nodes == std::vector<std::string>{"B", "C"});
        CHECK(bench.history.current().companion.dimensions[0].offset == doctest::Approx(0.75));
    }

    TEST_CASE("A dimension line is dragged to another distance, and deleted by a click")
    {
        frame::Document document = frame::starting_document();
        document.companion.dimensions.push_back(
            {.nodes = {"A", "D"}, .direction = frame::DimensionDirection::Horizontal, .offset = -1.0});
        Bench bench(document);
        frame::SelectTool select;
        frame::Aim line = aim_at(2, -1);
        line.dimension = frame::DimensionPlace{0};
        bench.drag(select, line, aim_at(2.5, -1.7));
        CHECK(bench.history.current().companion.dimensions[0].offset == doctest::Approx(-1.7));
        CHECK(bench.selection.contains(frame::DimensionPlace{0}));
        CHECK(bench.history.n_states() == 2);
        frame::DeleteTool erase;
        bench.click(erase, line);
        CHECK(bench.history.current().companion.is_empty());
    }

    TEST_CASE("A node clicked on a member cuts it")
    {
        Bench bench(frame::starting_document());
        frame::NodeTool tool;
        bench.click(tool, aim_at(3, 4));
        CHECK(bench.model().members.size() == 4);
    }

    TEST_CASE("A click selects one part, Shift adds and drops, a click beside all selects nothing")
    {
        Bench bench(frame::starting_document());
        frame::SelectTool tool;
        frame::Aim node = aim_at(0, 4);
        node.node = femoop::NodeId(1);
        bench.click(tool, node);
        CHECK(bench.selection.only() == frame::Part(femoop::NodeId(1)));
        frame::Aim member = aim_at(3, 4);
        member.cut = frame::Cut{femoop::MemberId(1), 3.0};
        member.adds = true;
        bench.click(tool, member);
        CHECK(bench.selection.size() == 2);
        bench.click(tool, member);
        CHECK(bench.selection.only() == frame::Part(femoop::NodeId(1)));
        bench.click(tool, aim_at(20, 20));
        CHECK(bench.selection.is_empty());
        CHECK(!bench.history.can_undo());
    }

    TEST_CASE("A window to the right takes what lies inside, one to the left what it touches")
    {
        Bench bench(frame::starting_document()); // A(0,0) B(0,4) C(6,4) D(6,0)
        frame::SelectTool tool;
        bench.drag(tool, aim_at(-1, -1), aim_at(2, 5));
        CHECK(bench.selection.size() == 3); // A, B, AB
        bench.drag(tool, aim_at(2, 5), aim_at(-1, -1));
        CHECK(bench.selection.size() == 4); // and BC, which it crosses
        bench.drag(tool, aim_at(3, 3), aim_at(2, 2));
        CHECK(bench.selection.is_empty());
    }

    TEST_CASE("In space a window takes what is seen in it, and a drag that began on a part moves none")
    {
        frame::Document start = frame::starting_document();
        start.model.analysis = femoop::AnalysisKind::Frame3d;
        for (femoop::Node& node : start.model.nodes) node.at = {node.at[0], 3.0, node.at[1]}; // upright
        Bench bench(start);
        ui::OrbitCamera camera;
        const frame::Projection projection{drawing::Camera(camera)};
        const auto aim_on = [&](ui::Point place) {
            frame::Aim aim = aim_at(0, 0);
            aim.on_sheet = place;
            aim.projection = projection;
            return aim;
        };
        const auto seen = [&](std::size_t node) {
            return projection(femoop::position_of(bench.model(), femoop::NodeId(node)));
        };
        frame::SelectTool tool;
        frame::Aim corner = aim_on(seen(1) - ui::Point{5.0, 5.0});
        corner.node = femoop::NodeId(1);
        bench.drag(tool, corner, aim_on(seen(1) + ui::Point{5.0, 5.0}));
        CHECK(bench.selection.only() == frame::Part(femoop::NodeId(1)));
        CHECK(!bench.history.can_undo());
        bench.drag(tool, aim_on(seen(1) + ui::Point{5.0, 5.0}), aim_on(seen(1) - ui::Point{5.0, 5.0}));
        CHECK(bench.selection.size() == 3); // and AB and BC, which it touches
        bench.click(tool, corner);
        CHECK(bench.selection.only() == frame::Part(femoop::NodeId(1)));
        corner.adds = true;
        bench.click(tool, corner);
        CHECK(bench.selection.is_empty());
    }

    TEST_CASE(
        "On a member in space a place is drawn to its middle, the foot of a square line, a crossing, or a round length")
    {
        femoop::Model model = crossing();
        model.analysis = femoop::AnalysisKind::Frame3d;
        for (femoop::Node& node : model.nodes) node.at = {node.at[0], 2.0, node.at[1]};
        const auto meant = [&](double x, frame::SnapInSpaceOptions options) {
            return frame::snap_on_member(model, {femoop::MemberId(0), x}, options);
        };
        CHECK(meant(5.1, {.reach = 0.2}).kind == SnapKind::Intersection);
        CHECK(meant(5.1, {.reach = 0.2}).place.isApprox(Eigen::Vector3d(4, 2, 3)));
        model.members.pop_back();
        CHECK(meant(5.1, {.reach = 0.2}).kind == SnapKind::Midpoint);
        const auto foot = meant(6.5, {.reach = 0.2, .from = Eigen::Vector3d(8, 5, 0)});
        CHECK(foot.kind == SnapKind::Perpendicular);
        CHECK(foot.place.isApprox(Eigen::Vector3d(5.12, 2, 3.84)));
        CHECK(meant(7.04, {.reach = 0.2, .fine = 0.1}).place.isApprox(Eigen::Vector3d(5.6, 2, 4.2)));
        CHECK(meant(7.04, {.reach = 0.2, .fine = 0.1, .is_off = true}).place.norm() ==
              doctest::Approx(std::hypot(7.04, 2)));
    }

    TEST_CASE("A drag moves the selection to where it is drawn, as one step, and joins what meets")
    {
        Bench bench(frame::starting_document());
        frame::SelectTool tool;
        frame::Aim corner = aim_at(6, 4);
        corner.node = femoop::NodeId(2);
        bench.press(tool, corner);
        bench.move(tool, aim_at(7, 5));
        bench.move(tool, aim_at(8, 6));
        CHECK(bench.model().nodes[2].at[0] == 8.0);
        bench.release(tool, aim_at(8, 6));
        CHECK(bench.history.n_states() == 2);
        CHECK(bench.model().nodes[2].at[1] == 6.0);
        frame::Aim foot = aim_at(6, 0);
        foot.node = femoop::NodeId(3);
        bench.drag(tool, foot, aim_at(8, 6));
        CHECK(bench.model().nodes.size() == 3);
        bench.history.undo();
        bench.history.undo();
        CHECK(bench.history.current() == frame::starting_document());
    }

    TEST_CASE("A drag shows what it will join and cut, and lets go of it again as the hand goes on")
    {
        Bench bench(frame::starting_document());
        frame::SelectTool tool;
        frame::Aim foot = aim_at(6, 0); // of the right column
        foot.node = femoop::NodeId(3);
        bench.press(tool, foot);
        bench.move(tool, aim_at(0, 0));
        CHECK(bench.model().nodes.size() == 3); // on the left foot
        bench.move(tool, aim_at(-3, 0));
        CHECK(bench.model().nodes.size() == 5); // CD crosses the left column
        bench.move(tool, aim_at(2, 1));
        CHECK(bench.model().nodes.size() == 4);
        bench.release(tool, aim_at(2, 1));
        CHECK(bench.model().nodes[3].at[0] == 2.0);
        CHECK(bench.history.n_states() == 2);
    }

    TEST_CASE("A load's arrow is pulled to twice its length: twice the load, rounded to three digits")
    {
        Bench bench(frame::starting_document());
        frame::SelectTool tool;
        const frame::Part load = frame::MemberLoadPlace{0, 0};
        const auto value = [&] { return frame::numbers(bench.model(), load).front().value->value(); };
        const double before = value();
        frame::Aim arrow = aim_at(3, 5);
        arrow.grip = frame::LoadGrip{load, femoop::Dof::uy, {0.0, 1.0}};
        bench.drag(tool, arrow, aim_at(3, 6));
        CHECK(value() == doctest::Approx(2.0 * before));
        CHECK(bench.history.n_states() == 2);
    }

    TEST_CASE("A point load that is dragged along its member moves there by round steps, and keeps its value")
    {
        for (const femoop::Position& start :
             {femoop::Position(femoop::Quantity(2.0)), femoop::Position(femoop::Percent{25.0})}) {
            FrameMaker made;
            made.node("A", 0, 0, femoop::SupportKind::Pin)
                .node("B", 8, 0, femoop::SupportKind::Roller)
                .member("A", "B");
            made.load("AB", femoop::PointLoad{.at = start, .components = {{femoop::Dof::uy, -30.0}}});
            Bench bench(frame::Document{.model = made.model, .companion = {}});
            frame::SelectTool tool;
            frame::Aim arrow = aim_at(2, 0.5);
            arrow.grip = frame::LoadGrip{frame::MemberLoadPlace{0, 0}, femoop::Dof::uy, {0.0, 1.0}};
            const auto point = [&] { return std::get<femoop::PointLoad>(bench.model().load_cases[0].members[0].load); };
            bench.drag(tool, arrow, aim_at(5.512, 0.7));
            CHECK(point().at.index() == start.index());
            CHECK(*frame::place_of_load(bench.model(), frame::MemberLoadPlace{0, 0}) == doctest::Approx(5.5));
            CHECK(point().components[0].value.value() == -30.0);
            CHECK(bench.history.n_states() == 2);
            arrow.pointer = {5.5, 0.5};
            bench.drag(tool, arrow, aim_at(12, 0.5));
            CHECK(*frame::place_of_load(bench.model(), frame::MemberLoadPlace{0, 0}) ==
                  doctest::Approx(8.0)); // its end
        }
    }

    TEST_CASE("A support's symbol that is dragged about its node turns the support, by whole multiples of 15 degrees")
    {
        frame::Document start = frame::starting_document();
        start.model.nodes[0].support = femoop::Support{.kind = femoop::SupportKind::Roller};
        const Eigen::Vector2d node{start.model.nodes[0].at[0], start.model.nodes[0].at[1]};
        Bench bench(start);
        frame::SelectTool tool;
        const auto aim_around = [&](double degrees) {
            const double t = degrees * std::numbers::pi / 180.0;
            return aim_at(node.x() + 0.4 * std::cos(t), node.y() + 0.4 * std::sin(t));
        };
        frame::Aim below = aim_around(-90.0);
        below.support = frame::SupportGrip{femoop::NodeId(0), -90.0};
        bench.drag(tool, below, aim_around(-62.0));
        const femoop::Support& turned = *bench.model().nodes[0].support;
        CHECK(turned.angle == 30.0);
        CHECK(turned.blocked(femoop::AnalysisKind::Frame2d) == femoop::DofSet{femoop::Dof::uy});
        CHECK(bench.history.n_states() == 2);
        frame::Aim exact = aim_around(-60.0 - 38.0);
        exact.is_exact = true;
        below.support->angle = -60.0;
        bench.drag(tool, below, exact);
        CHECK(bench.model().nodes[0].support->angle == -8.0);
        bench.history.undo();
        bench.history.undo();
        CHECK(bench.history.current() == start);
    }

    TEST_CASE("The support tool sets and takes away, the hinge tool opens and closes")
    {
        Bench bench(frame::starting_document());
        frame::ToolController tool_controller;
        tool_controller.select(frame::ToolKind::Support);
        frame::Aim corner = aim_at(0, 4);
        corner.node = femoop::NodeId(1);
        bench.click(tool_controller.tool(), corner);
        REQUIRE(bench.model().nodes[1].support);
        CHECK(bench.model().nodes[1].support->kind == femoop::SupportKind::Pin);
        bench.click(tool_controller.tool(), corner);
        CHECK(!bench.model().nodes[1].support);
        tool_controller.select(frame::ToolKind::Hinge);
        frame::Aim near_end = aim_at(5, 4);
        near_end.cut = frame::Cut{femoop::MemberId(1), 5.0};
        bench.click(tool_controller.tool(), near_end);
        CHECK(bench.model().members[1].end.release.contains(femoop::Dof::rz));
        bench.click(tool_controller.tool(), near_end);
        CHECK(bench.model().members[1].end.release.is_empty());
        bench.click(tool_controller.tool(), corner);
        CHECK(bench.model().nodes[1].hinge);
    }

    TEST_CASE("The load tool loads nodes and members, and makes a load case where there is none")
    {
        frame::Document document = frame::starting_document();
        document.model.load_cases.clear();
        document.model.combinations.clear();
        Bench bench(document);
        frame::ToolController tool_controller;
        tool_controller.select(frame::ToolKind::Load);
        frame::Aim beam = aim_at(2, 4);
        beam.cut = frame::Cut{femoop::MemberId(1), 2.0};
        bench.click(tool_controller.tool(), beam);
        tool_controller.settings().load = {frame::LoadKind::Force, frame::LoadWay::X};
        tool_controller.settings().force = femoop::Quantity(7.0);
        frame::Aim corner = aim_at(0, 4);
        corner.node = femoop::NodeId(1);
        bench.click(tool_controller.tool(), corner);
        bench.click(tool_controller.tool(), corner);
        bench.click(tool_controller.tool(), beam);
        REQUIRE(bench.model().load_cases.size() == 1);
        const femoop::LoadCase& loads = bench.model().load_cases[0];
        CHECK(loads.members.size() == 2);
        REQUIRE(loads.nodes.size() == 1);
        CHECK(loads.nodes[0].components[0].value == 14.0);
        CHECK(std::get<femoop::PointLoad>(loads.members[1].load).at == femoop::Position(femoop::Quantity(2.0)));
    }

    TEST_CASE("The load tool has a force and a moment for every direction in which a structure of a kind can be loaded")
    {
        using enum femoop::AnalysisKind;
        for (const femoop::AnalysisKind kind : {Truss2d, Frame2d, Grillage, Truss3d, Frame3d}) {
            CAPTURE(name(kind));
            femoop::DofSet reached;
            for (const frame::ToolLoadEntry& entry : frame::tool_loads(kind))
                if (const auto load = frame::force_of({.load = entry.load, .force = 7.0, .moment = 5.0}, kind)) {
                    const bool is_down = entry.load.way == frame::LoadWay::Down;
                    CHECK(load->value == femoop::Quantity(is_rotation(load->dof) ? 5.0 : is_down ? -7.0 : 7.0));
                    reached.insert(load->dof);
                }
            CHECK(reached == femoop::dofs(kind));
        }
    }

    TEST_CASE("A load that another kind of structure lacks becomes one of its sort that it has")
    {
        using enum femoop::AnalysisKind;
        const frame::ToolLoad along_y{frame::LoadKind::Force, frame::LoadWay::Y};
        CHECK(frame::entry_of(along_y, Frame3d).name == "Force along y");
        CHECK(frame::entry_of(along_y, Frame2d).name == "Force ↓");
        CHECK(frame::entry_of({frame::LoadKind::Moment, frame::LoadWay::Z}, Grillage).name == "Moment about x");
    }

    TEST_CASE("In space a member is loaded along y")
    {
        frame::Document start = frame::starting_document();
        start.model.analysis = femoop::AnalysisKind::Frame3d;
        Bench bench(start);
        frame::ToolSettings settings{.load = {frame::LoadKind::Uniform, frame::LoadWay::Y}, .line_load = 7.0};
        frame::LoadTool tool(settings);
        frame::Aim beam = aim_at(2, 4);
        beam.cut = frame::Cut{femoop::MemberId(1), 2.0};
        bench.click(tool, beam);
        const auto& load = std::get<femoop::DistributedLoad>(bench.model().load_cases[0].members.back().load);
        CHECK(load.values[0].dof == femoop::Dof::uy);
        CHECK(load.values[0].start == 7.0);
        CHECK(load.axes == femoop::LoadAxes::Global);
    }

    TEST_CASE("A stroke along a member loads that part of it; a triangle grows the way of the stroke")
    {
        Bench bench(frame::starting_document());
        frame::ToolSettings settings{.load = {frame::LoadKind::Triangular, frame::LoadWay::Down}, .line_load = 7.0};
        frame::LoadTool tool(settings);
        const auto on_beam = [](double x, double pixel = 0.01) {
            frame::Aim aim = aim_at(x, 4.0);
            aim.cut = frame::Cut{femoop::MemberId(1), x};
            aim.pixel = pixel;
            return aim;
        };
        bench.press(tool, on_beam(5.0));
        bench.move(tool, on_beam(2.0));
        CHECK(tool.preview().lines.size() == 1);
        bench.release(tool, on_beam(2.0));
        const auto loads = [&] { return bench.model().load_cases[0].members; };
        REQUIRE(loads().size() == 2);
        const auto part = std::get<femoop::DistributedLoad>(loads()[1].load);
        CHECK(std::get<femoop::Quantity>(*part.from).value() == 2.0);
        CHECK(std::get<femoop::Quantity>(*part.to).value() == 5.0);
        CHECK(part.values[0].start.value() == -7.0);
        CHECK(part.values[0].end->value() == 0.0);
        bench.press(tool, on_beam(5.0));
        bench.move(tool, on_beam(5.03)); // a hand trembles
        bench.release(tool, on_beam(5.03));
        REQUIRE(loads().size() == 3);
        const auto whole = std::get<femoop::DistributedLoad>(loads()[2].load);
        CHECK((!whole.from && !whole.to));
        CHECK(whole.values[0].end->value() == -7.0); // the nearer end
    }

    TEST_CASE("A combination of all load cases follows them, and a copy has a name of its own")
    {
        frame::Document document = frame::starting_document();
        CHECK(document.model.case_name(add_load_case(document)) == "1");
        CHECK(document.model.case_name(add_combination(document)) == "C");
        REQUIRE(document.model.combinations[0].terms.size() == 2);
        const femoop::CaseId copy = copy_case(document, femoop::CaseId(0)); // goes before the combination
        CHECK(document.model.case_name(copy) == "G2");
        CHECK(document.model.load_cases[2].members == document.model.load_cases[0].members);
        CHECK(document.model.case_name(copy_case(document, femoop::CaseId(3))) == "C2");
        CHECK(document.model.combinations[1].terms == document.model.combinations[0].terms);
        CHECK(frame::why_not_rename(document.model, copy, "C"));
        CHECK(frame::why_not_rename(document.model, copy, "  "));
        CHECK_FALSE(frame::why_not_rename(document.model, copy, "G2"));
        rename(document, copy, "W");
        CHECK(document.model.load_cases[2].id == "W");
    }

    TEST_CASE("The delete tool takes out what is clicked")
    {
        Bench bench(frame::starting_document());
        frame::DeleteTool tool;
        frame::Aim beam = aim_at(3, 4);
        beam.cut = frame::Cut{femoop::MemberId(1), 3.0};
        bench.click(tool, beam);
        CHECK(bench.model().members.size() == 2);
        bench.click(tool, aim_at(20, 20));
        CHECK(bench.history.n_states() == 2);
    }

    TEST_CASE("A selection follows its parts by their names when others go before them")
    {
        frame::Document document = frame::starting_document();
        frame::Selection selection = frame::Part(femoop::NodeId(3));
        selection.add(femoop::MemberId(2));
        const frame::Document before = document;
        frame::remove(document, std::array{frame::Part(femoop::NodeId(0))});
        selection.follow(before, document);
        CHECK(selection.parts()[0] == frame::Part(femoop::NodeId(2)));
        CHECK(selection.parts()[1] == frame::Part(femoop::MemberId(1)));
    }

    TEST_CASE("Parts are selected by what they have in common")
    {
        const femoop::Model model = frame::starting_document().model;
        CHECK(frame::similar(model, frame::Part(femoop::MemberId(0))).size() == 2); // the columns
        CHECK(frame::similar(model, frame::Part(femoop::NodeId(0))).size() == 2);   // the fixed bases
        CHECK(frame::everything(model).size() == model.nodes.size() + model.members.size());
    }
}
