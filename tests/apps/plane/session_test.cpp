// What a hand draws, and the session that it draws in, without a screen.
#include "apps/plane/document/attributes.h"
#include "apps/plane/document/gallery/gallery.h"
#include "apps/plane/document/load_cases.h"
#include "apps/plane/document/points.h"
#include "apps/plane/session/commands.h"
#include "apps/plane/session/drawing_commands.h"
#include "apps/plane/session/part_commands.h"
#include "apps/plane/tools/snap.h"
#include "tests/apps/recovered.h"
#include "tests/folder.h"
#include "tests/source_folder.h"

#include <doctest/doctest.h>

#include <string>

using namespace plane;
using femoop::plane::DrawnKind;

namespace {

Aim aim_at(FlatPoint place, bool adds = false)
{
    return {.pointer = place, .snap = {place, SnapKind::Free, {}}, .under = {}, .pixel = 0.1, .adds = adds};
}

Workspace quarter_plate() { return Workspace(Session(gallery_document(0))); }

} // namespace

TEST_CASE("Lines go on from the last place, and end where the first one began")
{
    CurveTool tool(CurveToolKind::Line);
    CHECK_FALSE(tool.add({{0, 0}}));
    CHECK(tool.add({{7, 1}}));
    CHECK(tool.from() == FlatPoint{7, 1});
    CHECK(tool.add({{5, 6}}));
    CHECK(tool.add({{0, 0}}));
    CHECK_FALSE(tool.has_begun());
}

TEST_CASE("A polyline is closed by its first place and ended by its last")
{
    CurveTool closed(CurveToolKind::Polyline);
    for (const FlatPoint& p : {FlatPoint{0, 0}, {7, 1}, {5, 6}}) CHECK_FALSE(closed.add({p}));
    const auto outline = closed.add({{0, 0}});
    REQUIRE(outline);
    CHECK(outline->is_closed);
    CHECK(outline->places.size() == 3);
    CurveTool open(CurveToolKind::Polyline);
    for (const FlatPoint& p : {FlatPoint{0, 0}, {7, 1}}) CHECK_FALSE(open.add({p}));
    const auto line = open.add({{7, 1}});
    REQUIRE(line);
    CHECK_FALSE(line->is_closed);
}

TEST_CASE("An arc about a centre takes the short way, with Shift the long one, and the radius of its start")
{
    for (const bool is_long : {false, true}) {
        CurveTool tool(CurveToolKind::ArcCenter);
        tool.add({{2, 1}});
        tool.add({{7, 1}});
        const auto arc = tool.add({{2, 9}}, is_long);
        REQUIRE(arc);
        CHECK(arc->is_clockwise == is_long);
        CHECK(arc->places[1].at.y == doctest::Approx(6.0));
    }
}

TEST_CASE("What is begun of a curve is seen wherever the pointer is")
{
    CurveTool tool(CurveToolKind::Spline);
    CHECK_FALSE(tool.begun());
    tool.add({{150, 0}});
    tool.add({{160, 10}});
    CHECK(tool.begun()->kind == femoop::plane::DrawnKind::Line);
    CHECK(tool.begun()->places.size() == 2);
    tool.add({{190, -7}});
    CHECK(tool.begun()->kind == femoop::plane::DrawnKind::Spline);
    CHECK(tool.begun()->places.size() == 3);
}

TEST_CASE("Undo takes back the last place of a curve that is begun, then steps of the drawing")
{
    Workspace workspace{Session()};
    const CommandTable table = command_table();
    const auto undo = [&] { table.find("edit.undo")->run(workspace); };
    workspace.draw(CurveDraft{.kind = DrawnKind::Line, .places = {{{0, 0}}, {{4, 1}}}});
    workspace.hand.select(ToolKind::Spline);
    type_place(workspace, {12, 5});
    type_place(workspace, {17, 3});
    CHECK(ui::why_not(*table.find("draw.finish"), workspace));
    undo();
    CHECK(workspace.hand.curve_tool()->places().size() == 1);
    undo();
    CHECK_FALSE(workspace.hand.has_begun());
    CHECK(workspace.session.model().curves.size() == 1);
    undo();
    CHECK(workspace.session.model().curves.empty());
}

TEST_CASE("Places of the grid and lengths between them are as short as they are drawn")
{
    const Session session(gallery_document(0));
    const SnapOptions options{.reach = 1.0, .grid = 0.2, .fine = 0.1};
    const auto at = [&](FlatPoint p) { return snap(session.model(), session.drawing(), p, options).place; };
    CHECK(at({87.63, -53.41}) == FlatPoint{87.6, -53.4});
    CurveTool circle(CurveToolKind::Circle);
    circle.add({{65.3, 31}});
    CHECK(circle.add({{65.3 + 9.7, 31}})->radius == 9.7);
    CurveTool ellipse(CurveToolKind::Ellipse);
    ellipse.add({{65.3, 31}});
    ellipse.add({{65.3 + 9.7, 31}});
    const auto drawn = ellipse.add({{65.3, 31 + 4.1}});
    CHECK(drawn->a == 9.7);
    CHECK(drawn->b == 4.1);
}

TEST_CASE("A place is drawn to a point before a curve, to a curve before the grid, and to nothing with Alt")
{
    const Session session(gallery_document(0));
    SnapOptions options{.reach = 1.0, .grid = 5.0, .fine = 0.1};
    const auto at = [&](FlatPoint p) { return snap(session.model(), session.drawing(), p, options); };
    CHECK(at({10.4, 0.3}).kind == SnapKind::Point);
    CHECK(at({25.2, 11.3}).kind == SnapKind::OnCurve);
    CHECK(at({25.2, 25.4}).kind == SnapKind::Middle);
    CHECK(at({24.6, 0.4}).kind == SnapKind::Crossing);
    CHECK(at({35.3, 14.8}).place == FlatPoint{35, 15});
    CHECK(at({37.13, 17.02}).place.x == doctest::Approx(37.1));
    options.is_off = true;
    CHECK(at({10.4, 0.3}).place == FlatPoint{10.4, 0.3});
}

TEST_CASE("What is typed while a curve is drawn counts from its last place")
{
    Workspace workspace{Session()};
    workspace.hand.select(ToolKind::Line);
    const auto typed = [&](const std::string& text) {
        workspace.hand.type(text);
        const auto place = workspace.hand.typed_place(workspace.session.model().units, workspace.session.units());
        workspace.hand.forget_typed();
        return place;
    };
    CHECK(typed("12, 5") == FlatPoint{12, 5});
    CHECK_FALSE(typed("@3, 4"));
    type_place(workspace, {12, 5});
    CHECK(typed("@3 cm, 4") == FlatPoint{42, 9});
    CHECK(typed("20<90") == FlatPoint{12, 25});
    workspace.hand.point_at(aim_at({12, 90}));
    CHECK(typed("8") == FlatPoint{12, 13});
}

TEST_CASE("A change that no drawing may have is refused and changes nothing")
{
    Workspace workspace = quarter_plate();
    const Document before = workspace.session.document();
    CHECK(workspace.change({"test", [](Document& d) { d.model.regions[0].thickness = femoop::Quantity(-2.0); }}));
    CHECK(workspace.change({"test", [](Document& d) {
                                draw_curve(d, {.kind = DrawnKind::Arc, .places = {{{0, 60}}, {{9, 60}}, {{20, 60}}}});
                            }}));
    CHECK((workspace.session.document() == before));
    CHECK_FALSE(workspace.session.history().can_undo());
}

TEST_CASE("A drag is one step, whatever it passes, and regions follow it there and back")
{
    Workspace workspace = quarter_plate();
    Session& session = workspace.session;
    const Document before = session.document();
    for (const double x : {12.0, 30.0, 55.0, 15.0})
        session.change({"Move", [x](Document& d) { move_point(d, NodeId(1U), {x, 0}); }, Step::Drag});
    session.settle();
    CHECK(session.solution().is_sound());
    CHECK(session.drawing()->faces().size() == 3);
    session.undo();
    CHECK((session.document() == before));
}

TEST_CASE("Results are found where they are shown, and again when the drawing changes")
{
    Workspace workspace = quarter_plate();
    Session& session = workspace.session;
    session.analyse_what_is_shown();
    CHECK(session.analysed() == nullptr);
    session.look.field = femoop::plane::PlaneComponent::sx;
    session.analyse_what_is_shown();
    REQUIRE(session.analysed() != nullptr);
    CHECK(session.input().result != nullptr);
    CHECK_FALSE(session.why_no_results());
    session.change({"Move", [](Document& d) { move_point(d, NodeId(1U), {14, 0}); }});
    CHECK(session.analysed() == nullptr);
}

namespace {

/// A mesh that goes along with a hand is found beside one frame and shown from the next one on.
void show_two_frames(Session& session)
{
    session.analyse_what_is_shown();
    session.analyse_what_is_shown();
}

} // namespace

TEST_CASE("While a hand drags, elements stay as many as they were; when it lets go, the drawing is meshed anew")
{
    Workspace workspace = quarter_plate();
    Session& session = workspace.session;
    session.patience.of_a_hand = 1e3; // [s], however slow the machine is
    session.look.mesh = true;
    session.analyse_what_is_shown();
    REQUIRE(session.analysed() != nullptr);
    const std::size_t n = session.analysed()->mesh()->elements.size();
    for (const double x : {11.0, 13.0, 15.0}) {
        session.change({"Move", [x](Document& d) { move_point(d, NodeId(1U), {x, 0}); }, Step::Drag});
        session.analyse_what_is_shown();
        REQUIRE(session.analysed() != nullptr);
        const PlateInput shown = session.input(); // drawing and mesh of one moment, that of before
        CHECK(&shown.model == &session.analysed()->solution()->model());
        CHECK(shown.mesh == session.analysed()->mesh());
        CHECK(shown.model[NodeId(1U)].at[0].value() < x);
        session.analyse_what_is_shown();
        REQUIRE(session.analysed() != nullptr);
        CHECK(session.analysed()->solution().get() == &session.solution());
        CHECK(session.analysed()->is_following());
        CHECK(session.analysed()->mesh()->elements.size() == n);
    }
    session.settle();
    CHECK(session.analysed() == nullptr);
    session.analyse_what_is_shown();
    REQUIRE(session.analysed() != nullptr);
    CHECK_FALSE(session.analysed()->is_following());
}

TEST_CASE("What took too long to follow a hand waits until it lets go")
{
    Workspace workspace = quarter_plate();
    Session& session = workspace.session;
    session.patience = {.of_a_hand = 0.0, .behind_a_hand = 0.0};
    session.look.mesh = true;
    session.analyse_what_is_shown();
    const auto drag = [&](double x) {
        session.change({"Move", [x](Document& d) { move_point(d, NodeId(1U), {x, 0}); }, Step::Drag});
        show_two_frames(session);
    };
    drag(11.0);
    REQUIRE(session.analysed() != nullptr);
    CHECK(session.analysed()->is_following());
    drag(13.0);
    CHECK(session.analysed() == nullptr);
    session.settle();
    session.analyse_what_is_shown();
    REQUIRE(session.analysed() != nullptr);
    CHECK_FALSE(session.analysed()->is_following());
}

TEST_CASE("What is not found within a frame is found while others are drawn, until it is given up")
{
    Workspace workspace = quarter_plate();
    Session& session = workspace.session;
    session.look.mesh = true;
    session.patience.in_a_frame = 0.0;
    session.change({"Fine", [](Document& document) { document.model.mesh.size = femoop::Quantity(0.5); }});
    session.analyse_what_is_shown();
    if (session.run() == nullptr) return; // one core alone: it was waited for
    CHECK(session.analysed() == nullptr);
    CHECK(session.is_moving());
    session.give_up_analysis();
    CHECK(session.run() == nullptr);
    REQUIRE(session.why_no_results());
    CHECK(session.tr()(*session.why_no_results()) ==
          "meshing and solving took too long and were given up; give a larger element size");
    session.analyse_what_is_shown();
    CHECK(session.run() == nullptr);
    session.analyse_all_the_same();
    session.patience.in_a_frame = Patience().in_a_frame;
    session.analyse_what_is_shown();
    REQUIRE(session.analysed() != nullptr);
    CHECK(session.analysed()->mesh() != nullptr);
    CHECK_FALSE(session.is_moving());
}

TEST_CASE("More unknowns than are solved for within seconds are told, and solved for where one insists")
{
    Workspace workspace = quarter_plate();
    Session& session = workspace.session;
    session.look.mesh = true;
    session.patience.most_unknowns = 100;
    session.analyse_what_is_shown();
    REQUIRE(session.analysed() != nullptr);
    CHECK(session.analysed()->mesh() == nullptr);
    REQUIRE(session.was_left());
    const std::size_t n = *session.analysed()->n_unknowns_too_many();
    CHECK(session.tr()(*session.why_no_results()) ==
          "the mesh has " + std::to_string(n) +
              " unknowns, which take about 1 s, and its picture follows slowly; give a larger element size, or go on");
    session.analyse_all_the_same();
    session.analyse_what_is_shown();
    REQUIRE(session.analysed()->mesh() != nullptr);
    CHECK(2 * session.analysed()->mesh()->points.size() == n);
}

TEST_CASE("The drawing in words tells of each case what acts on what, with its values")
{
    Session session(gallery_document(1)); // the dam
    session.change({"A force on the crest", [](Document& document) {
                        add_combination(document);
                        set_force(document, 1, femoop::NodeId(3U), femoop::Dof::ux, femoop::Quantity(7.0));
                    }});
    const std::string words = description(session);
    CHECK(words.find("Load case weight\n  Factor of self-weight 1\n") != std::string::npos);
    CHECK(words.find("Load case water\n  D: Fx 7 kN\n  water: Pressure, p 0 kN/m² … 490.5 kN/m²\n") !=
          std::string::npos);
    CHECK(words.find("Combination C\n  Factor of weight 1, Factor of water 1\n") != std::string::npos);
}

TEST_CASE("What is selected goes on under another name")
{
    Workspace workspace = quarter_plate();
    Session& session = workspace.session;
    session.select(CurveId(1U));
    session.change({"Rename", [](Document& d) { d.model.curves[1].id = "pulled"; }});
    REQUIRE(session.selection().size() == 1);
    CHECK(ui::Catalogue()(title(session, session.selection().front())) == "Curve pulled");
}

TEST_CASE("A click in a face without a region gives it one, which undo takes back")
{
    Workspace workspace = quarter_plate();
    workspace.change({"Add", [](Document& d) {
                          draw_curve(d, {.kind = DrawnKind::Circle, .center = DraftPlace{{80, 20}}, .radius = 6.0});
                      }});
    click_part(workspace, FacePlace{{81, 21}}, false);
    CHECK(workspace.session.model().regions.size() == 4);
    CHECK(workspace.session.selected_region() == RegionId(3U));
    workspace.session.undo();
    CHECK(workspace.session.model().regions.size() == 3);
}

TEST_CASE("A structure of members is told to be one, and nothing else")
{
    Session session;
    CHECK_FALSE(session.open(source_folder() + "/examples/portal.json"));
    REQUIRE(session.notice);
    CHECK(session.tr()(session.notice->sentence).ends_with("it holds a structure of members; the frame app opens it"));
    CHECK(session.open(source_folder() + "/examples/hole.json"));
    CHECK_FALSE(session.notice);
}

TEST_CASE("What a crash has cost is recovered")
{
    const Folder folder;
    Workspace workspace = quarter_plate();
    REQUIRE(workspace.session.save(folder.path("lesson.json")));
    workspace.change({"Move", [](Document& d) { move_point(d, NodeId(1U), {14, 0}); }});
    const Workspace next = recovered(workspace, folder, ".json");
    CHECK((next.session.document() == workspace.session.document()));
}

TEST_CASE("Probes and cuts are no part of the document, and another document has none of them")
{
    Session session;
    session.look.readings.add_probe({3.0, 4.0});
    session.look.readings.add_cut({0.0, 0.0}, {0.0, 7.0});
    CHECK_FALSE(session.is_dirty());
    CHECK(session.options().probes.size() == 1);
    CHECK(session.options().circle == std::size_t{0});
    session.new_document();
    CHECK(session.look.readings.are_none());
}

TEST_CASE("The nearest probe or end of a cut is taken hold of, and an end takes its cut along where it goes")
{
    using Kind = ReadingPart::Kind;
    Readings readings;
    readings.add_probe({3.0, 4.0});
    readings.add_cut({0.0, 0.0}, {0.0, 7.0});
    CHECK(readings.at({0.2, 6.7}, 1.0) == ReadingPart{Kind::CutEnd, 0});
    CHECK_FALSE(readings.at({30.0, 40.0}, 1.0));
    readings.move({Kind::CutEnd, 0}, {0.0, 0.0}); // onto the other end: it would be no cut
    CHECK(readings.place({Kind::CutEnd, 0}) == FlatPoint{0.0, 7.0});
    readings.remove({Kind::CutStart, 0});
    CHECK(readings.cuts.empty());
    CHECK(readings.told_probe() == std::size_t{0});
}

TEST_CASE("A mesh is refined step by step, its file stays as it was, and a change of the drawing gives it up")
{
    Workspace workspace = quarter_plate();
    Session& session = workspace.session;
    REQUIRE_FALSE(session.refine(2));
    for (int i = 0; i < 20; ++i) {
        session.tick(0.1);
        session.analyse_what_is_shown();
    }
    CHECK_FALSE(session.is_refining());
    REQUIRE(session.cycle() != nullptr);
    CHECK(session.cycle()->meshes().size() == 3);
    CHECK_FALSE(session.is_dirty());
    REQUIRE(session.input().mesh != nullptr);
    CHECK(session.input().mesh->elements.size() == session.cycle()->meshes().back().n_elements);
    CHECK(session.history().n_states() == 3);
    session.undo();
    session.analyse_what_is_shown();
    CHECK(session.cycle()->meshes().size() == 2);
    CHECK(session.input().mesh->elements.size() == session.cycle()->meshes().back().n_elements);
    workspace.change({"thicker", [](Document& document) { document.model.regions[0].thickness = 7.0; }});
    CHECK(session.cycle() == nullptr);
    workspace.change({"mapped", [](Document& document) { document.model.mesh.method = "mapped"; }});
    CHECK(session.refine(1));
    CHECK_FALSE(session.is_refining());
}

TEST_CASE("Results that are kept are compared with those of another element, and drawn to one scale")
{
    Workspace workspace(Session(gallery_document(2)));
    Session& session = workspace.session;
    session.look.deformed = true;
    REQUIRE_FALSE(session.keep_results());
    CHECK_FALSE(session.input().is_compared()); // there is nothing else yet
    workspace.change({"T3", [](Document& document) { mesh_by(document, femoop::ShapeKind::T3); }});
    session.analyse_what_is_shown();
    const PlateInput input = session.input();
    REQUIRE(input.is_compared());
    const auto energy = [](const femoop::plane::PlaneCase& result) { return result.energy(); };
    CHECK(energy(*input.result) < energy(*input.kept_result)); // linear triangles are too stiff
    CHECK(input.kept_results->model().elements.front().kind == femoop::ShapeKind::Q8);
    session.forget_results();
    CHECK_FALSE(session.input().is_compared());
}

TEST_CASE("A mesh by another element keeps a map, and lets go of a method that does not make it")
{
    Document document = gallery_document(0);
    document.model.mesh.method = "mapped";
    document.model.regions[0].mesh.method = "delaunay";
    document.model.regions[0].mesh.element = femoop::ShapeKind::T3;
    document.model.regions[1].mesh.method = "quads";
    document.model.regions[1].mesh.formulation = femoop::plane::Formulation::Incompatible;
    mesh_by(document, femoop::ShapeKind::Q9);
    CHECK(document.model.mesh.method == "mapped");
    CHECK(document.model.mesh.element == femoop::ShapeKind::Q9);
    CHECK(document.model.regions[0].mesh.method.empty());
    CHECK_FALSE(document.model.regions[0].mesh.element);
    CHECK(document.model.regions[1].mesh.method == "quads");
    CHECK_FALSE(document.model.regions[1].mesh.formulation);
}

TEST_CASE("Sizes of a refined mesh that are kept at the points make a mesh that is fine where it was")
{
    Workspace workspace(Session(gallery_document(1)));
    Session& session = workspace.session;
    session.load_case = 1; // water
    REQUIRE_FALSE(session.refine(4));
    for (int i = 0; i < 40; ++i) {
        session.tick(0.1);
        session.analyse_what_is_shown();
    }
    REQUIRE(session.cycle() != nullptr);
    const auto sizes = session.document().sizes();
    const double before = session.cycle()->meshes().front().error;
    workspace.change({"keep", [&](Document& document) { keep_sizes(document, *sizes); }});
    CHECK(session.cycle() == nullptr);
    CHECK(session.is_dirty());
    for (const auto& point : session.model().points)
        CHECK(point.size->value() == doctest::Approx(sizes->at({point.at[0], point.at[1]})).epsilon(5e-3));
    session.analyse_what_is_shown();
    REQUIRE(session.input().result != nullptr);
    CHECK(session.input().result->error_estimate() < 0.5 * before);
}

TEST_CASE("An outline joins the drawing as one step and leaves the file alone; one that cannot be read changes nothing")
{
    const Folder folder;
    const std::string circle = "<svg><circle cx='100' cy='-20' r='5'/></svg>";
    const std::string sound = folder.write("hole.svg", circle), torn = folder.write("torn.dxf", "0\nSECTION\n");
    Workspace workspace = quarter_plate();
    Session& session = workspace.session;
    const PlaneModel before = session.model();
    CHECK_FALSE(workspace.open_at_once(torn));
    CHECK(session.model() == before);
    CHECK(session.tr()(session.notice->sentence).find("ends before its EOF") != std::string::npos);

    REQUIRE(workspace.open_at_once(sound));
    CHECK(session.model().curves.size() == before.curves.size() + 1);
    CHECK(session.model().points.size() == before.points.size() + 1);
    CHECK(session.tr()(session.notice->sentence) ==
          "Inserted: curves: 1; the file has no unit; its numbers are taken as mm");
    CHECK_FALSE(session.path());
    session.undo();
    CHECK(session.model() == before);
}

TEST_CASE("A point of an outline that lies where one is already is that one, and names that are taken are left alone")
{
    const Folder folder;
    const std::string file = folder.write("side.dxf",
                                          "0\nSECTION\n2\nENTITIES\n0\nLINE\n10\n10\n20\n0\n11\n50\n21\n-7\n"
                                          "0\nENDSEC\n0\nEOF\n");
    Workspace workspace = quarter_plate(); // whose point A is at 10, 0
    workspace.session.change({"name", [](Document& document) { document.model.points.back().id = "P1"; }});
    REQUIRE(workspace.session.insert_outline(file));
    const PlaneModel& model = workspace.session.model();
    const auto& line = *model.curves.back().shape;
    CHECK(model[*line.places[0].point].id == "A");
    CHECK(model[*line.places[1].point].id == "P2");
}

TEST_CASE("Where little is to move the shape of a mode rests at its largest displacement until it is animated")
{
    Workspace workspace = quarter_plate();
    Session& session = workspace.session;
    session.look.modes = true;
    session.tick(0.7);
    CHECK(session.phase() < 0.9);
    session.is_still = true;
    session.tick(0.7);
    CHECK(session.phase() == 1.0);
    session.is_animated = true;
    session.tick(0.7);
    CHECK(session.phase() < 0.9);
}
