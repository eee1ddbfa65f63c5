#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "tests/apps/cli/run_cremona.h"

using cli_test::count;
using cli_test::cremona;
using cli_test::has;
using cli_test::Run;

namespace {

const std::string lamina = "mvfs s1 f1 v1 0 0 0\n"
                           "mev s1 f1 v1 v2 4 0 0 # a comment\n"
                           "\n"
                           "mev s1 f1 v2 v3 4 3 0\n"
                           "mef s1 f1 v1 v3 f2\n";

nlohmann::json solid_of(const Run& run, const std::string& name = "s1")
{
    REQUIRE_MESSAGE(run.status == 0, run.err);
    return nlohmann::json::parse(run.out)["solids"][name];
}

} // namespace

TEST_SUITE_BEGIN("cremona");

TEST_CASE("A script's solids are counted, validated, and the lengths of their loops sorted")
{
    const Run run = cremona({"euler", "-", "--json"}, lamina + "mvr s1 f2 w 1 1 0\nmvfs b g u 0 0 0\n");
    CHECK(
        run.out ==
        "{\"solids\": {\"s1\": {\"V\": 4, \"E\": 3, \"F\": 2, \"L\": "
        "3, \"S\": 1, \"G\": 0, \"euler\": 0, \"valid\": true, \"loops\": [1, 3, 3]}, \"b\": {\"V\": 1, \"E\": "
        "0, \"F\": 1, \"L\": 1, \"S\": 1, \"G\": 0, \"euler\": 0, \"valid\": true, \"loops\": [1]}}, \"steps\": 6}\n");
    CHECK(has(cremona({"euler", "-"}, lamina).out, "s1     3  3  2  2  1  0  0                   yes\n"));
    CHECK(has(cremona({"euler", "-", "--lang", "pt"}, lamina).out, "passos: 4\n"));
}

TEST_CASE("A ring outside the plane of its face is told on stderr, and the script goes on")
{
    const Run run = cremona({"euler", "-", "--json"}, lamina + "mvr s1 f2 w 3 1 0.5\n");
    CHECK(run.status == 0);
    CHECK(run.err == "mvr s1 f2 w 3 1 0.5: w lies outside the plane of face f2: "
                     "the links are right, but no flat face has such a ring.\n");
    CHECK(cremona({"euler", "-"}, lamina + "mvr s1 f2 w 3 1 0\n").err.empty());
}

TEST_CASE(
    "--tables prints each step's line and then the lecture's tables; --step runs the first lines that are operators")
{
    const Run run = cremona({"euler", "-", "--tables", "--step", "2"}, lamina);
    CHECK(run.out == "mvfs s1 f1 v1 0 0 0\n"
                     "V = 1 (H = 1) N = 0 P = 0\n"
                     "H = 1 (V = 1, E = 0, L = 1) N = 0 P = 0\n"
                     "E = 0 (H1 = 0, H2 = 0) N = 0 P = 0\n"
                     "L = 1 (H = 1, F = 1) N = 0 P = 0\n"
                     "F = 1 (S = 1, LOUT = 0 / LOOPS = 1) N = 0 P = 0\n"
                     "S = 1 (V = 1, F = 1, E = 0) N = 0 P = 0\n"
                     "\n"
                     "mev s1 f1 v1 v2 4 0 0\n"
                     "V = 1 (H = 1) N = 0 P = 2\n"
                     "V = 2 (H = 2) N = 1 P = 0\n"
                     "H = 1 (V = 1, E = 1, L = 1) N = 2 P = 2\n"
                     "H = 2 (V = 2, E = 1, L = 1) N = 1 P = 1\n"
                     "E = 1 (H1 = 2, H2 = 1) N = 0 P = 0\n"
                     "L = 1 (H = 2, F = 1) N = 0 P = 0\n"
                     "F = 1 (S = 1, LOUT = 0 / LOOPS = 1) N = 0 P = 0\n"
                     "S = 1 (V = 1, F = 1, E = 1) N = 0 P = 0\n");
    CHECK(nlohmann::json::parse(cremona({"euler", "-", "--json", "--step", "3"}, lamina).out)["steps"] == 3);
    CHECK(cremona({"euler", "-", "--json", "--step", "0"}, lamina).out == "{\"solids\": {}, \"steps\": 0}\n");
}

TEST_CASE("A line that cannot be run is told with its number, nothing is printed, and the status is 2")
{
    const Run run = cremona({"euler", "-", "--json"}, lamina + "mef s1 f1 v1 v9 f3\n");
    CHECK(run.status == 2);
    CHECK(run.out.empty());
    CHECK(run.err == "cremona euler: standard input: line 6: mef s1 f1 v1 v9 f3: there is no vertex v9 in s1\n");
    CHECK(has(cremona({"euler", "-", "--lang", "pt"}, lamina + "mef s1 f1 v1\n").err,
              "linha 6: mef s1 f1 v1: mef escreve-se: mef S F C1 C3 F2"));
    CHECK(cremona({"euler"}).status == 2);
    CHECK(has(cremona({"euler", "no-such.eul"}).err, "cannot read no-such.eul"));
    CHECK(
        has(cremona({"euler", "-", "--step", "-1"}, lamina).err, "--step: found \"-1\"; wanted a whole number from 0"));
    CHECK(has(cremona({"euler", "-", "--obj", "x.off"}, lamina).err, "--obj: x.off is no file of solids"));
}

TEST_CASE("A standard input that is closed is no empty script")
{
    const Run run = cli_test::shell("cremona euler - <&-");
    CHECK(run.status == 2);
    CHECK(run.out.empty());
    CHECK(has(run.err, "standard input cannot be read"));
}

TEST_CASE("A solid goes out as a script and as a mesh, and comes back the same from either")
{
    const Folder folder;
    for (const char* name : {"cube", "tetrahedron", "through_hole", "void", "hoffmann", "torus"}) {
        CAPTURE(std::string(name));
        const std::string script = "examples/" + std::string(name) + ".eul";
        const auto before = solid_of(
            cremona({"euler", script, "--json", "--to-script", folder.path("a.eul"), "--obj", folder.path("a.obj")}));
        CHECK(solid_of(cremona({"euler", folder.path("a.eul"), "--json"})) == before);
        CHECK(solid_of(cremona({"euler", "--from", script, "--json"})) == before);
        if (std::string(name) == "torus") continue; // its one polygon meets an edge twice the same way
        const auto mesh = solid_of(cremona({"euler", "--from", folder.path("a.obj"), "--json"}));
        CHECK(mesh["V"] == before["V"]);
        CHECK(mesh["G"] == before["G"]);
        CHECK(mesh["S"] == before["S"]);
        CHECK(mesh["valid"] == true);
        REQUIRE(cremona({"convert", folder.path("a.obj"), folder.path("a.off")}).status == 0);
        REQUIRE(cremona({"convert", folder.path("a.off"), folder.path("b.eul")}).status == 0);
        CHECK(solid_of(cremona({"euler", folder.path("b.eul"), "--json"})) == mesh);
    }
}

TEST_CASE("A script goes on with the solid of a mesh; a mesh that bounds no solid is refused with the place")
{
    const Folder folder;
    const std::string tetrahedron = "v 0 0 0\nv 3 0 0\nv 0 4 0\nv 0 0 5\nf 1 3 2\nf 1/1 2/2 4/4\nf 2 3 4\n";
    folder.write("t.obj", tetrahedron + "f -4 -1 -2\n");
    folder.write("more.eul", "semv s1 v1 v2 w 1 0 0\n");
    CHECK(solid_of(cremona({"euler", folder.path("more.eul"), "--from", folder.path("t.obj"), "--json"}))["V"] == 5);
    folder.write("open.obj", tetrahedron);
    CHECK(has(cremona({"euler", "--from", folder.path("open.obj")}).err,
              "open.obj: the surface is open at the edge from point "));
    folder.write("turned.obj", tetrahedron + "f 1 3 4\n");
    CHECK(has(cremona({"convert", folder.path("turned.obj"), folder.path("x.eul")}).err,
              "runs the same way in two faces"));
    folder.write("bad.obj", "v 0 0 0\nv 0 0 z\n");
    CHECK(has(cremona({"euler", "--from", folder.path("bad.obj")}).err,
              "bad.obj: line 2: v 0 0 z: \"z\" is no finite number"));
    folder.write("bad.off", "OFF\n4 4 0\n0 0 0\n");
    CHECK(has(cremona({"euler", "--from", folder.path("bad.off")}).err, "the file ends before the points and faces"));
    CHECK(has(cremona({"euler", "--from", "x.json"}).err, "--from: x.json is no file of solids"));
}

TEST_SUITE_END();
