#include <doctest/doctest.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "femoop/io/any_model.h"
#include "femoop/io/plane/plane_file.h"
#include "tests/femoop/plane/plane_text.h"

using namespace femoop;
using namespace femoop::plane;

namespace {

/// A file with one fault, and the sentence that it gets. A warning counts as a fault here.
struct BadPlaneFile {
    std::string text;
    std::string message;
};

std::string with_curve_keys(std::string_view keys)
{
    const std::string curves = R"([{"id": "left", "kind": "edges", "points": ["D", "A"], )" + std::string(keys) + "}]";
    return PlaneText{.curves = curves}.text();
}
std::string with_elements(std::string_view elements) { return PlaneText{.curves = "[]", .elements = elements}.text(); }
std::string with_curve_load(std::string_view load, std::string_view analysis = "plane_stress",
                            std::string_view regions = PlaneText{}.regions)
{
    const std::string load_case = R"(, "curves": [{"curve": "right", )" + std::string(load) + "}]";
    return PlaneText{.analysis = analysis, .regions = regions, .load_case = load_case}.text();
}
std::string with_region_load(std::string_view load)
{
    const std::string load_case = R"(, "regions": [{)" + std::string(load) + "}]";
    return PlaneText{.load_case = load_case}.text();
}
std::string with_settlement(std::string_view settlement)
{
    const std::string load_case = R"(, "settlements": [{)" + std::string(settlement) + "}]";
    return PlaneText{.load_case = load_case}.text();
}
std::string with_plane_check(std::string_view keys, std::string_view analysis = "plane_stress",
                             std::string_view regions = PlaneText{}.regions)
{
    const std::string more = R"(, "expected": [{)" + std::string(keys) + R"(, "value": 7}])";
    return PlaneText{.analysis = analysis, .regions = regions, .more = more}.text();
}

constexpr std::string_view bare_regions = R"([{"id": "web", "material": "m"}, {"id": "rib", "material": "m"}])";
constexpr std::string_view point_g =
    R"([{"id": "A", "at": [0, 0]}, {"id": "B", "at": [3, 0]}, {"id": "C", "at": [7, 0]},
    {"id": "D", "at": [0, 2]}, {"id": "E", "at": [3, 2]}, {"id": "F", "at": [7, 2]}, {"id": "G", "at": [9, 9])";

std::string with_point_g(std::string_view keys)
{
    const std::string points = std::string(point_g) + std::string(keys) + "}]";
    return PlaneText{.points = points}.text();
}

std::vector<BadPlaneFile> files_with_bad_meshes()
{
    return {
        {with_elements(R"([{"id": "1", "kind": "Q4", "points": ["A", "B", "X", "D"], "region": "web"}])"),
         "elements[0].points[2]: no point \"X\"; add the point or name another"},
        {with_elements(R"([{"id": "1", "kind": "Q4", "points": ["A", "B", "E", "D"], "region": "wab"},
            {"id": "2", "kind": "Q4", "points": ["B", "C", "F", "E"], "region": "rib"}])"),
         "elements[0] \"1\": no region \"wab\"; did you mean \"web\"?"},
        {with_elements(R"([{"id": "1", "kind": "Q4", "points": ["A", "B", "E", "D"], "region": "plate"},
            {"id": "2", "kind": "Q4", "points": ["B", "C", "F", "E"], "region": "rib"}])"),
         "elements[0] \"1\": no region \"plate\"; add the region or name another"},
        {PlaneText{.curves = R"([{"id": "c", "kind": "circle", "center": "A", "radius": 2}])"}.text(),
         "curves[0] \"c\": found the kind circle beside \"elements\", wanted edges; name the corners of consecutive element "
         "edges"},
        {with_elements(R"([{"id": "1", "kind": "T3", "points": ["A", "B", "E", "D"], "region": "web"},
            {"id": "2", "kind": "Q4", "points": ["B", "C", "F", "E"], "region": "rib"}])"),
         "elements[0] \"1\": found a list of 4, wanted the names of 3 points of a T3; name its corners "
         "counter-clockwise, then middle nodes, then the centre"},
        {with_elements(R"([{"id": "1", "kind": "Q4", "points": ["A", "D", "E", "B"], "region": "web"},
            {"id": "2", "kind": "Q4", "points": ["B", "C", "F", "E"], "region": "rib"}])"),
         "elements[0] \"1\": its corners run clockwise; list them counter-clockwise"},
        {with_elements(R"([{"id": "1", "kind": "T3", "points": ["A", "B", "C"], "region": "web"},
            {"id": "2", "kind": "Q4", "points": ["B", "C", "F", "E"], "region": "rib"},
            {"id": "3", "kind": "T3", "points": ["A", "E", "D"], "region": "web"}])"),
         "elements[0] \"1\": its points lie in one line, so that it has no area; move a point or delete the element"},
        {with_elements(R"([{"id": "1", "kind": "Q4", "points": ["A", "B", "D", "E"], "region": "web"},
            {"id": "2", "kind": "Q4", "points": ["B", "C", "F", "E"], "region": "rib"}])"),
         "elements[0] \"1\": too distorted: its Jacobian is -1.5 at D, wanted a positive one; keep its corners convex and "
         "middle nodes near mid-side"},
        {with_elements("[]"), "the model has no elements: there is nothing to analyse; add some"},
        {PlaneText{.curves = R"([{"id": "c", "kind": "edges", "points": ["A"]}])"}.text(),
         "curves[0] \"c\": found a list of 1, wanted 2 points or more; a curve without length has no edge: name its nodes"},
        {PlaneText{.curves = R"([{"id": "c", "kind": "edges", "points": ["A", "B", "F"]}])"}.text(),
         "curves[0] \"c\": no element has an edge from point \"B\" to point \"F\"; name the corners of consecutive "
         "element edges"},
        {PlaneText{.analysis = "axisymmetric",
                   .points = R"([{"id": "A", "at": [-1, 0]}, {"id": "B", "at": [3, 0]}, {"id": "C", "at": [7, 0]},
                       {"id": "D", "at": [0, 2]}, {"id": "E", "at": [3, 2]}, {"id": "F", "at": [7, 2]}])",
                   .regions = bare_regions}
             .text(),
         "points[0] \"A\": x is -1 mm, wanted 0 or more in an axisymmetric model, where it is the radius; move the point"},
        {with_point_g(R"(, "support": "fixed")"),
         "points[6] \"G\": no element meets point \"G\", so that nothing takes it; join an element or take it away"},
        {with_point_g(""), "points[6] \"G\": no element meets this point; use it or delete it"},
        {PlaneText{.points = R"([{"id": "A", "at": [0]}, {"id": "B", "at": [3, 0]}, {"id": "C", "at": [7, 0]},
                       {"id": "D", "at": [0, 2]}, {"id": "E", "at": [3, 2]}, {"id": "F", "at": [7, 2]}])"}
             .text(),
         "points[0].at: is no place; write [x, y], like [2.5, 0]"},
    };
}

std::vector<BadPlaneFile> files_with_bad_parts()
{
    return {
        {PlaneText{.regions = R"([{"id": "web", "material": "m", "thickness": 0.4, "mesh": {"formulation": "reduced"}},
            {"id": "rib", "material": "m", "thickness": 0.4}])"}
             .text(),
         "regions[0] \"web\": the formulation reduced is not made for a Q4 in plane_stress; choose standard or other "
         "elements"},
        {PlaneText{.regions = R"([{"id": "web", "material": "m"}, {"id": "rib", "material": "m", "thickness": 0.4}])"}
             .text(),
         "regions[0] \"web\": has no thickness, which a plane stress needs; add \"thickness\""},
        {PlaneText{.analysis = "axisymmetric",
                   .regions = R"([{"id": "web", "material": "m"}, {"id": "rib", "material": "m", "thickness": 0.4}])"}
             .text(),
         "regions[1] \"rib\": has a thickness, which an axisymmetric body lacks; take it away"},
        {PlaneText{.regions = R"([{"id": "web", "material": "m", "thickness": 0.4},
            {"id": "rib", "material": "m", "thickness": 0.4}, {"id": "hub", "material": "m", "thickness": 0.4}])"}
             .text(),
         "regions[2] \"hub\": no element is in this region; give it elements or delete it"},
        {PlaneText{.materials = R"([{"id": "m", "E": 71e3, "G": 3e4}])"}.text(),
         "materials[0] \"m\": gives G, which a plane model takes from E and nu; take it away"},
        {PlaneText{.analysis = "plane_strain", .materials = R"([{"id": "m", "E": 71e3, "nu": 0.5}])"}.text(),
         "materials[0] \"m\": nu is 0.5, wanted less than 0.5 in plane_strain, where the mean stress would be unknown; give "
         "0.4999 for example"},
        {PlaneText{.analysis = "plane_strain",
                   .materials = R"([{"id": "m", "E": 71e3, "nu": 0.495}])",
                   .regions = R"([{"id": "web", "material": "m"},
                       {"id": "rib", "material": "m", "mesh": {"formulation": "b_bar"}}])"}
             .text(),
         "regions[0] \"web\": nu is 0.495, so near to 0.5 that standard elements lock; choose b_bar for Q4, reduced for Q8, "
         "or Q9"},
        {with_curve_keys(R"("support": {"fixed": ["ux"], "axes": "local", "angle": 20})"),
         "curves[0].support: has local axes and an angle; keep one"},
        {with_curve_keys(R"("support": {"fixed": ["uy"], "angle": 20}, "tie": ["uy"])"),
         "curves[0] \"left\": ties its nodes along x or y, but point \"D\" is held in turned axes; take the tie or the angle "
         "away"},
        {with_curve_keys(R"("support": {"fixed": ["rz"]})"),
         "curves[0] \"left\": fixes rz, which plane_stress does not have; take it away: there are ux uy"},
        {PlaneText{.points = R"([{"id": "A", "at": [0, 0], "support": "symmetry"}, {"id": "B", "at": [3, 0]},
            {"id": "C", "at": [7, 0]}, {"id": "D", "at": [0, 2]}, {"id": "E", "at": [3, 2]}, {"id": "F", "at": [7, 2]}])"}
             .text(),
         "points[0] \"A\": symmetry follows a curve, and a point has none; give \"fixed\" and \"angle\""},
    };
}

std::vector<BadPlaneFile> files_with_bad_plane_loads()
{
    return {
        {PlaneText{.load_case = R"(, "points": [{"point": "H", "fx": 2}])"}.text(),
         "load_cases[0].points[0]: no point \"H\"; add the point or name another"},
        {PlaneText{.load_case = R"(, "curves": [{"curve": "rigth", "kind": "traction", "qx": 2}])"}.text(),
         "load_cases[0].curves[0]: no curve \"rigth\"; did you mean \"right\"?"},
        {PlaneText{.load_case = R"(, "curves": [{"curve": "hole", "kind": "traction", "qx": 2}])"}.text(),
         "load_cases[0].curves[0]: no curve \"hole\"; add the curve or name another"},
        {PlaneText{.load_case = R"(, "curves": [{"curve": "middle", "kind": "pressure", "value": 2}])"}.text(),
         "load_cases[0].curves[0]: curve \"middle\" has material on both sides, wanted one, into which a pressure pushes; "
         "give a traction"},
        {with_curve_load(R"("kind": "line", "qx": 2)", "axisymmetric", bare_regions),
         "load_cases[0].curves[0]: a force per length of the curve does not say how far it reaches around the axis; give "
         "a traction"},
        {PlaneText{.regions = R"([{"id": "web", "material": "m", "thickness": 0.4},
            {"id": "rib", "material": "m", "thickness": 0.9}])",
                   .load_case = R"(, "curves": [{"curve": "middle", "kind": "traction", "qx": 2}])"}
             .text(),
         "load_cases[0].curves[0]: curve \"middle\" parts regions of unlike thickness; this force per area acts on that "
         "of region \"web\", not of \"rib\"; with kind \"line\" it is one per length, which needs none"},
        {with_curve_load(R"("kind": "traction", "qx": [1, 2, 3])"),
         "load_cases[0].curves[0].qx: found a list of 3, wanted 2 values; give that at the start of the curve and that "
         "at its end"},
        {with_curve_load(R"("kind": "traction", "qx": {"polynomial": [[1, 2, 13]]})"),
         "load_cases[0].curves[0].qx.polynomial[0]: is no term of a polynomial; write [factor, power of x, power of y] "
         "with whole powers from 0 to 12, like [2.5, 1, 0]"},
        {with_curve_load(R"("kind": "traction", "qx": {"along": "x", "table": [[1, 2, 13]]})"),
         "load_cases[0].curves[0].qx.table[0]: is no row of a table; write [place, value], like [0, 2.5]"},
        {with_curve_load(R"("kind": "traction", "qx": {"along": "x", "table": [[1, 2], [1, 3]]})"),
         "load_cases[0].curves[0].qx.table[1]: its place is not beyond that of the row before; let the places ascend"},
        {with_curve_load(R"("kind": "traction", "qx": {"along": "x", "table": []})"),
         "load_cases[0].curves[0].qx.table: is empty, so it has no value; give an entry or leave it out"},
        {with_region_load(R"("kind": "body", "bx": [1, 2])"),
         "load_cases[0].regions[0].bx: varies along a curve, and there is none here; give a number, a polynomial or a table "
         "along x, y or r"},
        {PlaneText{.materials = R"([{"id": "m", "E": 71e3}])", .load_case = R"(, "self_weight": 1)"}.text(),
         "load_cases[0] \"P\": needs the density of material \"m\" (region \"web\"); add \"density\"\n"
         "load_cases[0] \"P\": needs the density of material \"m\" (region \"rib\"); add \"density\""},
        {PlaneText{.materials = R"([{"id": "m", "E": 71e3}])",
                   .load_case = R"(, "regions": [{"region": "rib", "kind": "temperature", "rise": 30}])"}
             .text(),
         "load_cases[0].regions[0]: needs the coefficient of thermal expansion of material \"m\" (region \"rib\"); add "
         "\"alpha\""},
        {PlaneText{.analysis = "axisymmetric",
                   .regions = bare_regions,
                   .load_case = R"(, "regions": [{"kind": "rotation", "omega": 3, "about": [1, 1]}])"}
             .text(),
         "load_cases[0].regions[0]: an axisymmetric body turns about its axis; take \"about\" away"},
        {with_region_load(R"("kind": "rotation", "omega": "30 Hz", "region": "web")"),
         "load_cases[0].regions[0].omega: \"30 Hz\" measures turns in a second, wanted an angular velocity, in rad/s for "
         "example"},
        {with_region_load(R"("kind": "body", "bx": 1, "region": ["web", "rib", "web"])"),
         "load_cases[0].regions[0].region[2]: found an id that stands before it too, wanted each id once; write it like "
         "[\"A\", \"B\"]"},
        {with_region_load(R"("kind": "body", "bx": 1, "region": [])"),
         "load_cases[0].regions[0].region: found an empty list, wanted one id at least; write it like [\"A\"]"},
        {with_settlement(R"("point": "A", "curve": "left", "ux": 2)"),
         "load_cases[0].settlements[0]: settles a point or a curve, one of them; give \"point\" or \"curve\""},
        {with_settlement(R"("curve": "right", "ux": 2)"),
         "load_cases[0].settlements[0]: ux of curve \"right\" is free, so it cannot be made to settle; fix it, give it a "
         "spring, or use a load"},
        {with_settlement(R"("point": "F", "ux": 2)"),
         "load_cases[0].settlements[0]: ux of node \"F\" is free, so it cannot be made to settle; fix it, give it a spring, "
         "or use a load"},
        {with_settlement(R"("curve": "left", "ux": 2}, {"point": "A", "ux": 3)"),
         "load_cases[0] \"P\": point \"A\" would settle by 2 mm and by 3 mm in one direction; give one of them"},
        {PlaneText{.curves = R"([{"id": "left", "kind": "edges", "points": ["D", "A"], "support": "fixed"},
                       {"id": "right", "kind": "edges", "points": ["C", "F"], "support": "fixed", "tie": ["ux"]}])",
                   .load_case = R"(, "settlements": [{"curve": "right", "ux": [1, 2]}])"}
             .text(),
         "load_cases[0] \"P\": point \"F\" would settle by 1 mm and by 2 mm in one direction; give one of them"},
        {PlaneText{.analysis = "axisymmetric",
                   .regions = bare_regions,
                   .load_case = R"(, "settlements": [{"curve": "left", "ux": 2}])"}
             .text(),
         "load_cases[0] \"P\": point \"A\" is on the axis of revolution, where ux = 0, and would leave it by 2 mm; take "
         "this away"},
        {with_settlement(R"("curve": "left", "ux": true)"),
         "load_cases[0].settlements[0].ux: found true or false, wanted a number, two at the ends, a polynomial or a "
         "table; write it like [1.5, 3]"},
    };
}

std::vector<BadPlaneFile> files_with_bad_plane_expectations()
{
    return {
        {with_plane_check(R"("quantity": "displacement", "component": "ux")"),
         "expected[0]: a check of a displacement needs one place; give \"point\" or \"at\""},
        {with_plane_check(R"("quantity": "stress", "component": "sx", "at": [12, 1])"),
         "expected[0]: no element is at (12, 1) mm; give a place in the material"},
        {with_plane_check(R"("quantity": "stress", "component": "sx", "point": "B")"),
         "expected[0]: regions web and rib meet here and their stresses differ; add \"region\""},
        {with_plane_check(R"("quantity": "stress", "component": "sx", "point": "A", "region": "rib")"),
         "expected[0]: region \"rib\" has no element here; name another"},
        {with_plane_check(
             R"("quantity": "extreme", "component": "sx", "which": "max", "curve": "left", "region": "rib")"),
         "expected[0]: region \"rib\" has no element here; name another"},
        {with_plane_check(R"("quantity": "stress", "component": "sx", "point": "A", "read": "gauss")"),
         "expected[0]: \"gauss\" goes with an extreme, over all integration points; read a place smoothed or by element"},
        {with_plane_check(R"("quantity": "reaction", "component": "fx", "curve": "right")"),
         "expected[0]: nothing holds it, so it has no reaction; name a point or a curve with a support"},
        {with_plane_check(R"("quantity": "resultant", "component": "N", "cut": [[1, 2], [1, 2]])"),
         "expected[0].cut: is no cut; write its two ends [[x1, y1], [x2, y2]], apart from one another"},
        {with_plane_check(R"("quantity": "resultant", "component": "N", "cut": [[1, 9], [2, 9]])"),
         "expected[0]: the cut meets no material; move it"},
        {with_plane_check(R"("quantity": "resultant", "component": "N", "cut": [[1, 0], [1, 2]])", "axisymmetric",
                          bare_regions),
         "expected[0]: a cut through an axisymmetric body has no N, V and M; read stresses"},
        {with_plane_check(R"("quantity": "energy", "component": "N")"),
         "expected[0].component: unknown key; take it away or use one of quantity, value, case, rtol, atol, source"},
        {with_plane_check(R"("quantity": "extreme", "component": "sx")"),
         "expected[0]: a check of a extreme needs \"which\"; add it"},
    };
}

void check_messages(const std::vector<BadPlaneFile>& files)
{
    for (const BadPlaneFile& file : files) {
        CAPTURE(file.text);
        std::string sentences;
        for (const Fault& fault : examine_plane_model(file.text).faults)
            sentences += (sentences.empty() ? "" : "\n") + message(fault);
        CHECK(sentences == file.message);
    }
}

} // namespace

TEST_CASE("The file that the others vary is sound") { CHECK(examine_plane_model(PlaneText{}.text()).faults.empty()); }

TEST_CASE("What is wrong with a mesh is told with place, finding and remedy")
{
    check_messages(files_with_bad_meshes());
}

TEST_CASE("What is wrong with materials, regions and supports is told likewise")
{
    check_messages(files_with_bad_parts());
}

TEST_CASE("What is wrong with loads and settlements is told likewise") { check_messages(files_with_bad_plane_loads()); }

TEST_CASE("What is wrong with checks is told likewise") { check_messages(files_with_bad_plane_expectations()); }

TEST_CASE("Every fault of a plane model has a file that shows it")
{
    std::set<FaultKind> shown;
    for (const auto& files : {files_with_bad_meshes(), files_with_bad_parts(), files_with_bad_plane_loads(),
                              files_with_bad_plane_expectations()})
        for (const BadPlaneFile& file : files)
            for (const Fault& fault : examine_plane_model(file.text).faults) shown.insert(fault.kind);
    // Shown by tests of their own, or too large for a test.
    for (const FaultKind kind : {FaultKind::PlaneModelElsewhere, FaultKind::NoSuchPointNear, FaultKind::TooManyElements,
                                 FaultKind::RegionMoves, FaultKind::RegionTurns, FaultKind::RegionDeforms})
        shown.insert(kind);
    for (auto kind = static_cast<int>(FaultKind::EdgesWithoutElements); // of drawings: tests/apps/plane
         kind <= static_cast<int>(FaultKind::CheckFacePlace); ++kind)
        shown.insert(static_cast<FaultKind>(kind));
    for (auto kind = static_cast<int>(FaultKind::PlaneModelElsewhere);
         kind <= static_cast<int>(FaultKind::RegionDeforms); ++kind) {
        CAPTURE(pattern(static_cast<FaultKind>(kind)));
        CHECK(shown.contains(static_cast<FaultKind>(kind)));
    }
}

TEST_CASE("All errors of a file are told at once")
{
    const PlaneText bad{.materials = R"([{"id": "m", "E": -3, "G": 2}])",
                        .load_case = R"(, "points": [{"point": "A", "fz": 3}])",
                        .more = R"(, "expected": [{"quantity": "energy", "value": "3 kg"}])"};
    CHECK(examine_plane_model(bad.text()).faults.size() == 4);
}
TEST_CASE("A plane model is known by its lists where its analysis is none")
{
    const std::string text = PlaneText{}.text();
    const auto with_analysis = [&text](const std::string& analysis) {
        std::string other = text;
        return other.replace(other.find(R"("plane_stress")"), std::string(R"("plane_stress")").size(), analysis);
    };
    for (const char* const analysis : {"\"plane_stres\"", "7", "null"}) {
        CAPTURE(analysis);
        const AnyReading any = examine_any(with_analysis(analysis));
        REQUIRE(std::holds_alternative<PlaneReading>(any));
        CHECK(std::get<PlaneReading>(any).faults.size() == 1);
        CHECK(message(std::get<PlaneReading>(any).faults.front()).starts_with("analysis: "));
    }
    CHECK(std::holds_alternative<ModelReading>(examine_any(with_analysis("\"frame2d\""))));
    CHECK(std::holds_alternative<ModelReading>(examine_any(R"({"nodes": [], "points": []})")));
}
