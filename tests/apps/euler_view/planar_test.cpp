#include "apps/euler/view/planar/planar_shapes.h"
#include "apps/euler/view/polygons/plane_model.h"
#include "tests/apps/euler_view/example_solids.h"
#include "tests/topology/halfedge/random_walk.h"
#include "topology/halfedge/check/shells.h"

#include "topology/modeling/primitives.h"
#include "topology/script/script_runner.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>

using namespace euler;
using view_test::example;
using view_test::Made;

TEST_SUITE_BEGIN("euler view: plane");

namespace {

constexpr ui::Size planar_sheet{800.0, 600.0};
const topology::Names no_names;

Shapes in_plane(const std::vector<Subject>& subjects, std::optional<Part> outside = std::nullopt)
{
    const PlanarMap map(subjects, outside);
    return map.shapes(subjects, map.fitted(planar_sheet), {});
}

bool cross_inside(ui::Point a, ui::Point b, ui::Point c, ui::Point d)
{
    const auto side = [](ui::Point p, ui::Point q, ui::Point r) { return ui::cross(q - p, r - p); };
    return side(a, b, c) * side(a, b, d) < 0.0 && side(c, d, a) * side(c, d, b) < 0.0;
}

bool cross_anywhere(const std::vector<ui::Point>& one, const std::vector<ui::Point>& other)
{
    for (std::size_t i = 0; i + 1 < one.size(); ++i)
        for (std::size_t j = 0; j + 1 < other.size(); ++j)
            if (cross_inside(one[i], one[i + 1], other[j], other[j + 1])) return true;
    return false;
}

int n_crossings(const Shapes& shapes)
{
    int n = 0;
    for (std::size_t i = 0; i < shapes.edges.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            if (cross_anywhere(shapes.edges[i].line, shapes.edges[j].line)) ++n;
    return n;
}

/// A random solid whose shells have no handles.
topology::Solid random_sphere(std::uint32_t seed, int n_steps)
{
    RandomWalk walk(seed);
    for (int i = 0; i < n_steps; ++i) {
        walk.step(2.0);
        if (topology::euler_counts(walk.solid).G > 0) walk.op().undo();
    }
    return walk.solid;
}

} // namespace

TEST_CASE("In the plane no two edges of a random solid without handles cross, whatever its loops are")
{
    for (std::uint32_t seed = 1; seed <= 60; ++seed) {
        const topology::Solid solid = random_sphere(seed, 10 + static_cast<int>(seed) / 2);
        CAPTURE(seed);
        const Shapes shapes = in_plane({{&solid, &no_names}});
        CHECK(shapes.edges.size() == solid.edges().n_living());
        CHECK(shapes.sentences.empty());
        CHECK(n_crossings(shapes) == 0);
    }
}

namespace {

/// The solid before and after the last line of a script, each drawn in the plane.
struct StepInPlane {
    explicit StepInPlane(const std::string& script, const std::string& last)
    {
        topology::run_script(before, script, {});
        topology::run_script(after, script + last, {});
        for (const auto& [made, subjects] : {std::pair{&before, &old_subjects}, std::pair{&after, &new_subjects}})
            for (const topology::NamedSolid& in : made->solids()) subjects->push_back({&in.solid, &in.names});
        old_map = PlanarMap(old_subjects);
        new_map = PlanarMap(new_subjects);
    }

    /// Where the vertices of the new solid are, v1 under 1.
    std::map<std::uint32_t, ui::Point> at(double share) const
    {
        const PlanarMap map = new_map.on_its_way(new_subjects, old_map, old_subjects, share);
        return places(map.shapes(new_subjects, camera(), {}));
    }
    std::map<std::uint32_t, ui::Point> before_it() const { return places(old_map.shapes(old_subjects, camera(), {})); }
    static std::map<std::uint32_t, ui::Point> places(const Shapes& shapes)
    {
        std::map<std::uint32_t, ui::Point> found;
        for (const Shapes::Vertex& vertex : shapes.vertices) found[vertex.vertex.index + 1] = vertex.at;
        return found;
    }
    ui::OrbitCamera camera() const { return new_map.fitted(planar_sheet); }

    topology::ScriptRunner before, after;
    std::vector<Subject> old_subjects, new_subjects;
    PlanarMap old_map, new_map;
};

const std::string bottom = "mvfs s1 f1 v1 0 0 0\nmev s1 f1 v1 v2 0 1 0\nmev s1 f1 v2 v3 1 1 0\n"
                           "mev s1 f1 v3 v4 1 0 0\nmef s1 f1 v1 v4 f2\nmev s1 f1 v1 v5 0 0 1\n"
                           "mev s1 f1 v2 v6 0 1 1\nmev s1 f1 v3 v7 1 1 1\nmev s1 f1 v4 v8 1 0 1\n";

double farthest(const std::map<std::uint32_t, ui::Point>& a, const std::map<std::uint32_t, ui::Point>& b)
{
    double most = 0.0;
    for (const auto& [v, at] : a)
        if (const auto other = b.find(v); other != b.end()) most = std::max(most, ui::distance(at, other->second));
    return most;
}

} // namespace

TEST_CASE("A map on its way begins where the map before the step was, ends at its own, and never jumps between")
{
    const StepInPlane step(bottom, "mef s1 f1 v5 v8 f3\n");
    const auto before = step.before_it(), after = step.at(1.0);
    CHECK(farthest(before, after) > 20.0); // px: there is something to be seen
    CHECK(farthest(step.at(0.0), before) < 1e-9);
    CHECK(farthest(after, StepInPlane::places(step.new_map.shapes(step.new_subjects, step.camera(), {}))) < 1e-9);
    constexpr int n = 50;
    for (int i = 0; i < n; ++i)
        CHECK(farthest(step.at(double{1.0} * i / n), step.at(double{1.0} * (i + 1) / n)) < 20.0);
}

TEST_CASE("A new vertex comes out of the one that it hangs on, or out of the middle of the edge that it divides")
{
    const StepInPlane grown(bottom, "mev s1 f1 v5 v9 0 0 2\n");
    CHECK(ui::distance(grown.at(0.0).at(9), grown.at(0.0).at(5)) < 1e-9);
    CHECK(ui::distance(grown.at(1.0).at(9), grown.at(1.0).at(5)) > 10.0);
    const StepInPlane swept(bottom.substr(0, bottom.find("mev s1 f1 v1 v5")), "sweep s1 f1 0 0 1\n");
    const auto places = swept.at(0.0);
    REQUIRE(places.size() == 8);
    for (std::uint32_t v = 1; v <= 4; ++v) // each has one that comes out of it
        CHECK(std::ranges::count_if(places, [&](const auto& place) {
                  return place.first > 4 && ui::distance(place.second, places.at(v)) < 1e-9;
              }) == 1);
    const StepInPlane divided("mvfs s1 f1 v1 0 0 0\nmev s1 f1 v1 v2 0 1 0\nmev s1 f1 v2 v3 1 1 0\nmef s1 f1 v1 v3 f2\n",
                              "semv s1 v1 v2 v4 0 0.5 0\n");
    const auto at = divided.at(0.0);
    CHECK(ui::distance(at.at(4), 0.5 * (at.at(1) + at.at(2))) < 1e-9);
}

TEST_CASE("Where another face comes around the drawing the map is at home at once")
{
    const std::string square =
        "mvfs s1 f1 v1 0 0 0\nmev s1 f1 v1 v2 0 1 0\nmev s1 f1 v2 v3 1 1 0\nmev s1 f1 v3 v4 1 0 0\n";
    const StepInPlane step(square + "mef s1 f1 v1 v4 f2\n", "mev s1 f2 v1 v5 0.5 0.5 0\n");
    CHECK(farthest(step.at(0.0), step.at(1.0)) == 0.0);
}

TEST_CASE("Between the maps of random steps every place is a number")
{
    int n_moved = 0;
    for (std::uint32_t seed = 1; seed <= 40; ++seed) {
        CAPTURE(seed);
        const topology::Solid before = random_sphere(seed, 8 + static_cast<int>(seed) / 3),
                              after = random_sphere(seed, 9 + static_cast<int>(seed) / 3);
        const std::vector<Subject> old_subjects{{&before, &no_names}}, new_subjects{{&after, &no_names}};
        const PlanarMap old_map(old_subjects), new_map(new_subjects);
        const ui::OrbitCamera camera = new_map.fitted(planar_sheet);
        for (const double share : {0.0, 0.3, 0.7, 1.0}) {
            const PlanarMap map = new_map.on_its_way(new_subjects, old_map, old_subjects, share);
            const Shapes shapes = map.shapes(new_subjects, camera, {});
            CHECK(shapes.edges.size() == after.edges().n_living());
            for (const Shapes::Edge& edge : shapes.edges)
                for (const ui::Point p : edge.line) CHECK(std::isfinite(p.x + p.y));
            n_moved += static_cast<int>(shapes.edges.size());
        }
    }
    CHECK(n_moved > 100);
}

TEST_CASE("A face of thousands of sides lies in the plane at once, with room about it, and nothing crosses")
{
    constexpr int n = 2000;
    topology::NamedSolid made;
    topology::EulerOperator op(made.solid, made.journal);
    topology::add_prism(op, n, 1.0, 1.0);
    const auto begin = std::chrono::steady_clock::now();
    const Shapes shapes = in_plane({{&made.solid, &made.names}});
    CHECK(std::chrono::steady_clock::now() - begin < std::chrono::seconds(5)); // 0.1 s where nobody else is at work
    double least = 1e9;
    for (const Shapes::Edge& edge : shapes.edges) {
        REQUIRE(edge.line.size() == 2);
        least = std::min(least, ui::distance(edge.line.front(), edge.line.back()));
    }
    CHECK(least > 0.5); // [px]
}

TEST_CASE("A polyhedron's edges are straight in the plane, and the face outside is all around the others")
{
    const Made cube(example("cube"));
    const Shapes shapes = in_plane(cube.subjects(), Part{0, cube.face("f4")});
    CHECK(n_crossings(shapes) == 0);
    for (const Shapes::Edge& edge : shapes.edges) CHECK(edge.line.size() == 2);
    REQUIRE(shapes.pieces.size() == 6);
    for (const Shapes::Piece& piece : shapes.pieces) {
        CHECK_FALSE(piece.is_back);
        CHECK((piece.area.size() == 2) == (shapes.faces[piece.face].face == cube.face("f4")));
    }
}

TEST_CASE("Of a shell with a handle a sentence is left, the shells beside it are drawn")
{
    const Made block(example("hoffmann"));
    const Shapes shapes = in_plane(block.subjects());
    REQUIRE(shapes.sentences.size() == 1);
    CHECK(shapes.sentences.front().find("genus 1") != std::string::npos);
    CHECK(shapes.edges.size() == 12); // of the void
    CHECK(shapes.vertices.size() == 8);
}

TEST_CASE("The plane model has a side for every half-edge, two for every edge, and they run against each other")
{
    for (const char* name : {"cube", "torus", "through_hole", "hoffmann"}) {
        const Made made(example(name));
        const std::vector<Subject> subjects = made.subjects();
        const Shapes shapes = plane_model(subjects, fitted_plane_model(subjects, planar_sheet), {});
        CAPTURE(name);
        CHECK(shapes.arrows.size() == made.solid().half_edges().n_living());
        std::map<topology::EdgeId, int> n_sides;
        for (const Shapes::Edge& edge : shapes.edges) ++n_sides[edge.edge];
        CHECK(n_sides.size() == made.solid().edges().n_living());
        for (const auto& [edge, n] : n_sides) CHECK(n == 2);
        CHECK(shapes.pieces.size() == made.solid().faces().n_living());
    }
}

TEST_CASE("Random solids of every genus have a plane model on the sheet, without a place that is not finite")
{
    const ui::Box room{{0.0, 0.0}, {planar_sheet.width, planar_sheet.height}};
    for (std::uint32_t seed = 1; seed <= 40; ++seed) {
        RandomWalk walk(seed);
        for (std::uint32_t i = 0; i < 2 * seed; ++i) walk.step(2.0);
        const std::vector<Subject> subjects{{&walk.solid, &no_names}};
        const Shapes shapes = plane_model(subjects, fitted_plane_model(subjects, planar_sheet), {});
        CAPTURE(seed);
        for (const Shapes::Vertex& vertex : shapes.vertices) CHECK(room.contains(vertex.at));
        for (const Shapes::Arrow& arrow : shapes.arrows)
            for (const ui::Point p : arrow.line) CHECK(ui::is_finite(p));
    }
}

TEST_CASE("A step of the plane model begins where every side stood before it and ends where it stands after it")
{
    ui::PlaneCamera camera;
    for (std::uint32_t seed = 1; seed <= 60; ++seed) {
        RandomWalk walk(seed);
        for (std::uint32_t i = 0; i < 12 + seed % 20; ++i) walk.step(1.5);
        const topology::Solid before = walk.solid;
        walk.step(1.0);
        const std::vector<Subject> drawn{{&walk.solid, &no_names}}, other{{&before, &no_names}};
        const Shapes old = plane_model(other, camera, {}), now = plane_model(drawn, camera, {});
        const Shapes start = plane_model(drawn, camera, {}, {other, 0.0}),
                     end = plane_model(drawn, camera, {}, {other, 1.0});
        CAPTURE(seed);
        std::map<topology::HalfEdgeId, ui::Point> stood;
        for (std::size_t i = 0; i < old.arrows.size(); ++i) stood[old.arrows[i].half_edge] = old.vertices[i].at;
        for (std::size_t i = 0; i < start.arrows.size(); ++i) {
            const auto found = stood.find(start.arrows[i].half_edge);
            if (found != stood.end()) CHECK(ui::distance(start.vertices[i].at, found->second) < 1e-9);
            CHECK(ui::distance(end.vertices[i].at, now.vertices[i].at) < 1e-9);
            for (const ui::Point p : start.arrows[i].line) CHECK(ui::is_finite(p));
        }
    }
}

TEST_CASE("In the plane model MEF draws a chord before the polygon parts")
{
    topology::ScriptRunner runner;
    for (const char* line : {"mvfs s f a 0 0 0", "mev s f a b 1 0 0", "mev s f b c 1 1 0", "mev s f c d 0 1 0"})
        runner.run_line(line);
    const topology::Solid before = runner.solids().front().solid;
    runner.run_line("mef s f a d g");
    const topology::Solid& after = runner.solids().front().solid;
    const std::vector<Subject> drawn{{&after, &no_names}}, other{{&before, &no_names}};
    const Shapes start = plane_model(drawn, {}, {}, {other, 0.0});
    const topology::EdgeId made{3};
    std::vector<ui::Point> ends;
    for (const Shapes::Edge& edge : start.edges)
        if (edge.edge == made) {
            ends.push_back(edge.line.front());
            ends.push_back(edge.line.back());
        }
    REQUIRE(ends.size() == 4); // both sides of it, one against the other
    CHECK(ui::distance(ends[0], ends[3]) < 1e-9);
    CHECK(ui::distance(ends[1], ends[2]) < 1e-9);
    CHECK(ui::distance(ends[0], ends[1]) > 50.0);
}

TEST_SUITE_END();
