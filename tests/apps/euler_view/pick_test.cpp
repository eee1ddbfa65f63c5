#include "apps/euler/view/pick.h"
#include "apps/euler/view/solid/solid_shapes.h"
#include "tests/apps/euler_view/example_solids.h"

#include <doctest/doctest.h>

using namespace euler;
using topology::EntityKind;
using view_test::example;
using view_test::Made;

TEST_SUITE_BEGIN("euler view: picking");

namespace {

constexpr ui::Size pick_sheet{640.0, 480.0};
const std::set<EntityKind> all{EntityKind::Vertex, EntityKind::HalfEdge, EntityKind::Edge, EntityKind::Face};

/// A solid on the sheet.
struct Seen {
    explicit Seen(std::string_view script, const Look& look = {}) : made(script), subjects(made.subjects())
    {
        camera.look(-0.95, 0.42);
        camera = fitted(camera, subjects, look, pick_sheet);
        shapes = solid_shapes(subjects, camera, look);
    }
    ui::Point at(std::string_view vertex) const
    {
        const topology::Point& p = made.solid().point(made.vertex(vertex));
        return camera.to_sheet({p.x, p.y, p.z});
    }
    std::optional<Part> picked(ui::Point p, const std::set<EntityKind>& kinds = all) const
    {
        return pick(shapes, subjects, {.at = p, .kinds = kinds});
    }
    std::optional<Part> corner(ui::Point p) const { return pick_corner(shapes, subjects, {.at = p, .kinds = {}}); }

    Made made;
    std::vector<Subject> subjects;
    ui::OrbitCamera camera;
    Shapes shapes;
};

} // namespace

TEST_CASE("At a vertex the vertex is picked, though edges, half-edges and faces lie there too")
{
    const Seen cube(example("cube"));
    for (const char* name : {"v1", "v2", "v3", "v4", "v5", "v6", "v7", "v8"}) {
        CAPTURE(name);
        CHECK(cube.picked(cube.at(name) + ui::Point{3.0, -2.0}) == Part{0, cube.made.vertex(name)});
    }
}

TEST_CASE("On an edge the edge is picked, a few pixels beside it the half-edge on that side, farther in the face")
{
    const Seen cube(example("cube"));
    const ui::Point a = cube.at("v4"), b = cube.at("v8"), middle = 0.5 * (a + b);
    const ui::Point left = ui::left_normal(ui::direction(b - a));
    const auto& solid = cube.made.solid();
    const auto h = topology::find_half_edge({solid, *cube.subjects[0].names, "s1"}, std::nullopt, "v4", "v8");
    CHECK(cube.picked(middle) == Part{0, *solid.edge(h)});
    CHECK(cube.picked(middle + 8.0 * left) == Part{0, h});
    CHECK(cube.picked(middle - 8.0 * left) == Part{0, solid.mate(h)});
    CHECK(cube.picked(middle + 60.0 * left) == Part{0, solid.face(h)});
}

TEST_CASE("Of two faces under the pointer the front one is picked")
{
    const Seen cube(example("cube"));
    const ui::Point middle = 0.25 * (cube.at("v5") + cube.at("v6") + cube.at("v7") + cube.at("v8"));
    CHECK(cube.picked(middle) == Part{0, cube.made.face("f1")});
}

TEST_CASE("What is not meant is not picked")
{
    const Seen cube(example("cube"));
    CHECK(cube.picked(cube.at("v8"), {EntityKind::Edge})->entity.kind == EntityKind::Edge);
    CHECK(cube.picked(cube.at("v8"), {EntityKind::Face})->entity.kind == EntityKind::Face);
    CHECK_FALSE(cube.picked({2.0, 2.0}));
}

TEST_CASE("Each corner of a vertex is picked inside its own face")
{
    const Seen cube(example("cube"));
    const auto& solid = cube.made.solid();
    for (const topology::HalfEdgeId h : solid.fan(cube.made.vertex("v8"))) {
        const std::string before = cube.subjects[0].names->vertices.of(solid.start(solid.prev(h)));
        const std::string after = cube.subjects[0].names->vertices.of(solid.end(h));
        const ui::Point v = cube.at("v8");
        const ui::Point between = ui::direction(ui::direction(cube.at(before) - v) + ui::direction(cube.at(after) - v));
        CAPTURE(before);
        CAPTURE(after);
        CHECK(cube.corner(v + 14.0 * between) == Part{0, h});
    }
}

TEST_CASE("The two sides of a strut's foot are two corners")
{
    const Seen cube(example("cube", 6));
    const auto& solid = cube.made.solid();
    const auto up = topology::find_half_edge({solid, *cube.subjects[0].names, "s1"}, std::nullopt, "v1", "v5");
    const ui::Point foot = cube.at("v1");
    const auto left = cube.corner(foot + ui::Point{-12.0, -6.0}), right = cube.corner(foot + ui::Point{12.0, -10.0});
    CHECK(left == Part{0, up});
    REQUIRE(right);
    CHECK(right != left);
    CHECK(solid.start(topology::HalfEdgeId{right->entity.index}) == cube.made.vertex("v1"));
}

TEST_CASE("A lone vertex's face, which has no area, is picked by its half-edge")
{
    const Seen point(example("cube", 1));
    const ui::Point beside = point.at("v1") + ui::Point{-18.0, 0.0};
    CHECK(point.picked(beside) == Part{0, topology::HalfEdgeId{0}});
    CHECK(point.picked(beside, {EntityKind::Face}) == Part{0, point.made.face("f1")});
}

TEST_CASE("In an exploded view faces are picked where they stand")
{
    const Look exploded{.explosion = 1.0};
    const Seen cube(example("cube"), exploded);
    for (const Shapes::Piece& piece : cube.shapes.pieces) {
        ui::Point middle;
        for (const ui::Point p : piece.area.front()) middle = middle + 0.25 * p;
        if (!piece.is_back)
            CHECK(cube.picked(middle, {EntityKind::Face}) == Part{0, cube.shapes.faces[piece.face].face});
    }
}

TEST_SUITE_END();
