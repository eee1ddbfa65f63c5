#include <doctest/doctest.h>

#include <string>

#include "tests/topology/halfedge/random_walk.h"
#include "topology/halfedge/check/shells.h"
#include "topology/halfedge/check/validate.h"
#include "topology/script/script_fault.h"
#include "topology/script/script_writer.h"

using namespace topology;

TEST_SUITE("script writer")
{
    TEST_CASE("A journal written as a script makes the same solid again, row for row")
    {
        int n_written = 0;
        for (std::uint32_t seed = 1; seed <= 120; ++seed) {
            CAPTURE(seed);
            RandomWalk walk(seed);
            bool was_emptied = false; // a solid goes with its last shell; the next MVFS begins another
            for (int i = 0; i < 150; ++i) {
                walk.step(1.4);
                was_emptied = was_emptied || walk.solid.is_empty();
            }
            if (was_emptied) continue;
            ++n_written;
            const NamedSolid named{.name = "s1", .solid = walk.solid, .journal = walk.journal, .names = {}};
            const std::string script = journal_script(named);
            CAPTURE(script);
            ScriptRunner runner;
            try {
                run_script(runner, script, {});
            } catch (const LineError& error) {
                FAIL_CHECK(std::string(error.what()));
            }
            CHECK(runner.solids().front().solid == walk.solid);
        }
        CHECK(n_written > 40);
    }

    TEST_CASE("Any solid written as a construction script comes out again, under the same names")
    {
        for (std::uint32_t seed = 1; seed <= 60; ++seed) {
            CAPTURE(seed);
            RandomWalk walk(seed);
            for (int i = 0; i < 120; ++i) walk.step(1.9);
            const NamedSolid named{.name = "part", .solid = walk.solid, .journal = {}, .names = {}};
            const std::string script = construction_script(named);
            CAPTURE(script);
            ScriptRunner runner;
            try {
                run_script(runner, script, {});
            } catch (const LineError& error) {
                FAIL_CHECK(std::string(error.what()));
            }
            const NamedSolid& again = runner.solids().front();
            REQUIRE(again.name == "part");
            CHECK_NOTHROW(validate(again.solid));
            CHECK(euler_counts(again.solid) == euler_counts(walk.solid));
            for (const VertexId v : walk.solid.vertices()) {
                const auto same = again.names.vertices.find(named.names.vertices.of(v), again.solid);
                REQUIRE(same);
                CHECK(again.solid.point(*same) == walk.solid.point(v));
            }
            for (const FaceId f : walk.solid.faces())
                CHECK(again.names.faces.find(named.names.faces.of(f), again.solid));
        }
    }
}
