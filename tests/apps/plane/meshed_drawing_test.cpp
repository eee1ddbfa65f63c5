#include "apps/plane/discretize/meshed_drawing.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <set>
#include <string>

#include "femoop/analysis/mechanism.h"
#include "femoop/io/any_model.h"
#include "femoop/io/plane/plane_file.h"
#include "femoop/io/plane/plane_verify.h"
#include "femoop/model/fault/errors_among.h"
#include "femoop/plane/analysis/plane_analysis.h"
#include "femoop/plane/check/plane_check.h"
#include "femoop/plane/mesh/mesh_quality.h"
#include "tests/source_folder.h"

using namespace femoop::plane;
using discretize::Drawing;
using discretize::MeshedDrawing;
using doctest::Approx;
using femoop::CaseId;
using femoop::Fault;
using femoop::FaultKind;
using femoop::NodeId;

namespace {

/// A drawing with its mesh; each needs the one before.
struct Meshed {
    explicit Meshed(PlaneReading read) : reading(std::move(read)), drawing(reading.model), mesh(drawing) {}
    explicit Meshed(const std::string& text) : Meshed(examine_plane_model(text)) {}

    const PlaneModel& model() const { return mesh.model(); }
    double area() const
    {
        double sum = 0.0;
        for (const RegionSize& size : region_sizes(model())) sum += size.area;
        return sum;
    }
    std::size_t n_along(std::size_t curve) const { return model().curves[curve].points.size() - 1; }

    PlaneReading reading;
    Drawing drawing;
    MeshedDrawing mesh;
};

/// A rectangle of 4 by 2 with a point at each corner, of which a case changes what it is about.
struct RectangleText {
    std::string mesh = R"({"element": "T6", "size": 0.5})";
    std::string bottom = "", right = "", top = "", left = R"(, "support": "fixed")";
    std::string points = "", curves = "",
                regions = R"({"id": "plate", "at": [0.1, 0.1], "material": "m", "thickness": 1})";
    std::string loads = R"("curves": [{"curve": "right", "kind": "traction", "qx": 3}])";

    std::string text() const
    {
        const auto side = [](const std::string& id, const std::string& ends, const std::string& more) {
            return R"({"id": ")" + id + R"(", "kind": "line", "points": [)" + ends + "]" + more + "}";
        };
        return R"({"cremona": 1, "analysis": "plane_stress", "units": {"length": "m", "force": "N"},
            "materials": [{"id": "m", "E": 300, "nu": 0.2}], "mesh": )" +
               mesh + R"(, "points": [{"id": "A", "at": [0, 0]}, {"id": "B", "at": [4, 0]}, {"id": "C", "at": [4, 2]},
            {"id": "D", "at": [0, 2]})" +
               points + R"(], "curves": [)" + side("bottom", R"("A", "B")", bottom) + ", " +
               side("right", R"("B", "C")", right) + ", " + side("top", R"("C", "D")", top) + ", " +
               side("left", R"("D", "A")", left) + curves + R"(], "regions": [)" + regions +
               R"(], "load_cases": [{"id": "P", )" + loads + "}]}";
    }
};

std::string circle_in(const std::string& more) ///< a hole of radius 0.5 in the middle of the rectangle
{
    return R"(, {"id": "hole", "kind": "circle", "center": [2, 1], "radius": 0.5)" + more + "}";
}
const std::string with_hole = R"({"id": "plate", "at": [0.1, 0.1], "material": "m", "thickness": 1},
                                 {"id": "empty", "at": [2, 1], "hole": true})";

std::string sentences_of(const std::string& text)
{
    PlaneReading reading = examine_plane_model(text);
    std::vector<Fault> faults = reading.faults;
    if (femoop::errors_among(faults).empty()) {
        const Drawing drawing(reading.model);
        faults = drawing.is_sound() ? MeshedDrawing(drawing).faults() : drawing.faults();
    }
    std::string sentences;
    for (const Fault& fault : faults) sentences += (sentences.empty() ? "" : "\n") + message(fault);
    return sentences;
}

struct BadMesh {
    FaultKind kind;
    std::string text;
};

std::vector<BadMesh> bad_meshes()
{
    const std::string two =
        R"({"id": "plate", "at": [0.1, 0.1], "material": "m", "thickness": 1, "mesh": {"element": "Q4"}},
                               {"id": "other", "at": [3.9, 0.1], "material": "m", "thickness": 1})";
    const std::string middle = R"(, {"id": "middle", "kind": "line", "points": [[2, 0], [2, 2]]})";
    return {
        {FaultKind::PointsAtOnePlace,
         RectangleText{
             .points = R"(, {"id": "E", "at": [0, 0], "support": "pin"}, {"id": "F", "at": [0, 0], "support": "pin"})"}
             .text()},
        {FaultKind::MinAngleRange, RectangleText{.mesh = R"({"min_angle": 34})"}.text()},
        {FaultKind::CornerCount, RectangleText{.mesh = R"({"corners": ["A", "B"]})"}.text()},
        {FaultKind::NothingToMesh, RectangleText{.left = "", .regions = "", .loads = R"("self_weight": 1)"}.text()},
        {FaultKind::MeshMethodOfElement, RectangleText{.mesh = R"({"method": "front", "element": "Q4"})"}.text()},
        {FaultKind::MeshMethodOfElement, RectangleText{.mesh = R"({"method": "delaunay", "element": "Q8"})"}.text()},
        {FaultKind::MappedInside,
         RectangleText{.mesh = R"({"method": "mapped"})", .curves = circle_in(""), .regions = with_hole}.text()},
        {FaultKind::MappedVertices,
         RectangleText{.mesh = R"({"method": "mapped"})", .points = R"(, {"id": "E", "at": [1, 0]})"}.text()},
        {FaultKind::MappedCornerOff,
         RectangleText{.mesh = R"({"method": "mapped", "corners": ["A", "B", "C", "E"]})",
                       .points = R"(, {"id": "E", "at": [5, 0]}, {"id": "F", "at": [1, 0]})"}
             .text()},
        {FaultKind::MappedCornerOrder,
         RectangleText{.mesh = R"({"method": "mapped", "corners": ["A", "C", "B", "D"]})"}.text()},
        {FaultKind::MappedSidesDiffer,
         RectangleText{.mesh = R"({"method": "mapped"})", .bottom = R"(, "divide": 3)", .top = R"(, "divide": 5)"}
             .text()},
        {FaultKind::TrilateralSidesDiffer,
         RectangleText{.mesh = R"({"method": "trilateral", "corners": ["A", "B", "C"]})",
                       .bottom = R"(, "divide": 3)",
                       .right = R"(, "divide": 5)"}
             .text()},
        {FaultKind::TrilateralOdd,
         RectangleText{.mesh = R"({"method": "trilateral", "corners": ["A", "B", "C"], "element": "Q8"})",
                       .bottom = R"(, "divide": 3)"}
             .text()},
        {FaultKind::MeshOrdersDiffer, RectangleText{.curves = middle, .regions = two}.text()},
        {FaultKind::MeshTooLarge, RectangleText{.mesh = R"({"size": 1e-4})"}.text()},
        {FaultKind::MeshTooLarge,
         RectangleText{.mesh = R"({"size": 1e-90})", .points = R"(, {"id": "E", "at": [1, 1], "size": 0.3})"}.text()},
        {FaultKind::MeshTooLarge,
         RectangleText{.mesh = R"({"method": "delaunay"})", .bottom = R"(, "divide": 1000000)"}.text()},
        {FaultKind::MeshEdgesCross,
         RectangleText{.mesh = R"({"element": "T3"})",
                       .curves = R"(, {"id": "hole", "kind": "circle", "center": [2, 1], "radius": 0.999, "divide": 3},
                                      {"id": "inner", "kind": "circle", "center": [2, 1], "radius": 0.9, "divide": 24})",
                       .regions = R"({"id": "empty", "at": [2, 1], "hole": true},
                                     {"id": "plate", "material": "m", "thickness": 1})"}
             .text()},
        {FaultKind::MeshElementTurned,
         RectangleText{
             .mesh = R"({"element": "T6", "size": 2})",
             .top = R"(, "divide": 1)",
             .curves =
                 R"(, {"id": "bulge", "kind": "bezier", "points": ["D", [1, -0.4], [3, -0.4], "C"], "divide": 1})",
             .regions = R"({"id": "plate", "at": [0.1, 0.1], "material": "m", "thickness": 1})"}
             .text()},
        {FaultKind::MeshAngleMissed,
         RectangleText{.mesh = R"({"element": "T3"})",
                       .curves = R"(, {"id": "near", "kind": "line", "points": [[0, 0.01], [4, 0.01]]})",
                       .regions = R"({"id": "plate", "material": "m", "thickness": 1, "mesh": {"method": "delaunay"}})"}
             .text()},
    };
}

} // namespace

TEST_CASE("The drawings of tests/cases/drawn, meshed as they ask for, come out as published")
{
    std::size_t n_passed = 0;
    for (const auto& entry : std::filesystem::directory_iterator(source_folder() + "/tests/cases/drawn")) {
        CAPTURE(entry.path().filename().string());
        const Meshed meshed(std::get<PlaneReading>(femoop::examine_any_file(entry.path())));
        REQUIRE(meshed.mesh.is_sound());
        const DrawnChecks drawn{.count_or_area = [&](const PlaneExpected& check) { return meshed.drawing.read(check); },
                                .of_mesh = &meshed.mesh.checks()};
        for (const femoop::CheckOutcome& outcome :
             verify(meshed.reading.model, {.results = analyse(meshed.model())}, drawn)) {
            CAPTURE(outcome.what);
            CHECK(outcome.verdict == femoop::Verdict::Passed);
            ++n_passed;
        }
    }
    CHECK(n_passed == 70);
}

TEST_CASE("A drawing's mesh in a file of its own solves to the same numbers")
{
    for (const char* const name : {"CO-003", "CO-009", "DM-001"}) {
        CAPTURE(name);
        const Meshed meshed(
            std::get<PlaneReading>(femoop::examine_any_file(source_folder() + "/tests/cases/drawn/" + name + ".json")));
        const PlaneReading again = examine_plane_model(write_plane_model(meshed.model()));
        REQUIRE(again.is_sound());
        CHECK(again.model == meshed.model());
        const auto here = verify(meshed.model(), {.results = analyse(meshed.model())}),
                   there = verify(again.model, {.results = analyse(again.model)});
        REQUIRE(here.size() == there.size());
        for (std::size_t i = 0; i < here.size(); ++i) CHECK(*here[i].result == Approx(*there[i].result).epsilon(1e-9));
    }
}

TEST_CASE("A piece has as many parts as its size asks for, as its division says, or as the side opposite has")
{
    const Meshed usual(RectangleText{}.text());
    CHECK(usual.n_along(0) == 8); // of 0.5 each
    CHECK(usual.n_along(1) == 4);
    CHECK(usual.mesh.reports()[0].method == "mapped");
    const Meshed divided(RectangleText{.bottom = R"(, "divide": {"n": 3, "ratio": 4})"}.text());
    CHECK(divided.n_along(0) == 3);
    CHECK(divided.n_along(2) == 3);
    // parts of 4 / 7, 8 / 7 and 16 / 7, and the same in the direction of the side opposite
    CHECK(divided.model()[divided.model().curves[0].points[1]].at[0].value() == Approx(4.0 / 7.0));
    CHECK(divided.model()[divided.model().curves[2].points[2]].at[0].value() == Approx(4.0 / 7.0));
    const Meshed uneven(RectangleText{.bottom = R"(, "divide": 3)", .top = R"(, "divide": 5)"}.text());
    CHECK(uneven.mesh.reports()[0].method == "delaunay");
    CHECK(uneven.n_along(2) == 5);
}

TEST_CASE("Divisions spread through mapped regions, from one to the next")
{
    const std::string three = R"({"id": "a", "at": [0.5, 1], "material": "m", "thickness": 1},
        {"id": "b", "at": [2, 1], "material": "m", "thickness": 1}, {"id": "c", "at": [3.5, 1], "material": "m", "thickness": 1})";
    const Meshed meshed(RectangleText{.mesh = R"({"element": "Q4"})",
                                      .left = R"(, "divide": 7, "support": "fixed")",
                                      .curves = R"(, {"id": "i", "kind": "line", "points": [[1, 0], [1, 2]]},
                                                     {"id": "j", "kind": "line", "points": [[3, 0], [3, 2]]})",
                                      .regions = three}
                            .text());
    for (const std::size_t curve : {1U, 3U, 4U, 5U}) CHECK(meshed.n_along(curve) == 7);
}

TEST_CASE("A region with four corners that no map fits is meshed freely, unless it asks for the map")
{
    const auto arrow = [](const std::string& method) { // a dart: its fourth corner lies inside the other three
        return R"({"cremona": 1, "analysis": "plane_stress", "units": {"length": "m", "force": "N"},
            "materials": [{"id": "m", "E": 300, "nu": 0.2}], "mesh": {"size": 0.5)" +
               method + R"(}, "curves": [{"id": "dart", "kind": "line", "closed": true,
            "points": [[0, 0], [4, 0], [1, 0.5], [0, 4]]}], "regions": [{"id": "r", "material": "m", "thickness": 1}]})";
    };
    const Meshed freely(arrow(""));
    REQUIRE(freely.mesh.is_sound());
    CHECK(freely.mesh.reports()[0].method == "delaunay");
    CHECK(freely.area() == Approx(3.0).epsilon(1e-12));
    CHECK(sentences_of(arrow(R"(, "method": "mapped")")).find("turned inside out") != std::string::npos);
}

TEST_CASE("Joints where curves touch are no corners of a map: a slot is meshed freely")
{
    for (const std::string element : {"T3", "T6", "Q4", "Q8", "Q9"}) {
        CAPTURE(element);
        const Meshed slot(R"({"cremona": 1, "analysis": "plane_stress", "units": {"length": "m", "force": "N"},
            "materials": [{"id": "m", "E": 300, "nu": 0.2}], "mesh": {"element": ")" +
                          element + R"("}, "points": [], "curves": [
            {"id": "a", "kind": "line", "points": [[-1, -0.5], [1, -0.5]]},
            {"id": "b", "kind": "arc", "center": [1, 0], "points": [[1, -0.5], [1, 0.5]]},
            {"id": "c", "kind": "line", "points": [[1, 0.5], [-1, 0.5]]},
            {"id": "d", "kind": "arc", "center": [-1, 0], "points": [[-1, 0.5], [-1, -0.5]]}],
            "regions": [{"id": "slot", "material": "m", "thickness": 1}]})");
        REQUIRE(slot.mesh.is_sound());
        CHECK(slot.mesh.mesh().reports[0].method == (element[0] == 'T' ? "delaunay" : "quads"));
        CHECK(slot.area() == Approx(2.0 + 0.25 * std::numbers::pi).epsilon(element[1] > '4' ? 1e-4 : 0.01));
        CHECK(mesh_quality(slot.model()).min_jacobian > 0.2);
    }
}

TEST_CASE("Quadrilaterals with middle nodes fill round outlines of few parts, each the right way round")
{
    const std::array<std::string, 4> outlines{
        R"({"id": "o", "kind": "circle", "center": [0, 0], "radius": 1)",
        R"({"id": "o", "kind": "ellipse", "center": [0, 0], "axes": [2, 0.8])",
        R"({"id": "a", "kind": "line", "points": [[-1, 0], [1, 0]]},
           {"id": "b", "kind": "arc", "center": [0, 0], "points": [[1, 0], [-1, 0]])",
        R"({"id": "a", "kind": "line", "points": [[0, 1], [0, 0.3], [0.3, 0], [1, 0]]},
           {"id": "b", "kind": "arc", "center": [0, 0], "points": [[1, 0], [0, 1]])"};
    for (const std::string element : {"Q8", "Q9"})
        for (const std::string size : {"0.1", "0.2", "0.4", "0.8"})
            for (std::size_t i = 0; i < outlines.size(); ++i) {
                CAPTURE(element);
                CAPTURE(size);
                CAPTURE(i);
                const std::string at = i == 3 ? R"("at": [0.6, 0.6], )" : "";
                const Meshed round(R"({"cremona": 1, "analysis": "plane_stress",
                    "units": {"length": "m", "force": "N"}, "materials": [{"id": "m", "E": 300, "nu": 0.2}],
                    "mesh": {"method": "quads", "element": ")" +
                                   element + R"(", "size": )" + size + R"(}, "points": [], "curves": [)" + outlines[i] +
                                   R"(}], "regions": [{"id": "r", )" + at + R"("material": "m", "thickness": 1}]})");
                REQUIRE(round.mesh.is_sound());
                CHECK(mesh_quality(round.model()).min_jacobian > 0.05);
            }
}

TEST_CASE("A map whose curved edges meet in no angle is no map, where chords would have one")
{
    // two arcs that touch lines at their ends: chords of a few parts turn there, tangents do not
    const Meshed lens(R"({"cremona": 1, "analysis": "plane_stress", "units": {"length": "m", "force": "N"},
        "materials": [{"id": "m", "E": 300, "nu": 0.2}], "mesh": {"element": "Q8", "size": 0.8}, "points": [],
        "curves": [{"id": "a", "kind": "line", "points": [[0, 0], [2, 0]]},
        {"id": "b", "kind": "bezier", "points": [[2, 0], [3.4, 0.3], [3.4, 1.7], [2, 2]]},
        {"id": "c", "kind": "line", "points": [[2, 2], [0, 2]]},
        {"id": "d", "kind": "line", "points": [[0, 2], [0, 0]]}],
        "regions": [{"id": "lens", "material": "m", "thickness": 1}]})");
    REQUIRE(lens.mesh.is_sound());
    CHECK(lens.mesh.mesh().reports[0].method == "quads");
}

TEST_CASE("Middle nodes of a curve lie on it, so that a round hole's area is met to the fourth order")
{
    const auto hole_of = [](int n) {
        const Meshed meshed(
            RectangleText{.curves = circle_in(R"(, "divide": )" + std::to_string(n)), .regions = with_hole}.text());
        for (const NodeId node : nodes_along(CurveTable(meshed.model(), EdgeTable(meshed.model())).edges[4])) {
            const auto& [x, y] = meshed.model()[node].at;
            CHECK(std::hypot(x - 2.0, y - 1.0) == Approx(0.5).epsilon(1e-12));
        }
        return 8.0 - meshed.area();
    };
    const double exact = 0.25 * std::numbers::pi, coarse = hole_of(16) - exact, fine = hole_of(32) - exact;
    CHECK(std::abs(fine) < 1e-5);
    CHECK(coarse / fine == Approx(16.0).epsilon(0.05));
}

TEST_CASE("A slender plate that is held is no mechanism: it bends as a beam, and the digits that hold are told")
{
    const auto strip = [](const std::string& depth) {
        return R"({"cremona": 1, "analysis": "plane_stress", "units": {"length": "m", "force": "N"},
            "materials": [{"id": "m", "E": 2e11, "nu": 0.3}], "points": [{"id": "A", "at": [0, 0]},
            {"id": "B", "at": [100, 0]}, {"id": "C", "at": [100, )" +
               depth + R"(]}, {"id": "D", "at": [0, )" + depth +
               R"(]}], "curves": [{"id": "outline", "kind": "line", "points": ["D", "A", "B", "C", "D"]},
            {"id": "left", "kind": "line", "points": ["D", "A"], "support": "fixed"},
            {"id": "right", "kind": "line", "points": ["B", "C"]}],
            "regions": [{"id": "plate", "material": "m", "thickness": 0.01}],
            "load_cases": [{"id": "P", "curves": [{"curve": "right", "kind": "traction", "qy": 1}]}]})";
    };
    const Meshed held(strip("0.05"));
    const PlaneResults results = analyse(held.model());
    const double beam = 4.0 * 0.05 * 0.01 * 1e6 / (2e11 * 0.01 * std::pow(0.05, 3)); // 4 P L^3 / (E b h^3)
    CHECK(results[CaseId(0)].displacement(NodeId(1U)).y() == Approx(beam).epsilon(0.005));
    REQUIRE(results.warnings().size() == 1);
    CHECK(results.warnings().front().kind == FaultKind::InaccurateBody);
    const Meshed too_slender(strip("0.005"));
    try {
        analyse(too_slender.model());
        FAIL("it was solved");
    } catch (const femoop::MechanismError&) {
        FAIL("it is held");
    } catch (const femoop::ModelError& refusal) {
        CHECK(refusal.faults().front().kind == FaultKind::IllConditionedBody);
    }
}

TEST_CASE("A uniform stress is met exactly by every element in every mesh of a drawing")
{
    struct Asked {
        const char* element;
        const char* method;
        const char* more = "";
    };
    constexpr auto three = R"(, "corners": ["A", "B", "C"])";
    for (const Asked& asked : {Asked{"T3", "mapped", R"(, "diagonal": "right")"},
                               {"T3", "mapped", R"(, "diagonal": "left")"},
                               {"T3", "mapped", R"(, "diagonal": "cross")"},
                               {"T3", "mapped", R"(, "diagonal": "shortest")"},
                               {"T6", "mapped", R"(, "diagonal": "cross")"},
                               {"Q4", "mapped"},
                               {"Q8", "mapped"},
                               {"Q9", "mapped"},
                               {"T6", "sweep"},
                               {"Q4", "sweep"},
                               {"Q8", "sweep"},
                               {"Q9", "sweep"},
                               {"T3", "trilateral", three},
                               {"T6", "trilateral", three},
                               {"Q4", "trilateral", three},
                               {"Q8", "trilateral", three},
                               {"Q9", "trilateral", three},
                               {"T3", "delaunay"},
                               {"T6", "delaunay"},
                               {"T3", "front"},
                               {"T6", "front"},
                               {"T3", "quadtree"},
                               {"T6", "quadtree"},
                               {"Q4", "quads"},
                               {"Q8", "quads"},
                               {"Q9", "quads"}}) {
        CAPTURE(asked.element);
        CAPTURE(asked.method);
        const Meshed meshed(RectangleText{.mesh = R"({"size": 0.7, "element": ")" + std::string(asked.element) +
                                                  R"(", "method": ")" + asked.method + R"(")" + asked.more + "}",
                                          .left = R"(, "support": {"fixed": ["ux"]})",
                                          .points = R"(, {"id": "E", "at": [0, 0], "support": "roller"})"}
                                .text());
        REQUIRE(meshed.mesh.is_sound());
        CHECK(meshed.mesh.reports()[0].method == asked.method);
        CHECK(meshed.area() == Approx(8.0).epsilon(1e-12));
        const PlaneCase result = analyse(meshed.model())[CaseId(0)];
        CHECK(result.displacement(*meshed.mesh.node(NodeId(1))).x() == Approx(3.0 / 300.0 * 4.0).epsilon(1e-10));
        CHECK(result.displacement(*meshed.mesh.node(NodeId(2))).y() == Approx(-0.2 * 3.0 / 300.0 * 2.0).epsilon(1e-10));
    }
}

TEST_CASE("A sector is meshed by every method for three sides or any, its area met as its curves are")
{
    // a quarter of a circle of radius 3 with its corner cut off along a circle of radius 1: four sides, or by its centre
    // three
    const auto quarter = [](const std::string& mesh, bool is_ring) {
        const std::string inner =
            R"({"id": "inner", "kind": "arc", "center": "O", "points": ["C", "D"], "turn": "cw"}, )";
        return R"({"cremona": 1, "analysis": "plane_stress", "units": {"length": "m", "force": "N"},
            "materials": [{"id": "m", "E": 300, "nu": 0.2}], "mesh": {"size": 0.4, )" +
               mesh + R"(}, "points": [{"id": "O", "at": [0, 0]}, {"id": "A", "at": [3, 0]}, {"id": "B", "at": [0, 3]},
            {"id": "C", "at": [0, 1]}, {"id": "D", "at": [1, 0]}], "curves": [)" +
               (is_ring ? inner : "") + R"({"id": "arc", "kind": "arc", "center": "O", "points": ["A", "B"]},
            {"id": "up", "kind": "line", "points": [")" +
               (is_ring ? "C" : "O") + R"(", "B"]},
            {"id": "right", "kind": "line", "points": [")" +
               (is_ring ? "D" : "O") + R"(", "A"]}],
            "regions": [{"id": "r", "at": [1.3, 1.3], "material": "m", "thickness": 1}]})";
    };
    struct Asked {
        const char* mesh;
        bool is_ring;
    };
    for (const Asked& asked : {Asked{R"("method": "sweep", "element": "Q8")", true},
                               {R"("method": "sweep", "element": "T6")", true},
                               {R"("method": "mapped", "element": "Q9")", true},
                               {R"("method": "front")", true},
                               {R"("method": "quadtree")", true},
                               {R"("method": "quads", "element": "Q8")", true},
                               {R"("method": "trilateral", "corners": ["O", "A", "B"], "element": "T6")", false},
                               {R"("method": "trilateral", "corners": ["O", "A", "B"], "element": "Q8")", false},
                               {R"("method": "front")", false},
                               {R"("method": "quadtree")", false}}) {
        CAPTURE(asked.mesh);
        CAPTURE(asked.is_ring);
        const Meshed meshed(quarter(asked.mesh, asked.is_ring));
        REQUIRE(meshed.mesh.is_sound());
        CHECK(meshed.area() == Approx(0.25 * std::numbers::pi * (asked.is_ring ? 8.0 : 9.0)).epsilon(1e-4));
        CHECK(mesh_quality(meshed.model()).min_angle >= 15.0);
    }
}

TEST_CASE(
    "Sides of a trilateral region without divisions take those of the others, and of quadrilaterals an even number")
{
    const std::string asked = R"({"method": "trilateral", "corners": ["A", "B", "C"], "size": 0.4)";
    const Meshed usual(RectangleText{.mesh = asked + R"(, "element": "T3"})"}.text());
    CHECK(usual.n_along(0) == 15); // C to D to A, 6 long, has the most
    CHECK(usual.n_along(1) == 15);
    CHECK(usual.model().elements.size() == 15 * 15);
    const Meshed even(RectangleText{.mesh = asked + R"(, "element": "Q4"})"}.text());
    CHECK(even.n_along(0) == 16);
    CHECK(even.model().elements.size() == 3 * 8 * 8);
    const Meshed divided(RectangleText{.mesh = asked + R"(, "element": "T6"})", .right = R"(, "divide": 4)"}.text());
    CHECK(divided.n_along(0) == 4);
    CHECK(divided.n_along(2) + divided.n_along(3) == 4);
}

TEST_CASE("A line that runs through a hole and past the plate holds what it meets, and its fields run along all of it")
{
    // From x = -1 to 5 through the rectangle with its hole: uy = s / 100 there, so that the middle of its right part
    // goes up by 0.0425.
    const Meshed meshed(
        RectangleText{.mesh = R"({"size": 0.25})",
                      .left = "",
                      .points = R"(, {"id": "E", "at": [0, 1], "support": {"fixed": ["ux"]}})",
                      .curves = circle_in("") + R"(, {"id": "axis", "kind": "line", "support": "roller",
                                          "points": [[-1, 1], [5, 1]]})",
                      .regions = R"({"id": "plate", "at": [[0.1, 0.1], [0.1, 1.9]], "material": "m", "thickness": 1},
                                          {"id": "empty", "at": [[2, 0.9], [2, 1.1]], "hole": true})",
                      .loads = R"("settlements": [{"curve": "axis", "uy": [0, 0.06]}])"}
            .text());
    REQUIRE(meshed.mesh.is_sound());
    REQUIRE(meshed.model().curves[5].reach.has_value());
    CHECK(meshed.model().curves[5].reach->runs.size() == 2);
    const PlaneReading written = examine_plane_model(write_plane_model(meshed.model()));
    REQUIRE(written.is_sound());
    CHECK(written.model.curves[6].id == "axis 2");
    for (const PlaneModel* const model : {&meshed.model(), &written.model}) {
        const PlaneResults results = analyse(*model);
        const auto place = results.locator().find({3.25, 1.0});
        CHECK(results[CaseId(0)].displacement(place.front()).y() == Approx(0.0425).epsilon(1e-9));
    }
}

TEST_CASE("A settlement that strains nothing is no reason for a warning")
{
    for (const char* const element : {"T3", "T6", "Q4", "Q8"}) {
        CAPTURE(element);
        const Meshed meshed(RectangleText{.mesh = R"({"element": ")" + std::string(element) + R"("})",
                                          .loads = R"("settlements": [{"curve": "left", "uy": -0.1}])"}
                                .text());
        const PlaneResults results = analyse(meshed.model());
        CHECK(results.warnings().empty());
        CHECK(results[CaseId(0)].displacement(*meshed.mesh.node(NodeId(2))).y() == Approx(-0.1).epsilon(1e-12));
        CHECK(results[CaseId(0)].error_estimate() == 0.0);
    }
}

TEST_CASE("What dangles in material stays in its mesh where it carries something, and is left out where it does not")
{
    const std::string rib = R"(, {"id": "rib", "kind": "line", "points": [[1, 0.5], [3, 0.7]])";
    const Meshed loaded(
        RectangleText{.curves = rib + "}", .loads = R"("curves": [{"curve": "rib", "kind": "line", "qy": -2}])"}
            .text());
    REQUIRE(loaded.mesh.is_sound());
    CHECK(loaded.model().curves.size() == 5);
    CHECK(analyse(loaded.model())[CaseId(0)].equilibrium().sum_loads[1] == Approx(-2.0 * std::hypot(2.0, 0.2)));
    const Meshed bare(RectangleText{.curves = rib + "}"}.text());
    CHECK(bare.model().curves.size() == 4);
    const Meshed pointed(RectangleText{.points = R"(, {"id": "P", "at": [1.3, 0.9]})",
                                       .loads = R"("points": [{"point": "P", "fy": -5}])"}
                             .text());
    REQUIRE(pointed.mesh.node(NodeId(4)).has_value());
    CHECK(analyse(pointed.model())[CaseId(0)].equilibrium().sum_loads[1] == Approx(-5.0));
}

TEST_CASE("Where uneven elements are mended, none becomes flat")
{
    for (const char* const size : {"0.05", "0.03"}) {
        CAPTURE(size);
        const Meshed fine(
            RectangleText{.mesh = std::string(R"({"element": "Q4", "method": "quads", "size": )") + size + "}"}.text());
        REQUIRE(fine.mesh.faults().empty());
        const MeshQuality quality = mesh_quality(fine.model());
        CHECK(quality.min_jacobian > 0.15);
        CHECK(quality.min_angle > 15.0);
        CHECK(quality.max_angle < 170.0);
    }
}

TEST_CASE("Elements are small near a point with a size of its own")
{
    const Meshed usual(RectangleText{.mesh = R"({"element": "T3", "method": "delaunay", "size": 0.5})"}.text());
    const Meshed fine(RectangleText{.mesh = R"({"element": "T3", "method": "delaunay", "size": 0.5})",
                                    .points = R"(, {"id": "P", "at": [1.3, 0], "size": 0.02})"}
                          .text());
    CHECK(fine.model().elements.size() > 2 * usual.model().elements.size());
    CHECK(fine.area() == Approx(8.0).epsilon(1e-12));
    CHECK(mesh_quality(fine.model()).min_angle >= 25.0);
}

TEST_CASE("Each fault of a mesh has a drawing that shows it, and says what to do")
{
    std::set<FaultKind> shown;
    for (const BadMesh& bad : bad_meshes()) {
        CAPTURE(bad.text);
        const std::string sentences = sentences_of(bad.text);
        CAPTURE(sentences);
        CHECK_MESSAGE(sentences.find(';') != std::string::npos, sentences);
        const PlaneReading reading = examine_plane_model(bad.text);
        std::vector<Fault> faults = reading.faults;
        if (femoop::errors_among(faults).empty()) {
            const Drawing drawing(reading.model);
            REQUIRE(drawing.is_sound());
            faults = MeshedDrawing(drawing).faults();
        }
        CHECK(std::any_of(faults.begin(), faults.end(), [&](const Fault& fault) { return fault.kind == bad.kind; }));
        shown.insert(bad.kind);
    }
    for (auto kind = static_cast<int>(FaultKind::PointsAtOnePlace);
         kind <= static_cast<int>(FaultKind::MeshAngleMissed); ++kind) {
        CAPTURE(pattern(static_cast<FaultKind>(kind)));
        CHECK(shown.contains(static_cast<FaultKind>(kind)));
    }
}
