#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <numbers>
#include <string>

#include "tests/apps/cli/run_cremona.h"
#include "tests/folder.h"
#include "tests/text_of.h"

using cli_test::has;
using cli_test::Run;
using nlohmann::json;

TEST_SUITE_BEGIN("cremona");

namespace {

const std::string bending = "tests/cases/plane/PB-001-Q8.json";

std::string drawing()
{
    return R"({"cremona": 1, "analysis": "plane_stress", "units": {"length": "m", "force": "N"},
               "curves": [{"id": "c", "kind": "circle", "center": [0, 0], "radius": 2}],
               "expected": [{"quantity": "count", "component": "regions", "value": 1}]})";
}

} // namespace

TEST_CASE("A plane model is solved to the JSON that programs read")
{
    const Run run = cli_test::cremona({"solve", "--json", "--full", "--at", "5,0.5", "--cut", "3.3,-1,3.3,1", bending});
    REQUIRE(run.status == 0);
    const json out = json::parse(run.out);
    CHECK(out["analysis"] == "plane_stress");
    CHECK(out["mesh"]["nodes"] == 45);
    CHECK(out["mesh"]["elements"].size() == 10);
    CHECK(out["mesh"]["min_angle"].get<double>() == doctest::Approx(90.0));
    CHECK(out["regions"]["plate"]["area"].get<double>() == doctest::Approx(20.0));
    const json& M = out["cases"]["M"];
    CHECK(M["points"]["C"]["u"]["ux"].get<double>() == doctest::Approx(-1.5));
    CHECK(M["points"]["C"]["stress"]["plate"]["sx"].get<double>() == doctest::Approx(-150.0));
    CHECK(!M["points"]["C"].contains("reaction"));
    CHECK(M["points"]["E"].contains("reaction"));
    CHECK(M["curves"]["left"]["reaction"]["mz"].get<double>() == doctest::Approx(-100.0));
    CHECK(M["regions"]["plate"]["extremes"]["sx"]["max"]["value"].get<double>() == doctest::Approx(150.0));
    CHECK(M["probes"][0]["stress"]["plate"]["sx"].get<double>() == doctest::Approx(-75.0));
    CHECK(M["cuts"][0]["M"].get<double>() == doctest::Approx(100.0));
    CHECK(M["cuts"][0]["stations"][0]["sx'"].get<double>() == doctest::Approx(150.0));
    CHECK(M["energy"].get<double>() == doctest::Approx(75.0));
    CHECK(M["equilibrium"]["sum_loads"][2].get<double>() == doctest::Approx(100.0));
}

TEST_CASE("A drawing without material has counts, and nothing to be meshed")
{
    const Run solved = cli_test::cremona({"solve", "-"}, drawing()),
              meshed = cli_test::cremona({"mesh", "-"}, drawing()),
              verified = cli_test::cremona({"verify", "-"}, drawing());
    for (const Run& run : {solved, meshed}) {
        CHECK(run.status == 2);
        CHECK(has(run.err, "no face of the drawing has material"));
    }
    CHECK(verified.status == 0);
    CHECK(has(verified.out, "count regions = 1, expected 1 within 1e-06: passed"));
    CHECK(has(verified.out, "1 passed, 0 failed, 0 skipped"));
}

TEST_CASE("A drawing is meshed, for people and for programs, and its mesh solves to the same numbers")
{
    const Folder folder;
    const Run text = cli_test::cremona({"mesh", "examples/plate.json", "-o", folder.path("meshed.json")});
    CHECK(text.status == 0);
    CHECK(has(text.out, "769 nodes, 358 elements"));
    for (const char* const name : {"mesh.vtu", "mesh.svg"})
        CHECK(cli_test::cremona({"mesh", "examples/plate.json", "-o", folder.path(name)}).status == 0);
    CHECK(has(folder.read("mesh.vtu"), R"(NumberOfPoints="769" NumberOfCells="358")"));
    CHECK(has(folder.read("mesh.svg"), "<svg"));
    CHECK(has(text.out, "delaunay"));
    const json mesh = json::parse(cli_test::cremona({"mesh", "examples/plate.json", "--json"}).out);
    CHECK(mesh["mesh"]["nodes"] == 769);
    CHECK(mesh["regions"]["plate"]["method"] == "mapped");
    CHECK(mesh["regions"]["plate"]["area"].get<double>() == doctest::Approx(1250.0));
    const json drawn = json::parse(cli_test::cremona({"solve", "examples/plate.json", "--json"}).out),
               meshed = json::parse(cli_test::cremona({"solve", folder.path("meshed.json"), "--json"}).out);
    CHECK(drawn["cases"]["P"]["points"].size() == 5);
    CHECK(drawn["regions"]["ring"]["method"] == "delaunay");
    for (const char* const point : {"A", "B", "C", "D", "E"})
        CHECK(drawn["cases"]["P"]["points"][point] == meshed["cases"]["P"]["points"][point]);
    CHECK(drawn["cases"]["P"]["energy"].get<double>() ==
          doctest::Approx(meshed["cases"]["P"]["energy"].get<double>()).epsilon(1e-9));
    for (const std::string name : {"a.obj", ""}) {
        const auto refused = cli_test::cremona({"mesh", "examples/plate.json", "-o", name});
        CHECK(refused.status == 2);
        CHECK(has(refused.err,
                  "--output: found \"" + name + "\", wanted a name that ends in .json, .vtu, .svg, .pdf or .png"));
    }
}

TEST_CASE("mesh --regions prints the faces of a drawing, for people and for programs")
{
    const Run text = cli_test::cremona({"mesh", "--regions", "examples/plate.json"});
    CHECK(text.status == 0);
    CHECK(has(text.out, "vertices: 8, edges: 10, regions: 3, components: 1"));
    const json out = json::parse(cli_test::cremona({"mesh", "--regions", "--json", "examples/plate.json"}).out);
    CHECK(out["vertices"] == 8);
    REQUIRE(out["faces"].size() == 3);
    CHECK(out["faces"][0]["region"] == "plate");
    const double hole = std::numbers::pi * 100.0 / 4.0, right = 1250.0; // a quarter of the circle, half of the square
    CHECK(out["faces"][0]["area"].get<double>() + out["faces"][1]["area"].get<double>() ==
          doctest::Approx(2500.0 - hole).epsilon(1e-12));
    CHECK(out["faces"][0]["area"].get<double>() == doctest::Approx(right).epsilon(1e-12));
}

TEST_CASE("check tells what is wrong with the mesh of a drawing, and wants none where there is no material")
{
    std::string text = text_of_source("tests/cases/drawn/DM-001.json");
    const std::string parts = R"("divide": 20})";
    text.replace(text.rfind(parts), parts.size(), R"("divide": 19})");
    const Run run = cli_test::cremona({"check", "-"}, text);
    CHECK(run.status == 2);
    CHECK(has(run.err, "wanted equally many parts on opposite sides, found 20 (\"down\") and 19 (\"up\")"));
    CHECK(cli_test::cremona({"check", "-"}, drawing()).status == 0);
}

TEST_CASE("mesh wants a drawing")
{
    CHECK(has(cli_test::cremona({"mesh", "examples/portal.json"}).err, "has no regions; give a plane model"));
    CHECK(has(cli_test::cremona({"mesh", bending}).err, "the file has its mesh already"));
}

TEST_CASE("A plane body that can move is refused with status 3 and the region that moves")
{
    std::string text = text_of_source(bending);
    for (const std::string& support :
         {std::string(R"(, "support": "pin")"), std::string(R"(, "support": {"fixed": ["ux"]})")})
        text.replace(text.find(support), support.size(), "");
    const Run run = cli_test::cremona({"solve", "-"}, text);
    CHECK(run.status == 3);
    CHECK(has(run.err, "the part in plate moves along x"));
    CHECK(has(run.err, "the part in plate turns about"));
}

TEST_CASE("A plane model that is converted is tidied, and other commands refuse it by name")
{
    const Run first = cli_test::cremona({"convert", bending, "-"});
    REQUIRE(first.status == 0);
    CHECK(first.out == text_of_source(bending));
    CHECK(cli_test::cremona({"convert", bending, "-", "--bend", "members=a,curve=parabola,rise=1,parts=4"}).status ==
          2);
    CHECK(cli_test::cremona({"solve", bending, "--why", "member=a"}).status == 2);
    CHECK(cli_test::cremona({"solve", bending, "--funicular", "automatic"}).status == 2);
}

TEST_CASE("A plane model that is counted in other units has the same results, and is drawn as render draws it")
{
    const Folder folder;
    const std::string other = folder.path("inches.json");
    REQUIRE(cli_test::cremona({"convert", "examples/hole.json", other, "--units", "in,kip"}).status == 0);
    const json model = json::parse(folder.read("inches.json"));
    CHECK(model["units"]["length"] == "in");
    CHECK(model["materials"][0]["E"] == "200 GPa");
    CHECK(model["points"][2]["at"][0].get<double>() == doctest::Approx(200.0 / 25.4));
    CHECK(cli_test::cremona({"verify", other}).status == 0);
    const std::string back = folder.path("back.json");
    REQUIRE(cli_test::cremona({"convert", other, back, "--units", "mm,N"}).status == 0);
    CHECK(json::parse(folder.read("back.json"))["points"][2]["at"][0].get<double>() == doctest::Approx(200.0));
    REQUIRE(cli_test::cremona({"convert", "examples/hole.json", folder.path("hole.svg")}).status == 0);
    REQUIRE(cli_test::cremona({"render", "examples/hole.json", "-o", folder.path("drawn.svg")}).status == 0);
    CHECK(folder.read("hole.svg") == folder.read("drawn.svg"));
}

namespace {

/// An L of two legs of 50, held at the end of one and loaded at that of the other, with something wrong.
std::string angle_plate(const std::string& region, const std::string& more)
{
    return R"({"cremona": 1, "analysis": "plane_stress", "units": {"length": "mm", "force": "N"},
               "materials": [{"id": "s", "E": "200 GPa", "nu": 0.3}], "mesh": {"size": 20},
               "curves": [{"id": "t", "kind": "line", "points": [[50, 100], [0, 100]], "support": "fixed"},
                          {"id": "o", "kind": "line", "points": [[0, 100], [0, 0], [100, 0]]},
                          {"id": "r", "kind": "line", "points": [[100, 0], [100, 50]]},
                          {"id": "i", "kind": "line", "points": [[100, 50], [50, 50], [50, 100]]}],
               "load_cases": [{"id": "P", "curves": [{"curve": "r", "kind": "traction", "qy": -10}]}],
               "regions": [{"id": "R", "at": [10, 10], "material": "s")" +
           region + "}]" + more + "}";
}

} // namespace

TEST_CASE("A re-entrant corner is told where stresses are, with its place; it is no fault")
{
    const Folder folder;
    const std::string file = folder.write("l.json", angle_plate(R"(, "thickness": 5)", ""));
    const std::string sentence = "at the re-entrant corner (50, 50) with 270° of material; a fillet bounds them";
    const Run solved = cli_test::cremona({"solve", file});
    CHECK(solved.status == 0);
    CHECK(has(solved.err, sentence));
    CHECK(has(cli_test::cremona({"render", file, "--describe", "--show", "bands:mises"}).out, sentence));
    CHECK(has(cli_test::cremona({"render", file, "-o", folder.path("l.svg"), "--show", "bands:mises,legend"}).err,
              sentence));
    CHECK(has(folder.read("l.svg"), "grows with the"));
    CHECK_FALSE(has(cli_test::cremona({"render", file, "-o", folder.path("l.svg")}).err, sentence));
    CHECK_FALSE(has(cli_test::cremona({"solve", "examples/hole.json"}).err, "re-entrant"));
}

TEST_CASE("Faults of fields, of places and of checks are told at once, as far as one does not follow from another")
{
    const Folder folder;
    const std::string file = folder.write(
        "bad.json", angle_plate("", R"(, "expected": [{"quantity": "count", "component": "holes", "value": 1},
                                                      {"quantity": "area", "which": 9, "value": 1}])"));
    const Run run = cli_test::cremona({"check", file});
    CHECK(run.status == 2);
    CHECK(has(run.err + run.out, "has no thickness"));
    CHECK(has(run.err + run.out, "expected[0]: a check of count needs to know of what"));
    CHECK(has(run.err + run.out, "expected[1]"));
    CHECK(has(run.err + run.out, "errors: 3"));
}

TEST_CASE("What names a point without a name is not told beside that")
{
    const Folder folder;
    const std::string file = folder.write("empty.json", R"({"cremona": 1, "analysis": "plane_stress",
        "units": {"length": "m", "force": "N"}, "materials": [{"id": "s", "E": 3e9, "nu": 0.3}], "mesh": {"size": 1},
        "points": [{"id": "", "at": [0, 0]}],
        "curves": [{"id": "o", "kind": "line", "points": ["", [3, 0], [3, 2], [0, 2]], "closed": true}],
        "regions": [{"id": "R", "material": "s", "thickness": -1}]})");
    const Run run = cli_test::cremona({"check", file});
    CHECK(has(run.err + run.out, "points[0]: \"id\" is empty"));
    CHECK(has(run.err + run.out, "errors: 2"));
}

TEST_CASE("A body that can move is drawn where a motion takes it, with status 3")
{
    const Folder folder;
    const std::string file = folder.write("free.json", R"({"cremona": 1, "analysis": "plane_stress",
        "units": {"length": "m", "force": "N"}, "materials": [{"id": "s", "E": 3e9, "nu": 0.3}], "mesh": {"size": 1},
        "curves": [{"id": "o", "kind": "line", "points": [[0, 0], [3, 0], [3, 2], [0, 2]], "closed": true}],
        "load_cases": [{"id": "P", "curves": [{"curve": "o", "kind": "traction", "qx": 1}]}],
        "regions": [{"id": "R", "material": "s", "thickness": 1}]})");
    for (const char* const motion : {"1", "3"})
        CHECK(cli_test::cremona({"render", file, "-o", folder.path("m.svg"), "--mechanism", motion}).status == 3);
    CHECK(folder.has("m.svg"));
    CHECK(cli_test::cremona({"render", file, "-o", folder.path("b.svg"), "--show", "bands:sx"}).status == 3);
    CHECK(folder.has("b.svg"));
    CHECK(has(cli_test::cremona({"render", file, "-o", folder.path("n.svg"), "--mechanism", "4"}).err,
              "wanted at most 3"));
}

TEST_CASE("An element is traced by its name or by a place in it; what is neither is refused with those that there are")
{
    CHECK(has(cli_test::cremona({"solve", bending, "--trace", "1"}).out, "Element 1, Q8 in region"));
    const Run there = cli_test::cremona({"solve", bending, "--trace", "0.1,0.1", "--json"});
    CHECK(json::parse(there.out)["trace"]["stiffness"].size() == 16);
    const Run nowhere = cli_test::cremona({"solve", bending, "--trace", "1000,1"});
    CHECK(nowhere.status == 2);
    CHECK(has(nowhere.err, "found \"1000,1\"; wanted an element, of this mesh 1 to 10, or a place X,Y in one"));
}

TEST_CASE("A place or a cut outside the material is refused, and both belong to plane models")
{
    CHECK(has(cli_test::cremona({"solve", bending, "--at", "50,0"}).err, "no element is at 50,0"));
    CHECK(has(cli_test::cremona({"solve", bending, "--at", "50"}).err, "wanted 2 numbers"));
    CHECK(has(cli_test::cremona({"solve", bending, "--cut", "50,0,60,0"}).err, "meets no material"));
    CHECK(has(cli_test::cremona({"solve", bending, "--cut", "5,1,5,1"}).err, "ends where it begins"));
    const Run frame = cli_test::cremona({"solve", "examples/portal.json", "--at", "1,1"});
    CHECK(frame.status == 2);
    CHECK(has(frame.err, "are for plane models"));
}

TEST_SUITE_END();

TEST_CASE(
    "A drawing is rendered with its regions, loads and supports; a word that is none of ours is answered with all")
{
    const Folder folder;
    const Run run = cli_test::cremona({"render", "examples/plate.json", "-o", folder.path("plate.svg")});
    CHECK(run.status == 0);
    const std::string svg = folder.read("plate.svg");
    for (const char* const words : {"A quarter of a plate with a hole", ">ring<", ">100 N/mm²<", ">hole<"})
        CHECK(has(svg, words));
    const Run unknown = cli_test::cremona(
        {"render", "examples/plate.json", "-o", folder.path("x.svg"), "--show", "moments"});
    CHECK(unknown.status == 2);
    CHECK(has(unknown.err, "geometry, regions"));
}

TEST_CASE("A mesh, that of a drawing too, is rendered with bands, lines, crosses and errors")
{
    const Folder folder;
    const auto shown = [&](const std::string& words, std::vector<std::string> more = {}) {
        std::vector<std::string> all{"render", bending, "-o", folder.path("x.svg"), "--show", words};
        all.insert(all.end(), more.begin(), more.end());
        return cli_test::cremona(all);
    };
    CHECK(shown("bands:sx,mesh,geometry,labels").status == 0);
    CHECK(has(folder.read("x.svg"), ">max 150 "));
    CHECK(has(folder.read("x.svg"), ">min −150 "));
    CHECK(shown("contour:mises,principal,trajectories,deformed,error,labels").status == 0);
    CHECK(has(folder.read("x.svg"), "displacements ×"));
    CHECK(shown("vectors,legend").status == 0);
    CHECK(has(folder.read("x.svg"), "arrows: displacements, the largest "));
    CHECK(shown("bands:sx,labels", {"--range", "-20,30"}).status == 0);
    CHECK(has(folder.read("x.svg"), "fixed range"));
    CHECK(has(shown("bands:sx", {"--range", "30,-20"}).err, "the smaller number first"));
    CHECK(has(shown("bands:sx", {"--read", "gauss"}).err, "smoothed, element"));
    CHECK(shown("bands:sx,error").status == 2);
    const Run drawn = cli_test::cremona(
        {"render", "examples/plate.json", "-o", folder.path("y.svg"), "--show", "bands:sx,labels"});
    CHECK(drawn.status == 0);
    CHECK(has(folder.read("y.svg"), "σx [N/mm²]"));
}

TEST_CASE(
    "A cut of a picture has N, V and M with the stresses of beam theory; more cuts than there is room for are refused")
{
    const Folder folder;
    const auto with = [&](std::vector<std::string> more) {
        std::vector<std::string> all{"render", bending, "-o", folder.path("x.svg"), "--size", "900x700"};
        all.insert(all.end(), more.begin(), more.end());
        return cli_test::cremona(all);
    };
    CHECK(with({"--cut", "3.3,-1,3.3,1", "--at", "5,0.5", "--at", "1,-0.5"}).status == 0);
    const std::string svg = folder.read("x.svg");
    CHECK(has(svg, ">M = 100 "));
    CHECK(has(svg, ">beam theory<"));
    CHECK(has(svg, ">(5, 0.5)<"));
    CHECK(has(svg, ">(1, −0.5)<"));
    CHECK(has(with({"--cut", "1,-1,1,1", "--cut", "2,-1,2,1", "--cut", "3,-1,3,1"}).err, "has room for 2"));
    CHECK(has(with({"--cut", "50,0,60,0"}).err, "meets no material"));
    CHECK(has(with({"--at", "50,0"}).err, "no element is at 50,0"));
}

TEST_CASE("What a picture of a plane model shows is told in sentences, in both languages and without an output")
{
    const Run run = cli_test::cremona({"render", "examples/plate.json", "--describe"});
    REQUIRE(run.status == 0);
    CHECK(has(run.out, "region plate: 1250 mm², of brass\n"));
    CHECK(has(run.out, "region empty: a hole of 78.54 mm²\n"));
    CHECK(has(run.out, "right: traction qx = 100 N/mm²\n"));
    const Run bent = cli_test::cremona(
        {"--lang", "pt", "render", bending, "--show", "bands:sx,error,mesh,loads", "--at", "5,0.5", "--describe"});
    CHECK(bent.status == 2);
    const Run portuguese = cli_test::cremona(
        {"--lang", "pt", "render", bending, "--show", "contour:sx,error,mesh", "--at", "5,0.5", "--describe"});
    REQUIRE(portuguese.status == 0);
    CHECK(has(portuguese.out, "σx: de −150 kN/m² em (0; 1) a 150 kN/m² em (0; −1)\n"));
    CHECK(has(portuguese.out, "malha: 10 elementos, 45 nós\n"));
    CHECK(has(portuguese.out, "em (5; 0,5): "));
    CHECK(has(portuguese.out, "σx = −75 kN/m²"));
}

TEST_CASE("What is of members is refused of a plane model, and what is of plane models of members")
{
    const Folder folder;
    const std::string out = folder.path("x.svg");
    CHECK(has(cli_test::cremona({"render", "examples/plate.json", "-o", out, "--view", "a"}).err,
              "a plane model is drawn with"));
    CHECK(has(cli_test::cremona({"render", "examples/plate.json", "-o", out, "--mechanism", "1"}).err,
              "the structure is no mechanism"));
    CHECK(has(cli_test::cremona({"render", "examples/portal.json", "-o", out, "--cut", "0,0,1,1"}).err,
              "are for plane models"));
    CHECK(!folder.has("x.svg"));
    CHECK(has(cli_test::cremona({"solve", bending, "--stations", "5"}).err, "--stations is not built yet for plane"));
}

TEST_CASE("An envelope of a plane model has the largest and smallest of its cases, each with the case that governs")
{
    using nlohmann::json;
    const auto solved = [](std::vector<std::string> options) {
        options.insert(options.begin(), {"solve", "examples/dam.json", "--json"});
        const Run run = cli_test::cremona(options);
        REQUIRE(run.status == 0);
        return json::parse(run.out);
    };
    const std::vector<std::string> places{"--at", "10,20", "--cut", "0,10,60,10"};
    std::vector<std::string> of_envelope = places;
    of_envelope.insert(of_envelope.end(), {"--case", "envelope"});
    const json all = solved(places)["cases"], envelope = solved(of_envelope)["envelope"];
    REQUIRE(all.size() >= 2);
    REQUIRE(envelope["cases"].size() == all.size());
    int n_seen = 0;
    const auto check = [&](const json& range, const json::json_pointer& path) {
        CAPTURE(path.to_string());
        double largest = -1e300, smallest = 1e300;
        for (const auto& [id, of_case] : all.items()) {
            largest = std::max(largest, of_case.at(path).get<double>());
            smallest = std::min(smallest, of_case.at(path).get<double>());
        }
        CHECK(range["max"]["value"] == largest);
        CHECK(range["min"]["value"] == smallest);
        CHECK(all.at(range["max"]["case"].get<std::string>()).at(path) == largest);
        CHECK(all.at(range["min"]["case"].get<std::string>()).at(path) == smallest);
        ++n_seen;
    };
    const auto pointer = [](std::initializer_list<std::string> keys) {
        json::json_pointer path;
        for (const std::string& key : keys) path /= key;
        return path;
    };
    for (const auto& [id, point] : envelope["points"].items()) {
        for (const char* const u : {"ux", "uy"}) check(point["u"][u], pointer({"points", id, "u", u}));
        for (const auto& [region, stress] : point["stress"].items())
            for (const auto& [component, range] : stress.items())
                check(range, pointer({"points", id, "stress", region, component}));
    }
    for (const auto& [id, curve] : envelope["curves"].items())
        for (const char* const force : {"fx", "fy", "mz"})
            check(curve["reaction"][force], pointer({"curves", id, "reaction", force}));
    for (const char* const u : {"ux", "uy"})
        check(envelope["probes"][0]["u"][u], json::json_pointer("/probes/0/u") / u);
    for (const char* const force : {"N", "V", "M"})
        check(envelope["cuts"][0][force], json::json_pointer("/cuts/0") / force);
    CHECK(n_seen > 20);
    CHECK(envelope["cuts"][0]["cut"] == json{{0, 10}, {60, 10}});
    const json region = envelope["regions"]["dam"]["extremes"]["mises"]["max"];
    for (const auto& [id, of_case] : all.items())
        CHECK(of_case["regions"]["dam"]["extremes"]["mises"]["max"]["value"] <= region["value"]);
    CHECK(all[region["case"].get<std::string>()]["regions"]["dam"]["extremes"]["mises"]["max"]["at"] == region["at"]);
}

TEST_CASE("An envelope of a plane model is printed in tables and written as a table for a spreadsheet")
{
    const Folder folder;
    const Run run = cli_test::cremona(
        {"solve", "examples/dam.json", "--case", "envelope", "--csv", folder.path("out")});
    CHECK(run.status == 0);
    for (const char* const part : {"Envelope of weight, water", "largest", "smallest", "ux [m]", "curve", "mises"})
        CHECK(has(run.out, part));
    CHECK(has(run.err + run.out, "envelope.csv"));
    CHECK(folder.has("out/envelope.csv"));
    CHECK(has(cli_test::cremona({"solve", "examples/dam.json", "--case", "envelope", "--describe"}).err,
              "--describe and --case envelope print different things"));
}

TEST_CASE("Displacements of a plane model are corrected by their residuals, and --time tells how good they are")
{
    const Run plain = cli_test::cremona({"solve", bending, "--json"}),
              refined = cli_test::cremona({"solve", bending, "--json", "--refine", "--time"});
    REQUIRE(refined.status == 0);
    CHECK(has(refined.err, "backward error"));
    const auto a = nlohmann::json::parse(plain.out), b = nlohmann::json::parse(refined.out);
    CHECK(a["cases"]["M"]["energy"].get<double>() == doctest::Approx(b["cases"]["M"]["energy"].get<double>()));
    CHECK(has(cli_test::cremona({"solve", bending, "--refine", "--trace", "1"}).err,
              "--trace and --refine print different things"));
}

TEST_CASE("What a plane model prints in place of its results is refused beside what would say nothing there")
{
    const auto refused = [](std::vector<std::string> options) {
        options.insert(options.begin(), {"solve", bending});
        const Run run = cli_test::cremona(options);
        CHECK(run.status == 2);
        CHECK(run.out.empty());
        return run.err;
    };
    CHECK(has(refused({"--trace", "1", "--at", "5,0.5"}), "--trace and --at print different things"));
    CHECK(has(refused({"--trace", "1", "--cut", "5,-1,5,1"}), "--trace and --cut print different things"));
    CHECK(has(refused({"--trace", "1", "--cycles", "2"}), "--trace and --cycles print different things"));
    CHECK(has(refused({"--trace", "1", "--json", "--full"}), "--trace and --full print different things"));
    CHECK(has(refused({"--trace", "1", "--time"}), "--trace and --time print different things"));
    CHECK(has(refused({"--cycles", "2", "--time"}), "--cycles and --time print different things"));
    CHECK(has(refused({"--analysis", "modal", "--time"}), "--analysis modal and --time print different things"));
    CHECK(has(refused({"--full"}), "--full needs --json too"));
    CHECK(has(refused({"--analysis", "modal", "--full"}), "--full needs --json too"));
}

TEST_CASE("The phases of a plane model are timed, that of its mesh where it is drawn")
{
    const Run mesh = cli_test::cremona({"solve", bending, "--time"});
    CHECK(mesh.status == 0);
    CHECK(has(mesh.out, "Load case M"));
    for (const char* const phase :
         {" s  read", " s  assemble", " s  factor", " s  recover", " s  write", " dofs", "nonzeros of its factor"})
        CHECK(has(mesh.err, phase));
    CHECK(!has(mesh.err, " s  mesh"));
    CHECK(has(cli_test::cremona({"solve", "examples/plate.json", "--time", "--lang", "pt"}).err, " s  malha"));
}

TEST_CASE("The results of a plane model are written as tables for a spreadsheet, with those of places and cuts")
{
    const Folder folder;
    const Run run = cli_test::cremona({"solve", bending, "--csv", folder.path("out")});
    REQUIRE(run.status == 0);
    CHECK(has(run.out, "Load case M"));
    CHECK(has(run.err, "written: " + folder.path("out/displacements.csv")));
    CHECK(folder.read("out/displacements.csv").starts_with("case,point,x [m],y [m],ux [m],uy [m]\n"));
    CHECK(cli_test::count(folder.read("out/displacements.csv"), "\n") == 46);
    CHECK(has(folder.read("out/reactions.csv"), "\nM,E,0,0,"));
    CHECK(folder.read("out/curves.csv").starts_with("case,curve,fx [kN],fy [kN],mz [kN*m]\nM,left,0,"));
    CHECK(has(folder.read("out/stresses.csv"), "case,point,x [m],y [m],region,sx [kN/m^2],"));
    CHECK(has(folder.read("out/extremes.csv"), "\nM,plate,sx,kN/m^2,150"));
    CHECK(has(folder.read("out/equilibrium.csv"), "\nM,loads,0,0,"));
    for (const char* const absent : {"probes.csv", "cuts.csv", "stations.csv"})
        CHECK(!folder.has(std::string("out/") + absent));
    CHECK(cli_test::cremona(
              {"solve", bending, "--csv", folder.path("out"), "--json", "--at", "5,0.5", "--cut", "3.3,-1,3.3,1"})
              .status == 0);
    CHECK(has(folder.read("out/probes.csv"), "\nM,5,0.5,plate,"));
    CHECK(has(folder.read("out/cuts.csv"), "\nM,1,3.3,-1,3.3,1,0,"));
    CHECK(has(folder.read("out/stations.csv"), "case,cut,s [m],x [m],y [m],sx' [kN/m^2],"));
    CHECK(cli_test::cremona({"solve", bending, "--csv", folder.write("file", "")}).status == 2);
    CHECK(has(cli_test::cremona({"solve", bending, "--csv", folder.path("out"), "--unit", "length=mm"}).err,
              "--csv counts in the units of the file"));
}

TEST_CASE("Tables of a plane model have the units that are asked for")
{
    const Run run = cli_test::cremona({"solve", bending, "--at", "5,0.5", "--cut", "3.3,-1,3.3,1", "--unit",
                                       "stress=MPa,displacement=mm,length=cm,force=N,moment=kN*cm"});
    REQUIRE(run.status == 0);
    CHECK(has(run.out, "Units of the tables: cm, N, kN·cm, mm, MPa\n"));
    for (const char* const heading : {"ux [mm]", "sx [MPa]", "fx [N]", "x1 [cm]", "M [kN·cm]"})
        CHECK(has(run.out, heading));
    CHECK(has(run.out, "  C      -1500.00"));
    CHECK(has(run.out, "-0.0750000"));
    CHECK(has(run.out, "strain energy 7500 kN·cm"));
    CHECK(has(cli_test::cremona({"solve", bending, "--unit", "stress=m"}).err, "--unit stress"));
    for (const std::vector<std::string>& other :
         {std::vector<std::string>{"--trace", "1"}, {"--json"}, {"--analysis", "modal"}, {"--cycles", "1"}}) {
        std::vector<std::string> all{"solve", bending, "--unit", "length=mm"};
        all.insert(all.end(), other.begin(), other.end());
        CHECK(has(cli_test::cremona(all).err, "counts in the units of the file"));
    }
}

TEST_CASE("A plane model and what its cases do are told in sentences, the body once")
{
    const Run run = cli_test::cremona({"solve", "examples/dam.json", "--describe"});
    REQUIRE(run.status == 0);
    CHECK(cli_test::count(run.out, "region dam: 1003 m²") == 1);
    CHECK(has(run.out, "load case water"));
    CHECK(has(run.out, "load case weight"));
    CHECK(has(run.out, "σy: from "));
    CHECK(has(run.out, "uy: from "));
    CHECK(has(run.out, "reaction of Curve base: Rx = "));
    const Run one = cli_test::cremona({"solve", bending, "--describe", "--case", "M", "--at", "5,0.5", "--cut",
                                       "3.3,-1,3.3,1", "--unit", "stress=MPa", "--lang", "pt"});
    REQUIRE(one.status == 0);
    CHECK(has(one.out, "σx: de −0,15 MPa em (0; 1) a 0,15 MPa em (0; −1)\n"));
    CHECK(has(one.out, "em (5; 0,5): "));
    CHECK(json::parse(cli_test::cremona({"solve", bending, "--describe", "--json"}).out)["description"].is_string());
    CHECK(has(cli_test::cremona({"solve", bending, "--describe", "--json", "--full"}).err, "--describe and --full"));
}

TEST_CASE("Several forces of one case on a point are told as their sum")
{
    std::string text = text_of_source(bending);
    const std::string loads = R"("curves": [{"curve": "right")";
    REQUIRE(text.find(loads, text.find("load_cases")) != std::string::npos);
    text.insert(
        text.find(loads, text.find("load_cases")),
        R"("points": [{"point": "C", "fx": 3}, {"point": "B", "fy": 5}, {"point": "C", "fx": "4 kN", "fy": 2}], )");
    const Run run = cli_test::cremona({"render", "-", "--describe"}, text);
    CHECK(has(run.out, "C: fx = 7 kN\n"));
    CHECK(cli_test::count(run.out, "C: fx") == 1);
    CHECK(has(run.out, "C: fy = 2 kN\n"));
}

TEST_CASE("A modulus or a thickness that is next to nothing is told by its key")
{
    for (const std::string& key : {std::string(R"("E": )"), std::string(R"("thickness": )")}) {
        std::string text = text_of_source(bending);
        const std::size_t at = text.find(key) + key.size();
        text.replace(at, text.find_first_of(",}", at) - at, "1e-320");
        const Run run = cli_test::cremona({"solve", "-"}, text);
        CHECK(run.status == 2);
        CHECK(has(run.err, key.substr(1, key.size() - 4) + ": \"1e-320"));
        CHECK(has(run.err, "is beyond the range of numbers"));
    }
}

TEST_CASE(
    "A cut that goes far beyond the body has the forces of its part inside; one that rounding would move is refused")
{
    const auto forces = [](const std::string& cut) {
        const Run run = cli_test::cremona({"solve", bending, "--json", "--cut", cut});
        REQUIRE(run.status == 0);
        const json found = json::parse(run.out)["cases"]["M"]["cuts"][0];
        CHECK(found["stations"].size() > 1);
        return found["M"].get<double>();
    };
    CHECK(forces("3.3,-1e4,3.3,1e4") == doctest::Approx(100.0));
    CHECK(forces("3.3,-4e6,3.3,4e6") == doctest::Approx(100.0));
    for (const char* const cut : {"3.3,-1e9,3.3,1e9", "3.3,-1e300,3.3,1e300", "-1.7e308,0,1.7e308,0"})
        CHECK(has(cli_test::cremona({"solve", bending, "--cut", cut}).err, "so long beside the body"));
    CHECK(has(cli_test::cremona({"solve", bending, "--at", ""}).err, "found \"\"; wanted 2 numbers"));
}

TEST_CASE("What would change nothing in a picture of a plane model is refused by name")
{
    const Folder folder;
    const auto refused = [&](std::vector<std::string> more) {
        more.insert(more.begin(), {"render", "examples/dam.json", "-o", folder.path("x.svg")});
        const Run run = cli_test::cremona(more);
        CHECK(run.status == 2);
        return run.err;
    };
    CHECK(has(refused({"--range", "0,1"}), "--range needs --show bands:mises too"));
    CHECK(has(refused({"--read", "element"}), "--read needs --show bands:mises too"));
    CHECK(has(refused({"--magnify", "3"}), "--magnify needs --show deformed too"));
    CHECK(has(refused({"--step", "3", "--at", "0,1"}), "--step and --at contradict"));
    CHECK(has(refused({"--step", "3", "--cut", "0,0,1,1"}), "--step and --cut contradict"));
    CHECK(has(refused({"--show", "bands:sx,bands:sy"}), "bands:sy is the second of its kind"));
    CHECK(has(refused({"--analysis", "modal", "--range", "0,1"}), "--range"));
    CHECK(has(refused({"--analysis", "modal", "--read", "element"}), "--read"));
    CHECK(!folder.has("x.svg"));
}

TEST_CASE("A plane model without a load case says so, and a case that is called envelope is reached")
{
    json none = json::parse(text_of_source("examples/dam.json")), named = none;
    none["load_cases"] = json::array();
    none.erase("combinations");
    none.erase("expected");
    for (const std::vector<std::string>& how :
         {std::vector<std::string>{}, {"--describe"}, {"--describe", "--json"}, {"--time"}}) {
        std::vector<std::string> all{"solve", "-"};
        all.insert(all.end(), how.begin(), how.end());
        CHECK(has(cli_test::cremona(all, none.dump()).out, "The model has no load case."));
    }
    CHECK(has(cli_test::cremona({"solve", "-", "--cycles", "1"}, none.dump()).err, "the model has none"));
    named["load_cases"][0]["id"] = "envelope";
    named.erase("combinations");
    named.erase("expected");
    CHECK(has(cli_test::cremona({"solve", "-", "--case", "envelope"}, named.dump()).out, "Load case envelope"));
}

TEST_CASE("Displacements next to nothing are told as what they are")
{
    json tiny = json::parse(text_of_source("examples/dam.json"));
    tiny["combinations"] = {{{"id", "X"}, {"factors", {{"water", 1e-320}}}}};
    const Run run = cli_test::cremona({"solve", "-", "--describe", "--case", "X"}, tiny.dump());
    CHECK(run.status == 0);
    CHECK(has(run.out, "ux: from "));
}
