#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "tests/topology/halfedge/random_walk.h"
#include "topology/halfedge/check/likeness.h"
#include "topology/halfedge/check/shells.h"
#include "topology/halfedge/check/validate.h"
#include "topology/script/inverse.h"

using namespace topology;

namespace {

NamedSolid named(const RandomWalk& walk)
{
    NamedSolid in{.name = "s1", .solid = walk.solid, .journal = walk.journal, .names = {}};
    for (std::uint32_t v = 0; v < in.solid.vertices().n_rows(); ++v)
        in.names.vertices.give(VertexId{v}, table_name(VertexId{v}));
    for (std::uint32_t f = 0; f < in.solid.faces().n_rows(); ++f) in.names.faces.give(FaceId{f}, table_name(FaceId{f}));
    return in;
}

std::string joined(const std::vector<std::string>& lines)
{
    std::string text;
    for (const std::string& line : lines) text += line + "\n";
    return text;
}

} // namespace

TEST_SUITE("inverse lines")
{
    TEST_CASE("The inverse lines of any step can be run, and leave the solid as it was but for numbers")
    {
        for (unsigned seed = 1; seed <= 150; ++seed) {
            RandomWalk walk(seed);
            for (int i = 0; i < 30; ++i) {
                const Solid before = walk.solid;
                const OperatorKind kind = walk.step(1.3);
                const std::string lines = joined(inverse_lines(named(walk)));
                CAPTURE(seed);
                CAPTURE(i);
                CAPTURE(std::string(name(kind)));
                CAPTURE(lines);
                ScriptRunner runner;
                runner.add(named(walk));
                CHECK_NOTHROW(run_script(runner, lines, {}));
                const Solid& after = runner.solids().back().solid;
                CHECK(euler_counts(after) == euler_counts(before));
                CHECK_FALSE(why_not_valid(after));
                const HalfEdgeId first = walk.journal[walk.journal.n_done() - 1].first();
                const bool is_closed_edge = kind == OperatorKind::KEF && before.next(first) == first;
                if (!is_closed_edge) CHECK(are_alike(after, before, Likeness::Places));
            }
        }
    }
}
