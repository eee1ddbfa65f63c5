// The document of the plane app and its commands, without a screen.
#include "apps/plane/document/analysed.h"
#include "apps/plane/document/attributes.h"
#include "apps/plane/document/curve_draft.h"
#include "apps/plane/document/erase.h"
#include "apps/plane/document/fault_words.h"
#include "apps/plane/document/load_cases.h"
#include "apps/plane/document/number.h"
#include "apps/plane/document/outlines.h"
#include "apps/plane/document/points.h"
#include "apps/plane/document/regions.h"
#include "apps/plane/document/rename.h"
#include "apps/plane/document/solution.h"
#include "femoop/io/plane/field_text.h"
#include "femoop/io/plane/plane_file.h"
#include "ui/text/catalogue.h"
#include "ui/text/number_format.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <memory>
#include <numbers>

using namespace plane;
using discretize::Drawing;
using femoop::plane::DrawnKind;

namespace {

CurveId line(Document& document, FlatPoint a, FlatPoint b) { return draw_curve(document, {.places = {{a}, {b}}}); }

/// Corner by corner, a line for each side.
void outline(Document& document, const std::vector<FlatPoint>& corners)
{
    for (std::size_t i = 0; i < corners.size(); ++i) line(document, corners[i], corners[(i + 1) % corners.size()]);
}

/// A plate of 70 by 30 that has an entry.
Document plate()
{
    Document document = new_document();
    outline(document, {{0, 0}, {70, 0}, {70, 30}, {0, 30}});
    make_region(document, {11, 12});
    return document;
}

/// What `change` makes of it, its faces followed.
template <class Command> Document after(const Document& document, const Command& change)
{
    const Drawing before(document.model);
    Document now = document;
    change(now);
    follow_faces(now, before);
    return now;
}

/// The names of the entries of all faces, the largest face first; "-" where one has none.
std::string entries(const Document& document)
{
    std::string text;
    const Drawing drawing(document.model);
    for (const auto& face : drawing.faces())
        text += (text.empty() ? "" : " ") + (face.region ? document.model[*face.region].id : std::string("-"));
    return text;
}

} // namespace

TEST_CASE("A line that ends within straight sides stays on them where a corner of these is dragged")
{
    Document document = plate();
    const std::size_t n_points = document.model.points.size();
    draw_curve(document, {.kind = femoop::plane::DrawnKind::Line, .places = {{{35, 0}}, {{35, 30}}}});
    REQUIRE(Drawing(document.model).faces().size() == 2);
    move_point(document, NodeId(2U), {90, 41}); // C, from (70, 30)
    const Drawing drawing(document.model);
    REQUIRE(drawing.faces().size() == 2);
    const auto lower = place_of(document.model, NodeId(n_points)),
               upper = place_of(document.model, NodeId(n_points + 1));
    CHECK(lower == FlatPoint{35, 0});
    CHECK(upper.x == doctest::Approx(45.0)); // half of the side from (90, 41) to (0, 30)
    CHECK(upper.y == doctest::Approx(35.5));
}

TEST_CASE("Lines that share a place share a point, so that dragging one moves the corner of both")
{
    const Document document = plate();
    CHECK(document.model.points.size() == 4);
    CHECK(document.model.curves.size() == 4);
    CHECK(document.model.points[2].id == "C");
    Document moved = document;
    move_point(moved, NodeId(2U), {90, 41});
    CHECK(Drawing(moved.model).faces().front().area == doctest::Approx(70 * 30 + (20 * 30 + 11 * 70) / 2.0));
}

TEST_CASE("A face without an entry gets one of steel, 10 mm thick, and the next one is alike")
{
    Document document = plate();
    const PlaneModel& model = document.model;
    REQUIRE(model.regions.size() == 1);
    CHECK(model.regions[0].id == "R1");
    CHECK(model[model.regions[0].material].id == "steel");
    CHECK(model[model.regions[0].material].E == doctest::Approx(200e3)); // N/mm2
    CHECK(model.regions[0].thickness.value().value() == doctest::Approx(10.0));
    document.model.regions[0].thickness = femoop::Quantity(7.0);
    outline(document, {{100, 0}, {120, 0}, {120, 15}});
    const RegionId next = make_region(document, {115, 2});
    CHECK(document.model[next].id == "R2");
    CHECK(document.model[next].thickness.value().value() == 7.0);
    CHECK(document.model.materials.size() == 1);
}

TEST_CASE("A region that a curve splits keeps its entry in both parts, and in what a new curve encloses")
{
    const Document split = after(plate(), [](Document& d) { line(d, {23, 0}, {23, 30}); });
    CHECK(entries(split) == "R1 R1");
    CHECK(split.model.regions[0].is_listed);
    CHECK(split.model.regions[0].at.size() == 2);
    const Document pierced = after(plate(), [](Document& d) {
        draw_curve(d, {.kind = DrawnKind::Circle, .center = DraftPlace{{40, 15}}, .radius = 5.0});
    });
    CHECK(entries(pierced) == "R1 R1");
}

TEST_CASE("Beside a region a new face has no entry")
{
    const Document beside = after(plate(), [](Document& d) { outline(d, {{70, 0}, {110, 0}, {110, 30}, {70, 30}}); });
    CHECK(entries(beside) == "R1 -");
}

TEST_CASE("A region whose place a dragged curve has swept over goes on with another place in the same outline")
{
    const Document dragged = after(plate(), [](Document& d) {
        move_point(d, NodeId(0U), {30, 0});
        move_point(d, NodeId(3U), {30, 30});
    });
    CHECK(entries(dragged) == "R1");
    CHECK(Drawing(dragged.model).is_sound());
}

TEST_CASE("Regions that become one are joined where they are alike, else somebody must choose")
{
    Document document = plate();
    const CurveId wall = line(document, {70, 30}, {110, 5});
    line(document, {70, 0}, {110, 5});
    make_region(document, {80, 6});
    const Drawing two(document.model);
    REQUIRE(entries(document) == "R1 R2");
    const CurveId between{1U}; // B to C, the border of both
    static_cast<void>(wall);
    const auto open = [&](Document& d) { erase_parts(d, std::vector<Part>{between}); };
    const Document joined = after(document, open);
    CHECK(entries(joined) == "R1");
    CHECK(joined.model.regions.size() == 1);

    document.model.regions[1].thickness = femoop::Quantity(3.0);
    Document disputed = after(document, open);
    const Drawing drawing(disputed.model);
    const auto dispute = dispute_in(disputed.model, drawing);
    REQUIRE(dispute);
    CHECK(disputed.model[dispute->first].id == "R1");
    CHECK(disputed.model[dispute->second].id == "R2");
    settle_dispute(disputed, drawing, *dispute, dispute->second);
    CHECK(entries(disputed) == "R2");
    CHECK(disputed.model.regions.size() == 1);
}

TEST_CASE("An entry goes with the last curve of its face, and stays while its outline is open")
{
    const Document open = after(plate(), [](Document& d) { erase_parts(d, std::vector<Part>{CurveId(0U)}); });
    REQUIRE(open.model.regions.size() == 1);
    CHECK_FALSE(Solution(open).is_sound());
    const Document closed = after(open, [](Document& d) { line(d, {0, 0}, {70, 0}); });
    CHECK(entries(closed) == "R1");
    const Document gone = after(plate(), [](Document& d) {
        erase_parts(d, std::vector<Part>{CurveId(0U), CurveId(1U), CurveId(2U), CurveId(3U)});
    });
    CHECK(gone.model.regions.empty());
    CHECK(gone.model.points.empty());
}

TEST_CASE("A hole in a face that shares its entry is a hole of its own")
{
    Document document = after(plate(), [](Document& d) {
        draw_curve(d, {.kind = DrawnKind::Circle, .center = DraftPlace{{40, 15}}, .radius = 5.0});
    });
    const Solution solution(document);
    set_hole(document, *solution.drawing(), 1, true);
    const Drawing drawing(document.model);
    CHECK(entries(document) == "R1 R2");
    CHECK(document.model.regions[1].is_hole);
    CHECK(drawing.faces()[0].area == doctest::Approx(70 * 30 - std::numbers::pi * 25));
    set_hole(document, drawing, 1, false);
    CHECK_FALSE(document.model.regions[1].is_hole);
    CHECK(document.model[document.model.regions[1].material].id == "steel");
}

TEST_CASE("An arc about a centre stays an arc when one of its points is dragged")
{
    Document document = new_document();
    draw_curve(document, {.kind = DrawnKind::Arc, .places = {{{10, 0}}, {{0, 10}}}, .center = DraftPlace{{0, 0}}});
    const auto& points = document.model.points; // start, end, centre
    move_point(document, NodeId(0U), {16, 0});
    CHECK(points[1].at[1] == doctest::Approx(16.0));
    CHECK(points[1].at[0] == doctest::Approx(0.0));
    move_point(document, NodeId(2U), {5, 1}); // onto the line between both ends
    CHECK(points[2].at[0].value() == doctest::Approx(3.0));
    CHECK(points[2].at[1].value() == doctest::Approx(3.0));
    CHECK(Solution(document).curve_errors().empty());
}

TEST_CASE("Erasing takes with a part what refers to it, and what refers to others goes on")
{
    Document document = plate();
    set_support(document, CurveId(3U), PlaneSupportKind::Fixed);
    add_load(document, 0, {CurveId(0U)}, femoop::plane::CurveLoadKind::Traction);
    add_load(document, 0, {CurveId(2U)}, femoop::plane::CurveLoadKind::Pressure);
    set_force(document, 0, NodeId(2U), femoop::Dof::uy, femoop::Quantity(-8.0));
    set_force(document, 0, NodeId(1U), femoop::Dof::ux, femoop::Quantity(3.0));
    erase_parts(document, std::vector<Part>{NodeId(1U)}); // with both lines that end there
    const PlaneModel& model = document.model;
    REQUIRE(model.curves.size() == 2);
    CHECK(model.curves[1].support.value().kind == PlaneSupportKind::Fixed);
    REQUIRE(model.load_cases[0].curves.size() == 1);
    CHECK(model[model.load_cases[0].curves[0].curves[0]].id == "C3");
    REQUIRE(model.load_cases[0].points.size() == 1);
    CHECK(model[model.load_cases[0].points[0].node].id == "C");
    CHECK(model.points.size() == 3);
}

TEST_CASE("A polyline goes on without an erased point, an arc without a point at its centre")
{
    Document document = new_document();
    draw_curve(document, {.places = {{{0, 0}}, {{7, 1}}, {{9, 8}}}});
    draw_curve(document, {.kind = DrawnKind::Circle, .center = DraftPlace{{30, 40}}, .radius = 5.0});
    erase_parts(document, std::vector<Part>{NodeId(1U), NodeId(3U)});
    REQUIRE(document.model.curves.size() == 2);
    CHECK(document.model.curves[0].shape.value().places.size() == 2);
    CHECK(document.model.curves[1].shape.value().center.value().at[1] == doctest::Approx(40.0));
}

TEST_CASE("The narrowest gap of an outline is found, and closing it makes a face")
{
    Document document = new_document();
    line(document, {0, 0}, {70, 0});
    line(document, {70, 0}, {70, 30});
    draw_curve(document, {.places = {{{70, 30}}, {{0, 30}}, {{0.3, 0.4}}}});
    const Drawing open(document.model);
    CHECK(open.faces().empty());
    const auto gap = narrowest_gap(open);
    REQUIRE(gap);
    CHECK(gap->width == doctest::Approx(0.5));
    close_gap(document, *gap);
    const Drawing closed(document.model);
    CHECK(closed.faces().size() == 1);
    CHECK_FALSE(narrowest_gap(closed));
    CHECK(document.model.points.size() == 4);
}

TEST_CASE("An outline whose whole side is missing is open there, however wide, and other curves far off are no gap")
{
    Document document = new_document();
    draw_curve(document, {.places = {{{0, 0}}, {{70, 0}}, {{70, 30}}, {{0, 31}}}});
    line(document, {100, 0}, {120, 10});
    const auto gap = narrowest_gap(Drawing(document.model));
    REQUIRE(gap);
    CHECK(gap->width == doctest::Approx(31.0));
    close_gap(document, *gap);
    const Drawing closed(document.model);
    REQUIRE(closed.faces().size() == 1);
    CHECK(closed.faces()[0].area == doctest::Approx(0.5 * 70.0 * (30.0 + 31.0))); // nothing moved: a line was drawn
}

TEST_CASE("A point on a side is a corner of it: dragged, the line bends, and goes back where the point is erased")
{
    Document document = plate(); // 70 by 30
    const double whole = Drawing(document.model).faces()[0].area;
    const std::size_t load = add_load(document, 0, {CurveId(2U)}, femoop::plane::CurveLoadKind::Pressure);
    const NodeId corner = corner_at(document, {{31, 30}});
    CHECK(document.model.curves.size() == 4);
    REQUIRE(document.model.curves[2].shape.value().places.size() == 3);
    CHECK(Drawing(document.model).faces()[0].area == doctest::Approx(whole));
    move_point(document, corner, {31, 38});
    CHECK(Drawing(document.model).faces()[0].area == doctest::Approx(whole + 0.5 * 70.0 * 8.0));
    CHECK(document.model.load_cases[0].curves[load].curves.front() == CurveId(2U));
    const std::array gone{Part(corner)};
    erase_parts(document, gone);
    CHECK(document.model.curves[2].shape.value().places.size() == 2);
    CHECK(Drawing(document.model).faces()[0].area == doctest::Approx(whole));
}

TEST_CASE("A closed line gets a corner in its last side too, and both halves of a side the division that it had")
{
    Document document = new_document();
    const CurveId line = draw_curve(document, {.places = {{{0, 0}}, {{70, 0}}, {{35, 60}}}, .is_closed = true});
    auto& shape = document.model.curves[line.index].shape.value();
    shape.divide = {{.n = 3}, {.n = 5}, {.n = 7}};
    shape.is_divided_by_piece = true;
    const NodeId corner = corner_at(document, {{17.5, 30}});
    REQUIRE(shape.places.size() == 4);
    CHECK(shape.places[3].point == corner);
    REQUIRE(shape.divide.size() == 4);
    CHECK(shape.divide[3].n == 7);
    CHECK(corner_at(document, {{17.5, 30}}) == corner); // once is enough
    CHECK(shape.places.size() == 4);
}

TEST_CASE("A point on a circle is no corner, and one beside a side is none either")
{
    Document document = plate();
    corner_at(document, {{31, 30.5}});
    CHECK(document.model.curves[2].shape.value().places.size() == 2);
    const CurveId circle = draw_curve(document,
                                      {.kind = DrawnKind::Circle, .center = DraftPlace{{20, 15}}, .radius = 5.0});
    corner_at(document, {{25, 15}});
    CHECK(document.model.curves[circle.index].shape.value().places.empty());
}

TEST_CASE("A line that stands alone leaves no gap")
{
    Document document = new_document();
    line(document, {0, 0}, {70, 0});
    CHECK_FALSE(narrowest_gap(Drawing(document.model)));
}

TEST_CASE("Several forces of one case on a point count as their sum, and a new one takes the place of all")
{
    Document document = plate();
    some_case(document, 0);
    auto& loads = document.model.load_cases[0].points;
    loads.push_back({NodeId(2U), {{femoop::Dof::ux, femoop::Quantity(3.0, "3 N")}}});
    CHECK(force_on(document.model, 0, NodeId(2U), femoop::Dof::ux)->text() == "3 N");
    loads.push_back({NodeId(1U), {{femoop::Dof::ux, 50.0}}});
    loads.push_back({NodeId(2U), {{femoop::Dof::ux, 4.5}, {femoop::Dof::uy, -2.0}}});
    CHECK(*force_on(document.model, 0, NodeId(2U), femoop::Dof::ux) == 7.5);
    CHECK(*force_on(document.model, 0, NodeId(2U), femoop::Dof::uy) == -2.0);
    set_force(document, 0, NodeId(2U), femoop::Dof::ux, femoop::Quantity(6.0));
    CHECK(*force_on(document.model, 0, NodeId(2U), femoop::Dof::ux) == 6.0);
    CHECK(*force_on(document.model, 0, NodeId(2U), femoop::Dof::uy) == -2.0);
    std::ptrdiff_t n_along_x = 0;
    for (const femoop::NodeLoad& load : document.model.load_cases[0].points)
        if (load.node == NodeId(2U))
            n_along_x += std::ranges::count(load.components, femoop::Dof::ux, &femoop::Component::dof);
    CHECK(n_along_x == 1);
}

TEST_CASE("A load that several curves share becomes a curve's own where it is changed there")
{
    Document document = plate();
    const std::size_t load = add_load(document, 0, {CurveId(0U)}, femoop::plane::CurveLoadKind::Traction);
    document.model.load_cases[0].curves[load].curves.push_back(CurveId(2U));
    own_load(document, 0, 0, CurveId(2U)).qy = femoop::plane::Field{femoop::Quantity(-4.0)};
    CHECK(loads_on(document.model, 0, CurveId(2U)).size() == 1);
    CHECK(loads_on(document.model, 0, CurveId(0U)).size() == 1);
    const auto& loads = document.model.load_cases[0].curves;
    REQUIRE(loads.size() == 2);
    CHECK(std::get<femoop::Quantity>(loads[loads_on(document.model, 0, CurveId(0U))[0]].qy.value().form) == 0.0);
    erase_load(document, 0, 0, CurveId(2U));
    CHECK(document.model.load_cases[0].curves.size() == 1);
}

TEST_CASE(
    "What several curves have in common is one number: given to one it is given to all, loads that they share too")
{
    Document document = plate();
    const std::vector<CurveId> curves{CurveId(0U), CurveId(1U), CurveId(2U)};
    add_load(document, 0, {curves[2]}, femoop::plane::CurveLoadKind::Pressure);
    add_load(document, 0, curves, femoop::plane::CurveLoadKind::Traction);
    own_load(document, 0, 0, curves[0]).qx = femoop::plane::Field{femoop::Quantity(5.0)};
    const auto common = [&](const char* id) {
        std::vector<std::vector<Number>> each;
        const std::vector<LoadPlaces> loads = loads_of_all(document.model, 0, curves);
        REQUIRE(loads.size() == 1); // whichever it is of the curve's own
        for (std::size_t i = 0; i < curves.size(); ++i)
            each.push_back(numbers(document.model, 0, loads[0][i], curves[i]));
        const auto all = numbers_of_all(each);
        const auto it = std::ranges::find(all, id, &Number::id);
        REQUIRE(it != all.end());
        return *it;
    };
    CHECK(common("qx").differs);
    CHECK_FALSE(common("qx").value);
    CHECK(common("qy").value.value() == 0.0);
    common("qx").set(document, femoop::Quantity(-8.0));
    CHECK_FALSE(common("qx").differs);
    CHECK(numbers(document.model, 0, 0, curves[0]).front().value.value() == -8.0);
    CHECK(numbers(document.model, 0, 0, curves[1]).front().value.value() == -8.0);
    CHECK(numbers(document.model, 0, 1, curves[2]).front().value.value() == -8.0);
    CHECK(numbers(document.model, 0, 0, curves[2]).front().value.value() == 0.0); // its other load stays
}

TEST_CASE("A number that some of several parts lack is not theirs in common, and a refusal of one is that of all")
{
    Document document = plate();
    set_division(document, CurveId(0U), femoop::plane::Division{4, {}});
    const auto common = [&] {
        return numbers_of_all({numbers(document.model, CurveId(0U), 0), numbers(document.model, CurveId(1U), 0)});
    };
    const auto ratio = common()[1];
    REQUIRE(ratio.id == "ratio");
    CHECK(ratio.set(document, femoop::Quantity(2.0))); // the other one has no divisions yet
    set_support(document, CurveId(0U), PlaneSupportKind::Custom);
    CHECK(numbers(document.model, CurveId(0U), 0).size() > common().size());
    CHECK(common().size() == 2);
}

TEST_CASE("A load of all regions becomes a region's own where it is changed there, and stays with the others")
{
    Document document = plate();
    outline(document, {{70, 0}, {110, 0}, {110, 30}, {70, 30}});
    make_region(document, {90, 12});
    const RegionId first(0U), second(document.model.regions.size() - 1);
    REQUIRE(first != second);
    const std::size_t load = add_load(document, 0, {first}, RegionLoadKind::Temperature);
    document.model.load_cases[0].regions[load].regions.clear(); // of all
    CHECK(loads_on(document.model, 0, second).size() == 1);
    numbers(document.model, 0, 0, second).front().set(document, femoop::Quantity(25.0));
    const auto& loads = document.model.load_cases[0].regions;
    const auto rise_of = [&](RegionId region) {
        REQUIRE(loads_on(document.model, 0, region).size() == 1);
        return numbers(document.model, 0, 0, region).front().value.value().value();
    };
    CHECK(rise_of(second) == 25.0);
    CHECK(rise_of(first) == 0.0);
    erase_load(document, 0, 0, second);
    CHECK(loads.size() == 1);
    CHECK(loads_on(document.model, 0, second).empty());
}

TEST_CASE(
    "A settlement that curves share becomes a curve's own where it is changed there, and goes where nothing is left")
{
    Document document = plate();
    const CurveId below(0U), beside(3U);
    for (const CurveId curve : {below, beside}) set_support(document, curve, PlaneSupportKind::Fixed);
    document.model.load_cases.resize(1);
    auto& settlements = document.model.load_cases[0].settlements;
    const femoop::plane::Field down{femoop::Quantity(-3.0)};
    settlements.push_back({.point = {}, .curves = {below, beside}, .ux = {}, .uy = down});
    const auto give = [&](CurveId curve, std::string_view name, const std::optional<femoop::Quantity>& value) {
        for (const Number& number : numbers(document.model, curve, 0))
            if (number.id == name) number.set(document, value);
    };
    give(beside, "settlement uy", femoop::Quantity(-5.0));
    CHECK(settlements.size() == 2);
    CHECK((settlement_of(document.model, 0, below, femoop::Dof::uy) == down));
    give(beside, "settlement ux", femoop::Quantity(2.0));
    give(beside, "settlement uy", std::nullopt);
    CHECK_FALSE(settlement_of(document.model, 0, beside, femoop::Dof::uy));
    CHECK(settlement_of(document.model, 0, beside, femoop::Dof::ux));
    give(beside, "settlement ux", std::nullopt);
    CHECK(settlements.size() == 1);
}

TEST_CASE("A support settles in the directions that it holds, and no other is offered")
{
    Document document = plate();
    const auto ids = [&] {
        std::string all;
        for (const Number& number : numbers(document.model, NodeId(0U), 0))
            if (number.id.starts_with("settlement")) all += number.id + ".";
        return all;
    };
    CHECK(ids().empty());
    set_support(document, NodeId(0U), PlaneSupportKind::Roller);
    CHECK(ids() == "settlement uy.");
    set_support(document, NodeId(0U), PlaneSupportKind::Custom);
    set_hold(document.model.points[0].support.value(), femoop::Dof::uy, Hold::Free);
    set_spring(document.model.points[0].support.value(), femoop::Dof::ux, femoop::Quantity(40.0));
    CHECK(ids() == "settlement ux.");
}

TEST_CASE("A field is read as it is written, and refused where it is none")
{
    using namespace femoop::plane;
    const femoop::Units units{};
    for (const char* text : {"5", "\"5 kN/m^2\"", "[1.5, 3]", R"({"polynomial": [[2, 1, 0], [-3, 0, 2]]})",
                             R"({"along": "y", "table": [[0, 4], [7, 9]]})",
                             R"({"along": "r", "about": [3, 8], "table": [[2, 4], [7, 9]]})"}) {
        CAPTURE(text);
        const auto read = read_field(text, femoop::dimension::stress, units);
        REQUIRE(std::holds_alternative<Field>(read));
        CHECK(field_text(std::get<Field>(read)) == text);
    }
    for (const char* text :
         {"2x + 3y", "[1]", "{}", R"({"polynomial": [[2, 1]]})", R"({"polynomial": []})", R"(["5 m", 1])",
          R"({"along": "y", "table": [[7, 4], [0, 9]]})", R"({"along": "z", "table": [[0, 4]]})"}) {
        CAPTURE(text);
        const auto read = read_field(text, femoop::dimension::stress, units);
        REQUIRE(std::holds_alternative<std::vector<femoop::Fault>>(read));
        CHECK_FALSE(std::get<std::vector<femoop::Fault>>(read).empty());
    }
}

TEST_CASE("A load that varies otherwise is told by its form, and a number takes its place")
{
    using femoop::plane::Field;
    Document document = plate();
    const CurveId curve(0U);
    add_load(document, 0, {curve}, femoop::plane::CurveLoadKind::Traction);
    const auto qx = [&] { return numbers(document.model, 0, 0, curve).front(); };
    CHECK(numbers(document.model, 0, 0, curve).size() == 4); // each of two at both ends
    const Field slope{Field::Polynomial{{femoop::Quantity(2.0), 1, 0}, {femoop::Quantity(-3.0), 0, 2}}};
    qx().set_field(document, slope);
    REQUIRE(qx().field);
    CHECK((*qx().field == slope));
    CHECK(ui::Catalogue()(form_of(*qx().field)) == "polynomial, terms: 2");
    CHECK(numbers(document.model, 0, 0, curve).size() == 3);
    qx().set(document, femoop::Quantity(4.0));
    CHECK_FALSE(qx().field);
    CHECK(qx().value.value().value() == 4.0);
}

TEST_CASE("A body force, a rise of temperature and a rotation are written and read back as they were given")
{
    using Named = std::pair<const char*, double>;
    Document document = plate();
    for (const auto kind : {RegionLoadKind::Body, RegionLoadKind::Temperature, RegionLoadKind::Rotation})
        add_load(document, 0, {RegionId(0U)}, kind);
    const std::size_t last = 2;
    for (const auto& [name, value] : {Named{"omega", 30.0}, Named{"about x", 4.0}, Named{"about y", -7.0}})
        for (const Number& number : numbers(document.model, 0, last, RegionId(0U)))
            if (number.id == name) number.set(document, femoop::Quantity(value));
    const auto& given = std::get<femoop::plane::SteadyRotation>(document.model.load_cases[0].regions[last].load);
    CHECK(given.omega.value() == 30.0);
    REQUIRE(given.about.size() == 2);
    CHECK(given.about[1].value() == -7.0);
    const auto read = femoop::plane::examine_plane_model(femoop::plane::write_plane_model(document.model));
    CHECK((read.model == document.model));
}

TEST_CASE("A support of the object form begins with what the keyword blocked")
{
    Document document = plate();
    set_support(document, CurveId(0U), PlaneSupportKind::Symmetry);
    set_support(document, CurveId(0U), PlaneSupportKind::Custom);
    PlaneSupport& support = document.model.curves[0].support.value();
    CHECK(support.is_local);
    CHECK(support.fixed == femoop::DofSet{femoop::Dof::uy});
    set_spring(support, femoop::Dof::uy, femoop::Quantity(40.0));
    CHECK(support.fixed.is_empty());
    CHECK(support.springs.size() == 1);
    set_hold(support, femoop::Dof::uy, Hold::Blocked);
    CHECK(support.springs.empty());
}

namespace {

/// "C = 1.5 A + 1 1": a combination, each term with its factor.
std::string terms(const PlaneModel& model, std::size_t combination)
{
    std::string text = model.combinations.at(combination).id;
    for (const auto& term : model.combinations[combination].terms)
        text += (text.find('=') == std::string::npos ? " = " : " + ") + ui::number_text(term.factor) + " " +
                model.case_name(term.of);
    return text;
}

const Number& number_named(const std::vector<Number>& all, std::string_view id)
{
    return *std::ranges::find(all, id, &Number::id);
}

} // namespace

TEST_CASE("Combinations keep their terms when load cases come and go, and share their names with them")
{
    Document document = plate();
    rename(document, add_load_case(document), "A");
    const femoop::CaseId combined = add_combination(document), of_combined = add_combination(document);
    rename(document, of_combined, "D");
    PlaneModel& model = document.model;
    model.combinations[1].terms = {{combined, 2.0}};
    model.expected.push_back({.load_case = combined, .point = NodeId(0U)});
    CHECK(terms(model, 0) == "C = 1 A");

    CHECK(model.case_name(add_load_case(document)) == "1");
    CHECK(terms(model, 0) == "C = 1 A");
    CHECK(terms(model, 1) == "D = 2 C");
    CHECK(model.case_name(*model.expected[0].load_case) == "C");

    const femoop::CaseId c = *model.find_case("C"), d = *model.find_case("D");
    const std::vector<Number> factors = numbers(model, c);
    CHECK_FALSE(number_named(factors, "factor 1").value);
    CHECK_FALSE(number_named(factors, "factor 1").set(document, femoop::Quantity(1.5)));
    CHECK_FALSE(number_named(factors, "factor A").set(document, std::nullopt));
    CHECK(terms(model, 0) == "C = 1.5 1");
    CHECK(number_named(numbers(model, d), "factor C").value == femoop::Quantity(2.0));

    CHECK(why_not_named(model, c, "A").has_value());
    CHECK(why_not_named(model, *model.find_case("A"), "D").has_value());
    CHECK_FALSE(why_not_named(model, c, "C").has_value());
    CHECK_FALSE(why_not_named(model, c, "ULS").has_value());

    erase_case(document, *model.find_case("A"));
    CHECK(terms(model, 0) == "C = 1.5 1");
    CHECK(terms(model, 1) == "D = 2 C");
    erase_case(document, *model.find_case("C"));
    CHECK(model.expected.empty());
    CHECK(terms(model, 0) == "D");
    CHECK(model.n_cases() == 2);
}

TEST_CASE("A fault is told with what is to be done in the window, not with keys of the file")
{
    Document document = plate();
    const auto told = [&document](femoop::FaultKind kind, std::vector<std::string> arguments) {
        return sentence({.kind = kind, .arguments = std::move(arguments)}, document.model, ui::Catalogue());
    };
    CHECK(told(femoop::FaultKind::NothingToMesh, {}).ends_with("close an outline, and click its face"));
    CHECK(told(femoop::FaultKind::RegionWithoutThickness, {"regions[0] \"R1\""}) ==
          "Region R1: has no thickness, which a plane stress needs; select a face of it and type one");
    CHECK(told(femoop::FaultKind::RegionWithoutDensity, {"load_cases[0] \"1\"", "steel", "R1"}).find("density\"") ==
          std::string::npos);
}

TEST_CASE("What is drawn and given is written and read back the same")
{
    Document document = plate();
    document.model.title = "A plate";
    draw_curve(document,
               {.kind = DrawnKind::Ellipse, .center = DraftPlace{{40, 15}}, .a = 9.0, .b = 4.0, .angle = 20.0});
    set_hole(document, Drawing(document.model), 1, true);
    set_support(document, CurveId(3U), PlaneSupportKind::Fixed);
    set_division(document, CurveId(0U), femoop::plane::Division{16, femoop::Quantity(8.0)});
    add_load(document, 0, {CurveId(1U)}, femoop::plane::CurveLoadKind::Traction);
    const auto read = femoop::plane::examine_plane_model(femoop::plane::write_plane_model(document.model));
    CHECK(read.is_sound());
    CHECK((read.model == document.model));
}

TEST_CASE("Where loads or materials are wrong the faces are seen all the same")
{
    Document document = plate();
    document.model.materials[0].E = femoop::Quantity(-1.0);
    const Solution solution(document);
    CHECK_FALSE(solution.is_sound());
    REQUIRE(solution.drawing() != nullptr);
    CHECK(solution.drawing()->faces().size() == 1);
    CHECK(solution.curve_errors().empty());
}

TEST_CASE("A plate that is pulled is held back by the traction times its face, and a free one has no results")
{
    Document document = plate(); // 70 by 30, 10 mm thick
    set_support(document, CurveId(3U), PlaneSupportKind::Symmetry);
    set_support(document, NodeId(0U), PlaneSupportKind::Fixed);
    const std::size_t load = add_load(document, 0, {CurveId(1U)}, femoop::plane::CurveLoadKind::Traction);
    document.model.load_cases[0].curves[load].qx = femoop::plane::Field{femoop::Quantity(7.0)};
    const auto never = [] { return false; };
    const Analysed pulled(std::make_shared<const Solution>(document), never);
    CHECK(pulled.faults().empty());
    REQUIRE(pulled.result(0) != nullptr);
    CHECK(pulled.result(0)->equilibrium().sum_reactions[0] == doctest::Approx(-7.0 * 30.0 * 10.0));
    set_support(document, CurveId(3U), std::nullopt);
    set_support(document, NodeId(0U), std::nullopt);
    const Analysed free(std::make_shared<const Solution>(document), never);
    CHECK(free.mesh() != nullptr);
    CHECK(free.results() == nullptr);
    CHECK_FALSE(free.faults().empty());
}
