#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "topology/halfedge/check/shells.h"
#include "topology/halfedge/check/validate.h"
#include "topology/script/script_fault.h"
#include "topology/script/script_runner.h"

using namespace topology;

namespace {

const std::string cube = "mvfs s1 f1 v1 0 0 0   # a cube of one unit\n"
                         "mev s1 f1 v1 v2 1 0 0\n"
                         "mev s1 f1 v2 v3 1 1 0\n"
                         "mev s1 f1 v3 v4 0 1 0\n"
                         "mef s1 f1 v1 v4 f2\n"
                         "mev s1 f1 v1 v5 0 0 1\n"
                         "mev s1 f1 v2 v6 1 0 1\n"
                         "mev s1 f1 v3 v7 1 1 1\n"
                         "mev s1 f1 v4 v8 0 1 1\n"
                         "mef s1 f1 v5 v8 f3\n"
                         "mef s1 f1 v8 v7 f4\n"
                         "mef s1 f1 v7 v6 f5\n"
                         "mef s1 f1 v6 v5>v8 f6\n";

ScriptRunner after(const std::string& text)
{
    ScriptRunner runner;
    run_script(runner, text, {});
    return runner;
}

/// The sentence that the script ends with, and that nothing was changed by its last line.
std::string refusal(const std::string& sound, const std::string& line)
{
    ScriptRunner runner = after(sound);
    std::vector<Solid> before;
    for (const NamedSolid& solid : runner.solids()) before.push_back(solid.solid);
    const std::size_t n_steps = runner.n_steps();
    std::string sentence = "nothing is refused";
    try {
        runner.run_line(line);
    } catch (const LineError& error) {
        sentence = error.what();
    }
    if (sentence == "nothing is refused") return sentence;
    CHECK(runner.n_steps() == n_steps);
    REQUIRE(runner.solids().size() == before.size());
    for (std::size_t i = 0; i < before.size(); ++i) CHECK(runner.solids()[i].solid == before[i]);
    return sentence;
}

EulerCounts counts(const std::string& text)
{
    const ScriptRunner runner = after(text);
    validate(runner.solids().front().solid);
    return euler_counts(runner.solids().front().solid);
}

} // namespace

TEST_SUITE("script")
{
    TEST_CASE("A cube is MVFS, seven MEV and five MEF")
    {
        CHECK(counts(cube) == EulerCounts{.V = 8, .E = 12, .F = 6, .L = 6, .S = 1, .G = 0});
        CHECK(after(cube).n_steps() == 13);
    }

    TEST_CASE("The same cube is a lamina and one sweep, which names what it makes")
    {
        const std::string swept = cube.substr(0, cube.find("mev s1 f1 v1 v5")) + "sweep s1 f1 0 0 1\n";
        CHECK(counts(swept) == EulerCounts{.V = 8, .E = 12, .F = 6, .L = 6, .S = 1, .G = 0});
        ScriptRunner runner = after(swept);
        CHECK(runner.n_steps() == 6);
        runner.run_line("kef s1 f1 v1' v4'"); // f1 is the moved face, and f1.v1.v4 dies
        CHECK(euler_counts(runner.solids().front().solid).F == 5);
        runner.run_line("undo 2");
        CHECK(euler_counts(runner.solids().front().solid).V == 4);
        runner.run_line("redo");
        CHECK(runner.solids().front().names.faces.find("f1.v1.v4", runner.solids().front().solid).has_value());
        runner.run_line("sweep s1 f1 0 0 1");
        CHECK(runner.solids().front().names.vertices.find("v1''", runner.solids().front().solid).has_value());
    }

    TEST_CASE("Undo and redo restore the solid, its names and its numbers")
    {
        ScriptRunner runner = after(cube);
        const Solid whole = runner.solids().front().solid;
        runner.run_line("undo 13");
        CHECK_FALSE(runner.solids().front().is_alive());
        runner.run_line("redo 13");
        CHECK(runner.solids().front().solid == whole);
        runner.run_line("undo");
        runner.run_line("mef s1 f1 v6 v5>v8 lid");
        CHECK(runner.solids().front().solid == whole);
        CHECK(refusal(cube, "undo 14") == "there are 13 steps to undo, not 14");
        CHECK(refusal(cube, "redo") == "there are 0 steps to redo, not 1");
    }

    TEST_CASE("A new step after an undo of everything begins another solid under the same number")
    {
        ScriptRunner runner = after("mvfs a f v 0 0 0\nundo\nmvfs b f v 1 1 1\n");
        REQUIRE(runner.solids().size() == 1);
        CHECK(runner.solids().front().name == "b");
    }

    TEST_CASE("Every inverse takes its operator back")
    {
        const std::string base = "mvfs s f1 v1 0 0 0\nmev s f1 v1 v2 1 0 0\nmev s f1 v2 v3 1 1 0\nmef s f1 v1 v3 f2\n";
        const EulerCounts before = counts(base);
        for (const char* pair :
             {"mev s f1 v1 x 9 9 9\nkev s v1 x", "semv s v1 v2 x 9 9 9\njekv s v1 x",
              "mef s f1 v1 v2 g\nkef s f1 v1 v2", "mvr s f1 x 9 9 9\nkvr s f1 x",
              "mvr s f1 x 9 9 9\nmekr s f1 v1 x\nkemr s f1 v1 x\nkvr s f1 x",
              "mvr s f1 x 9 9 9\nringmv s f1 x f2\nringmv s f2 x f1\nkvr s f1 x",
              "mvr s f1 x 9 9 9\nmfkrh s f1 x g\nkfmrh s f1 g\nkvr s f1 x", "mvfs s g x 9 9 9\nkvfs s g",
              "split s f1 f2 v1 v3 v2 x 9 9 9\nkev s v1 x", "move s v1 9 9 9\nmove s v1 0 0 0"}) {
            CAPTURE(std::string(pair));
            CHECK(counts(base + pair) == before);
        }
    }

    TEST_CASE(
        "A corner is a vertex, a half-edge, two half-edges or a number; one that fits several is refused with them")
    {
        const std::string strut = "mvfs s f v1 0 0 0\nmev s f v1 v2 1 0 0\nmev s f v1 v3 0 1 0\n";
        CHECK(refusal(strut, "mev s f v1 v4 2 2 2") ==
              "v1 fits several half-edges: v1>v2 (%1), v1>v3 (%3); name one of them by its number");
        CHECK(counts(strut + "mev s f v1>v3 v4 2 2 2").V == 4);
        CHECK(counts(strut + "mev s f v1>v2>v1 v4 2 2 2").V == 4);
        CHECK(counts(strut + "mev s f %3 v4 2 2 2").V == 4);
        CHECK(refusal(strut, "mev s f v2>v3 v4 2 2 2") == "there is no half-edge v2>v3 in face f");
        CHECK(refusal(strut, "mev s f %5 v4 2 2 2") == "there is no half-edge %5 in s");
        CHECK(refusal(strut, "mev s f %0 v4 2 2 2") == "there is no half-edge %0 in s");
        CHECK(refusal(strut, "kev s v2 %1") == "%1 does not start at v2");
        CHECK(refusal(strut, "mev s f v9 v4 2 2 2") == "there is no vertex v9 in s");
    }

    TEST_CASE("A line that cannot be run says why, with its number and its words")
    {
        ScriptRunner runner;
        try {
            run_script(runner, cube + "\n  mef s1 f1  v1 v5 f9 # no\n", {});
            FAIL("v1 is no corner of f1");
        } catch (const LineError& error) {
            CHECK(std::string(error.what()) == "line 15: mef s1 f1  v1 v5 f9: v1 is not in face f1");
        }
        CHECK(runner.n_steps() == 13);
    }

    TEST_CASE("Bad lines are refused and change nothing")
    {
        CHECK(refusal(cube, "mfe s1 f1") == "there is no operator mfe");
        CHECK(refusal(cube, "MVFS s1 f1") == "operators are written in small letters: mvfs");
        CHECK(refusal(cube, "mef s1 f1 v1 v4") == "mef is written: mef S F C1 C3 F2");
        CHECK(refusal(cube, "mef s2 f1 v1 v4 f9") == "there is no solid s2");
        CHECK(refusal(cube, "mef s1 f2 v1 v3 f3") == "the name f3 is in use in s1; choose another");
        CHECK(refusal(cube, "mev s1 f2 v1 v8 0 0 0") == "the name v8 is in use in s1; choose another");
        CHECK(refusal(cube, "mev s1 f2 v1 8v 0 0 0") == "\"8v\" is no name; begin with a letter and leave out > % #");
        CHECK(refusal(cube, "mev s1 f2 v1 a>b 0 0 0") == "\"a>b\" is no name; begin with a letter and leave out > % #");
        CHECK(refusal(cube, "mev s1 f2 v1 v\xFFx 0 0 0").find("is no name") != std::string::npos);
        CHECK(refusal(cube, "mev s1 f2 v1 v\xED\xA0\x80 0 0 0").find("is no name") != std::string::npos);
        CHECK(refusal(cube, "mev s1 f2 v1 \xC3\xA1pice\xE2\x82\xAC 0 0 0") == "nothing is refused");
        CHECK(refusal(cube, "mev s1 f2 v1 v9 0 nan 0") == "\"nan\" is no finite number");
        CHECK(refusal(cube, "mev s1 f2 v1 v9 0 1e999 0") == "\"1e999\" is no finite number");
        CHECK(refusal(cube, "mev s1 f2 v1 v9 0 1,5 0") == "\"1,5\" is no finite number");
        CHECK(refusal(cube, "undo two") == "\"two\" is no whole number from 1 on");
        CHECK(refusal(cube, "kev s1 v1 v3") == "there is no edge between v1 and v3");
        CHECK(refusal(cube, "mev s1 f2 v2> w 0 0 0") ==
              "v2> is no corner: a name is missing beside >; write v1, v1>v2, v1>v2>v3 or a number %7");
        CHECK(refusal(cube, "mev s1 f2 >v2 w 0 0 0").starts_with(">v2 is no corner: "));
        CHECK(refusal(cube, "mev s1 f2 v1>>v2 w 0 0 0").starts_with("v1>>v2 is no corner: "));
        CHECK(refusal(cube, "kemr s1 f2 v2 v1") == "there is no half-edge v2>v1 in face f2");
        CHECK(refusal(cube, "kfmrh s1 f1 f1") == "f1 is given twice; two faces are needed");
        CHECK(refusal(cube, "kvr s1 f2 v1") == "v1 is no lone vertex of face f2");
        CHECK(refusal(cube, "kvfs s1") == "f1 is more than a lone vertex; take its edges and rings away first");
        CHECK(refusal(cube + "mvfs s1 g w 0 0 0\n", "kvfs s1") == "s1 has several shells; say which by its face");
        CHECK(refusal(cube + "move s1 v5 1e308 0 1\n", "sweep s1 f1 1e308 0 0") ==
              "v5 would move beyond the range of numbers");
    }

    TEST_CASE("A name is free again when its entity is gone, and a solid with its last shell")
    {
        CHECK(counts("mvfs s f v1 0 0 0\nmev s f v1 v2 1 0 0\nkev s v1 v2\nmev s f v1 v2 1 0 0\n").V == 2);
        const ScriptRunner runner = after("mvfs s f v 0 0 0\nkvfs s\nmvfs s f v 0 0 0\n");
        CHECK(runner.solids().size() == 2);
        CHECK(runner.solids().back().is_alive());
    }

    TEST_CASE("Comments, blank lines, tabs, Windows line ends and a missing last line end are read")
    {
        CHECK(counts("\xEF\xBB\xBF# a cube\r\n\r\n\tmvfs s1 f.1 v1 0 0 0").V == 1);
    }

    TEST_CASE("A star of 60 000 edges whose corners are named by both ends is drawn and taken down in a second or so")
    {
        std::string text = "mvfs s f c 0 0 0\nmev s f c v0 1 2 3\n";
        constexpr int n = 60000;
        for (int i = 1; i < n; ++i)
            text += "mev s f c>v" + std::to_string(i - 1) + " v" + std::to_string(i) + " 1 2 3\n";
        for (int i = 0; i < n; ++i) text += "kev s c v" + std::to_string(i) + "\n";
        CHECK(after(text).solids().front().solid.counts().vertices == 1);
    }

    TEST_CASE("A script of 200 000 lines takes a second or so, not a minute")
    {
        std::string text = "mvfs s f v0 0 0 0\n";
        for (int i = 1; i < 200000; ++i)
            text += "mev s f v" + std::to_string(i - 1) + " v" + std::to_string(i) + " 1 2 3\n";
        CHECK(after(text).n_steps() == 200000);
    }
}
