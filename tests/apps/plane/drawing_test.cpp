#include <doctest/doctest.h>

#include <filesystem>
#include <numbers>
#include <set>
#include <string>

#include "apps/plane/discretize/drawing.h"
#include "apps/plane/discretize/singular_corners.h"
#include "femoop/io/any_model.h"
#include "femoop/io/plane/plane_file.h"
#include "femoop/io/plane/plane_verify.h"
#include "tests/source_folder.h"

using namespace femoop::plane;
using discretize::Drawing;
using doctest::Approx;
using femoop::Fault;
using femoop::FaultKind;

namespace {

constexpr double pi = std::numbers::pi;

/// A drawing of which a case replaces a part: a square of 4 with a round hole of radius 1 in its middle.
struct DrawingText {
    std::string_view analysis = "plane_stress";
    std::string_view points = R"([{"id": "M", "at": [2, 2]}, {"id": "A", "at": [0, 0]}])";
    std::string_view curves =
        R"([{"id": "edge", "kind": "line", "points": ["A", [4, 0], [4, 4], [0, 4]], "closed": true},
        {"id": "hole", "kind": "circle", "center": "M", "radius": 1}])";
    std::string_view regions = R"([{"id": "plate", "at": [0.5, 0.5], "material": "m", "thickness": 2},
        {"id": "empty", "at": [2, 2], "hole": true}])";
    std::string_view more = "";

    std::string text() const
    {
        const auto list = [](std::string_view key, std::string_view value) {
            return ", \"" + std::string(key) + "\": " + std::string(value);
        };
        return R"({"cremona": 1, "units": {"length": "m", "force": "N"}, "materials": [{"id": "m", "E": 3, "nu": 0.2}])" +
               list("analysis", "\"" + std::string(analysis) + "\"") + list("points", points) + list("curves", curves) +
               list("regions", regions) + std::string(more) + "}";
    }
};

std::string with_curve(std::string_view curve)
{
    const std::string curves =
        R"([{"id": "edge", "kind": "line", "points": ["A", [4, 0], [4, 4], [0, 4]], "closed": true},
        {"id": "hole", "kind": "circle", "center": "M", "radius": 1}, )" +
        std::string(curve) + "]";
    return DrawingText{.curves = curves}.text();
}
std::string with_regions(std::string_view regions) { return DrawingText{.regions = regions}.text(); }
std::string with_more(const std::string& more) { return DrawingText{.more = more}.text(); }
std::string with_check(const std::string& check)
{
    return with_more(R"(, "expected": [{)" + check + R"(, "value": 7}])");
}

std::vector<Fault> faults_of(const std::string& text)
{
    PlaneReading reading = examine_plane_model(text);
    if (!reading.is_sound()) return reading.faults;
    const Drawing drawing(reading.model);
    reading.faults.insert(reading.faults.end(), drawing.faults().begin(), drawing.faults().end());
    return reading.faults;
}

struct BadDrawing {
    std::string text;
    std::string message;
};

std::vector<BadDrawing> bad_drawings()
{
    return {
        {with_curve(R"({"id": "c", "kind": "edges", "points": ["A", "M"]})"),
         "curves[2] \"c\": found the kind \"edges\" without \"elements\", wanted line, arc, circle, ellipse, bezier or spline; "
         "draw the curve, or give the mesh"},
        {with_curve(R"({"id": "c", "kind": "line", "points": ["A", 3]})"),
         "curves[2].points[1]: is no place of a curve; name a point or write [x, y], like [2.5, 0]"},
        {with_curve(R"({"id": "c", "kind": "ellipse", "center": "M", "axes": [3]})"),
         "curves[2].axes: an ellipse has two half axes; write [a, b], like [3, 2]"},
        {with_curve(R"({"id": "c", "kind": "line", "points": ["A", [3, 9]], "divide": {"n": 3, "ratio": 1e300}})"),
         "curves[2] \"c\": found 1e300, wanted a ratio of parts from 0.000001 to 1000000; write it like {\"n\": 8, "
         "\"ratio\": 2}"},
        {with_curve(R"({"id": "c", "kind": "line", "points": ["A", [3, 9]], "divide": {"n": 2.5}})"),
         "curves[2].divide: found 2.5, wanted a whole number of parts from 1 to 1000000; write 8, or {\"n\": 8, "
         "\"ratio\": 2}"},
        {with_curve(R"({"id": "c", "kind": "bezier", "points": ["A", "M", [3, 9]]})"),
         "curves[2] \"c\": found a list of 3 places, wanted 4, 7, 10 or so on of a Bézier curve; add some or take some away"},
        {with_curve(R"({"id": "c", "kind": "line", "points": [[7, 7], [7, 7]]})"),
         "curves[2] \"c\": a part of this curve has no length: its places are one to within snap; move one or take it away"},
        {with_curve(R"({"id": "c", "kind": "arc", "points": [[7, 7], [8, 8], [9, 9]]})"),
         "curves[2] \"c\": its three places lie in one line, so that no circle goes through them; move one, or draw a line"},
        {with_curve(R"({"id": "c", "kind": "arc", "center": "M", "points": [[7, 2], [2, 8]]})"),
         "curves[2] \"c\": its ends are 5 m and 6 m from the centre, wanted one radius; move an end or the centre"},
        {DrawingText{.points = "[]",
                     .curves = R"([{"id": "c", "kind": "arc", "center": [2, 2], "points": [[7, 2], [2, 7.1]]}])",
                     .regions = "[]"}
             .text(),
         "curves[0] \"c\": its ends are 5 m and 5.1 m from the centre, wanted one radius; move an end or the centre"},
        {DrawingText{.points = "[]",
                     .curves = R"([{"id": "c", "kind": "arc", "points": [[0, 0], [1, 0], [2, 0]]}])",
                     .regions = "[]"}
             .text(),
         "curves[0] \"c\": its three places lie in one line, so that no circle goes through them; move one, or draw a line"},
        {with_curve(
             R"({"id": "c", "kind": "ellipse", "center": [9, 9], "axes": [2, 1], "points": [[11, 9], [9, 12]]})"),
         "curves[2] \"c\": an end lies 2 m off the ellipse; move it, or change the axes"},
        {with_curve(R"({"id": "c", "kind": "bezier", "points": [[0, 4], [0, 3], [0, 2], [0, 1]]})"),
         "curves[2] \"c\": runs along curve \"edge\" for a stretch, which only straight lines and arcs of one circle may do; "
         "end it there"},
        {with_more(R"(, "snap": 1e-20)"),
         "snap: found 1e-20 m, wanted 4e-15 m or more, below which the drawing's coordinates are not told apart; give a "
         "larger one"},
        {with_curve(R"({"id": "c", "kind": "line", "points": [[0, 1.5], [4, 1.5]], "divide": [2, 3, 4, 5]})"),
         "curves[2] \"c\": \"divide\" lists 4 entries for 3 pieces from vertex to vertex; give one of each, or one for all\n"
         "the face at (0.566987, 2.5) m, of area 7.47259 m^2, is in no region and is left empty; give it a region, or a hole\n"
         "the face at (2, 1.25) m, of area 0.614185 m^2, is in no region and is left empty; give it a region, or a hole"},
        {with_regions(R"([{"id": "plate", "at": [0.5, 0.5], "material": "m", "hole": true}])"),
         "regions[0] \"plate\": a hole is left empty; take its material or \"hole\" away"},
        {with_regions(
             R"([{"id": "plate", "at": [9, 0.5], "material": "m", "thickness": 2}, {"id": "r", "hole": true}])"),
         "regions[0] \"plate\": no face of the drawing is at (9, 0.5) m; give a place inside closed curves"},
        {with_regions(
             R"([{"id": "plate", "at": [4, 0.5], "material": "m", "thickness": 2}, {"id": "r", "hole": true}])"),
         "regions[0] \"plate\": (4, 0.5) m lies on curve \"edge\"; give a place inside a face"},
        {with_regions(R"([{"id": "plate", "at": [1, 0.5], "material": "m", "thickness": 2},
            {"id": "r", "at": [[2, 2], [0.1, 3]], "hole": true}])"),
         "regions[1] \"r\": the face at (0.1, 3) m is that of regions[0] \"plate\" already; give another place"},
        {with_regions(R"([{"id": "plate", "material": "m", "thickness": 2}, {"id": "r", "hole": true}])"),
         "regions[1] \"r\": takes all the rest of the faces, as regions[0] \"plate\" does; give one of them a place \"at\""},
        {with_regions(R"([{"id": "plate", "at": [[1, 0.5], [2, 2]], "material": "m", "thickness": 2},
            {"id": "r", "hole": true}])"),
         "regions[1] \"r\": no face is left for it; close an outline or delete the region"},
        {DrawingText{
             .points = R"([{"id": "M", "at": [2, 2]}, {"id": "A", "at": [0, 0]}, {"id": "P", "at": [3.5, 0.5]}])"}
             .text(),
         "points[2] \"P\": no curve goes through this point; use it or delete it"},
        {with_curve(R"({"id": "c", "kind": "line", "points": [[4, 3], [3.5, 3]]})"),
         "curves[2] \"c\": a part of this curve bounds nothing; let it go on, or delete it"},
        {with_curve(R"({"id": "c", "kind": "line", "points": [[0, 0], [4, 0.1]]})"),
         "the face at (3, 0.05) m, of area 0.2 m^2, is in no region and is left empty; give it a region, or a hole"},
        {DrawingText{.points = R"([{"id": "A", "at": [0, 0]}])",
                     .curves = R"([{"id": "edge", "kind": "line", "points": ["A", [4, 0], [4, 0.2]], "closed": true}])",
                     .regions = R"([{"id": "plate", "material": "m", "thickness": 2}])"}
             .text(),
         "the corner at (0, 0) m has an angle of 2.86241 degrees, so that elements there are poor; widen it"},
        {with_curve(R"({"id": "c", "kind": "bezier", "points": [[1, 1], [1, 5], [1, 1], [1, 0.5]]})"),
         "curves[2] \"c\": runs back along itself, since what draws it is in one line; put its places in order, or draw "
         "straight lines"},
        {DrawingText{
             .points = R"([{"id": "A", "at": [0, 0]}])",
             .curves = R"([{"id": "edge", "kind": "line", "points": ["A", [4, 0], [4, 4], [0, 4]], "closed": true},
                 {"id": "c", "kind": "line", "points": [[1, 5e-4], [1, 3], [3, 3], [3, 3e-4]]}])",
             .regions = R"([{"id": "plate", "material": "m", "thickness": 2}])",
             .more = R"(, "snap": 0.001)"}
             .text(),
         "curves[0] \"edge\": meets c in one vertex at (1, 0.0005) m, though they lie up to 0.0005 m from it, since "
         "snap is 0.001 m; draw them at one place, or give a smaller snap\n"
         "curves[0] \"edge\": meets c in one vertex at (3, 0.0003) m, though they lie up to 0.0003 m from it, since "
         "snap is 0.001 m; draw them at one place, or give a smaller snap"},
        {with_curve(R"({"id": "c", "kind": "line", "points": [[6, 0], [7, 0]], "support": "pin"})"),
         "curves[2] \"c\": \"c\" touches no material, so that nothing takes it; put a region beside it or take it away\n"
         "curves[2] \"c\": a part of this curve bounds nothing; let it go on, or delete it"},
        {with_curve(R"({"id": "c", "kind": "line", "points": [[0, 0.25], [4, 0.25]]})"),
         "the face at (2, 0.125) m, of area 1 m^2, is in no region and is left empty; give it a region, or a hole"},
        {DrawingText{
             .regions = R"([{"id": "plate", "material": "m", "thickness": 2}])",
             .more = R"(, "load_cases": [{"id": "P", "curves": [{"curve": "hole", "kind": "pressure", "value": 3}]}])"}
             .text(),
         "load_cases[0].curves[0]: curve \"hole\" has material on both sides, wanted one, into which a pressure pushes; give "
         "a traction"},
        {with_check(R"("quantity": "area", "at": [8, 8])"),
         "expected[0]: no face of the drawing is at (8, 8) m; give a place inside closed curves"},
        {with_check(R"("quantity": "area", "which": 3)"), "expected[0]: asks for face 3 of 2; give a smaller number"},
        {with_check(R"("quantity": "area")"),
         "expected[0]: a check of area needs to know of what; give \"at\", \"region\" or \"which\""},
        {with_more(R"(, "mesh": {"element": "T6", "formulation": "b_bar"})"),
         "regions[0] \"plate\": the formulation b_bar is not made for a T6 in plane_stress; choose standard or other elements"},
        {DrawingText{.analysis = "axisymmetric",
                     .curves = R"([{"id": "c", "kind": "circle", "center": "M", "radius": 3}])",
                     .regions = R"([{"id": "plate", "material": "m"}])"}
             .text(),
         "curves[0] \"c\": x is -1 m, wanted 0 or more in an axisymmetric model, where it is the radius; move the point"},
    };
}

} // namespace

TEST_CASE("The drawing that the others vary is sound, and has the areas of its outline and its circle")
{
    const PlaneReading reading = examine_plane_model(DrawingText{}.text());
    const Drawing drawing(reading.model);
    for (const Fault& fault : drawing.faults()) FAIL_CHECK(message(fault));
    REQUIRE(drawing.faces().size() == 2);
    CHECK(drawing.faces()[0].area == Approx(16.0 - pi).epsilon(1e-13));
    CHECK(drawing.faces()[0].perimeter == Approx(16.0 + 2.0 * pi).epsilon(1e-13));
    CHECK(drawing.faces()[0].n_holes == 1);
    CHECK(drawing.faces()[1].area == Approx(pi).epsilon(1e-13));
    CHECK(reading.model[*drawing.faces()[1].region].is_hole);
    CHECK(drawing.face_at({2.0, 2.0}) == std::optional<std::size_t>(1));
    CHECK(!drawing.face_at({3.0, 2.0})); // on the circle
    CHECK(!drawing.face_at({9.0, 2.0}));
}

TEST_CASE("The drawings of tests/cases/regions have the vertices, edges, regions and areas that they expect")
{
    std::size_t n_passed = 0;
    for (const auto& entry : std::filesystem::directory_iterator(source_folder() + "/tests/cases/regions")) {
        CAPTURE(entry.path().filename().string());
        const auto reading = std::get<PlaneReading>(femoop::examine_any_file(entry.path()));
        REQUIRE(reading.is_sound());
        const Drawing drawing(reading.model);
        CHECK(drawing.is_sound());
        const DrawnChecks drawn{.count_or_area = [&](const PlaneExpected& check) { return drawing.read(check); }};
        for (const femoop::CheckOutcome& outcome : verify(reading.model, {}, drawn)) {
            CAPTURE(outcome.what);
            CHECK(outcome.verdict == femoop::Verdict::Passed);
            ++n_passed;
        }
    }
    CHECK(n_passed == 44);
}

TEST_CASE("What is wrong with a drawing is told with place, finding and remedy")
{
    for (const BadDrawing& bad : bad_drawings()) {
        CAPTURE(bad.text);
        std::string sentences;
        for (const Fault& fault : faults_of(bad.text)) sentences += (sentences.empty() ? "" : "\n") + message(fault);
        CHECK(sentences == bad.message);
    }
}

TEST_CASE("Every fault of a drawing has a file that shows it")
{
    std::set<FaultKind> shown{FaultKind::CurveTooNear};             // of curves that are tangled on purpose
    for (auto kind = static_cast<int>(FaultKind::PointsAtOnePlace); // of meshes: meshed_drawing_test.cpp
         kind <= static_cast<int>(FaultKind::MeshAngleMissed); ++kind)
        shown.insert(static_cast<FaultKind>(kind));
    for (const BadDrawing& bad : bad_drawings())
        for (const Fault& fault : faults_of(bad.text)) shown.insert(fault.kind);
    for (auto kind = static_cast<int>(FaultKind::EdgesWithoutElements);
         kind <= static_cast<int>(FaultKind::CheckFacePlace); ++kind) {
        CAPTURE(pattern(static_cast<FaultKind>(kind)));
        CHECK(shown.contains(static_cast<FaultKind>(kind)));
    }
}

TEST_CASE("Stresses have no bound at re-entrant corners, at which regions add up, and have one at fillets and arcs")
{
    const auto corners = [](const std::string& curves, const std::string& regions) {
        const PlaneModel model = read_plane_model(
            DrawingText{.points = "[]", .curves = curves, .regions = regions}.text());
        return discretize::singular_corners(Drawing(model));
    };
    const std::string whole = R"([{"id": "plate", "material": "m", "thickness": 2}])";
    const std::string outline = R"([{"id": "o", "kind": "line", "closed": true,
        "points": [[0, 0], [7, 0], [7, 3], [2, 3], [2, 5], [0, 5]]})";
    const auto sharp = corners(outline + "]", whole);
    REQUIRE(sharp.size() == 1);
    CHECK(sharp[0].at == topology::FlatPoint{2.0, 3.0});
    CHECK(sharp[0].angle == Approx(270.0));
    const auto of_two = corners(outline + R"(, {"id": "b", "kind": "line", "points": [[2, 3], [2, 0]]}])",
                                R"([{"id": "left", "at": [1, 1], "material": "m", "thickness": 2},
                                    {"id": "right", "at": [5, 1], "material": "m", "thickness": 2}])");
    REQUIRE(of_two.size() == 1);
    CHECK(of_two[0].angle == Approx(270.0));
    const std::string filleted = R"([{"id": "o", "kind": "line",
        "points": [[2.5, 3], [7, 3], [7, 0], [0, 0], [0, 5], [2, 5], [2, 3.5]]},
        {"id": "f", "kind": "arc", "center": [2.5, 3.5], "points": [[2, 3.5], [2.5, 3]]}])";
    CHECK(corners(filleted, whole).empty());
}

TEST_CASE("Places that snap makes one are told with their names, and what round-off parts is not")
{
    const auto told = [](std::string_view points, std::string_view curves, std::string_view more) {
        std::string text;
        for (const Fault& fault :
             faults_of(DrawingText{.points = points, .curves = curves, .regions = "[]", .more = more}.text()))
            if (fault.kind == FaultKind::PlacesMerged) text += femoop::fill("{0} with {1}: {3}; ", fault.arguments);
        return text;
    };
    const std::string_view corner =
        R"([{"id": "A", "at": [0, 0]}, {"id": "B", "at": [3, 4]}, {"id": "C", "at": [3.003, 4.004]}])";
    const std::string_view lines =
        R"([{"id": "to", "kind": "line", "points": ["A", "B"]}, {"id": "on", "kind": "line", "points": ["C", [9, 1]]}])";
    CHECK(told(corner, lines, R"(, "snap": 0.01)") == "points[1] \"B\" with C, to and on: 0.005 m; ");
    CHECK(told(corner, lines, R"(, "snap": 0.004)").empty());
    CHECK(
        told(
            R"([{"id": "A", "at": [1, 1]}, {"id": "B", "at": [1, 1]}])",
            R"([{"id": "c", "kind": "line", "points": ["A", [5, 2]]}, {"id": "d", "kind": "line", "points": ["B", [5, 0]]}])",
            "") == "points[0] \"A\" with B, c and d: 0 m; ");
    const std::string_view nearly_one = // three lines about (1, 1), of which the third misses by 3e-3 / sqrt(1 + 1/9)
        R"([{"id": "a", "kind": "line", "points": [[0, 0], [2, 2]]}, {"id": "b", "kind": "line", "points": [[0, 2], [2, 0]]},
            {"id": "c", "kind": "line", "points": [[-2, 0.003], [4, 2.003]]}])";
    CHECK(told("[]", nearly_one, R"(, "snap": 0.01)").starts_with("curves[0] \"a\" with b and c: 0.00"));
    const std::string_view exact = // thirds, a tangent arc, radii that differ by as much as the file may be rounded
        R"([{"id": "a", "kind": "line", "points": [[0, 0], [1, 0.3333333333333333], [3, 1]]},
            {"id": "b", "kind": "line", "points": [[0, 1], [3, 0]]}, {"id": "c", "kind": "line", "points": [[1.5, -4], [1.5, 4]]},
            {"id": "d", "kind": "arc", "center": [1.5, 0.5], "points": [[2.2071068, 1.2071068], [0.7928932, -0.2071068]]},
            {"id": "e", "kind": "bezier", "points": [[3, 1], [4, 2], [5, -2], [0, 0]]},
            {"id": "f", "kind": "spline", "points": [[0, 1], [0.7, 2.1], [3, 1], [0, 0]]}])";
    CHECK(told("[]", exact, "").empty());
}

TEST_CASE("Places and lengths that a drawing was computed to have get the reader's decimal mark")
{
    const femoop::Translator comma = [](std::string_view text) { return std::string(text == "." ? "," : text); };
    const std::vector<Fault> faults = faults_of(
        DrawingText{.points = R"([{"id": "A", "at": [0, 0]}])",
                    .curves = R"([{"id": "edge", "kind": "line", "points": ["A", [3, 0], [3, 2.5]], "closed": true},
                        {"id": "c", "kind": "line", "points": [[1.5, 0.004], [1.5, -1]]}])",
                    .regions = R"([{"id": "plate", "at": [2, 0.5], "material": "m", "thickness": 2}])",
                    .more = R"(, "snap": 0.01)"}
            .text());
    REQUIRE(faults.size() == 2);
    CHECK(message(faults.back(), comma)
              .find("(1,5; 0,004) m, though they lie up to 0,004 m from it, since snap is 0,01 m") !=
          std::string::npos);
}

TEST_CASE("A point is a vertex unless it is merely a centre or a control point")
{
    const PlaneReading reading = examine_plane_model(
        DrawingText{.points = R"([{"id": "M", "at": [2, 2]}, {"id": "A", "at": [0, 0]}, {"id": "P", "at": [4, 1]}])"}
            .text());
    const Drawing drawing(reading.model);
    CHECK(drawing.subdivision().counts().vertices == 6); // four corners, P on the right edge, the circle's start
    CHECK(!drawing.vertex(femoop::NodeId(0)));
}
