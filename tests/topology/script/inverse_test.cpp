#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "tests/topology/halfedge/random_walk.h"
#include "topology/halfedge/check/isomorphism.h"
#include "topology/halfedge/check/shells.h"
#include "topology/halfedge/check/validate.h"
#include "topology/script/inverse.h"
#include "topology/script/wording.h"

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

/// The names along a loop, from the first of them in the alphabet.
std::string names_along(const NamedSolid& in, LoopId loop)
{
    std::vector<std::string> names;
    for (const HalfEdgeId h : in.solid.chain(loop)) names.push_back(in.names.vertices.of(in.solid.start(h)));
    std::vector<std::string> least = names;
    for (std::size_t i = 1; i < names.size(); ++i) {
        std::rotate(names.begin(), names.begin() + 1, names.end());
        least = std::min(least, names);
    }
    std::string text;
    for (const std::string& name : least) text += " " + name;
    return text;
}

/// Every face by its name, with the names along its loops, the outer one first.
std::vector<std::string> named_faces(const NamedSolid& in)
{
    std::vector<std::string> faces;
    for (const FaceId f : in.solid.faces()) {
        std::vector<std::string> loops;
        for (const LoopId l : in.solid.loops(f)) loops.push_back(names_along(in, l));
        std::sort(loops.begin() + 1, loops.end());
        faces.push_back(in.names.faces.of(f) + ":");
        for (const std::string& loop : loops) faces.back() += " |" + loop;
    }
    std::sort(faces.begin(), faces.end());
    return faces;
}

/// Every vertex by its name, with its place.
std::vector<std::string> named_places(const NamedSolid& in)
{
    std::vector<std::string> places;
    for (const VertexId v : in.solid.vertices())
        places.push_back(Wording(in.named()).vertex(v) + Wording(in.named()).point(in.solid.point(v)));
    std::sort(places.begin(), places.end());
    return places;
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
    TEST_CASE("The inverse lines of any step can be run and leave the solid and its names as they were but for numbers")
    {
        for (unsigned seed = 1; seed <= 150; ++seed) {
            RandomWalk walk(seed);
            for (int i = 0; i < 30; ++i) {
                const NamedSolid before = named(walk);
                const OperatorKind kind = walk.step(1.3);
                const std::string lines = joined(inverse_lines(named(walk)));
                CAPTURE(seed);
                CAPTURE(i);
                CAPTURE(std::string(name(kind)));
                CAPTURE(lines);
                ScriptRunner runner;
                runner.add(named(walk));
                CHECK_NOTHROW(run_script(runner, lines, {}));
                const NamedSolid& after = runner.solids().back();
                CHECK(euler_counts(after.solid) == euler_counts(before.solid));
                CHECK_FALSE(why_not_valid(after.solid));
                CHECK(are_alike(after.solid, before.solid, Isomorphism::Places));
                CHECK(named_faces(after) == named_faces(before));
                CHECK(named_places(after) == named_places(before));
            }
        }
    }
}
