// Golden pictures of solids, in space, in the plane and as polygons.
#include <doctest/doctest.h>

#include "apps/euler/view/draw/draw.h"
#include "apps/euler/view/planar/planar_shapes.h"
#include "apps/euler/view/polygons/plane_model.h"
#include "apps/euler/view/solid/solid_shapes.h"
#include "tests/apps/euler_view/example_solids.h"
#include "tests/golden/scene.h"

#include <functional>

using namespace euler;
using topology::EntityKind;
using view_test::example;
using view_test::Made;

TEST_SUITE_BEGIN("pictures");

namespace {

constexpr ui::Size sheet{900.0, 700.0};

void check(const std::string& name, const Shapes& shapes, const std::vector<Subject>& subjects, const Look& look)
{
    golden::check_scene(name, {.size = sheet, .background = background(look)},
                        [&](ui::Painter& painter) { draw(painter, shapes, subjects, look); });
}

/// From a corner where no edge covers another.
ui::OrbitCamera aside()
{
    ui::OrbitCamera camera;
    camera.look(-0.95, 0.42);
    return camera;
}

void check_in_space(const std::string& name, const std::vector<Subject>& subjects, const Look& look = {},
                    ui::OrbitCamera camera = aside())
{
    camera = fitted(camera, subjects, look, sheet);
    check(name, solid_shapes(subjects, camera, look), subjects, look);
}

void check_planar(const std::string& name, const std::vector<Subject>& subjects, const Look& look = {},
                  std::optional<Part> outside = std::nullopt)
{
    check(name, planar_shapes(subjects, fitted_planar(subjects, sheet, outside), look, outside), subjects, look);
}

void check_polygons(const std::string& name, const std::vector<Subject>& subjects, const Look& look = {})
{
    check(name, plane_model(subjects, fitted_plane_model(subjects, sheet), look), subjects, look);
}

} // namespace

TEST_CASE("A cube with its half-edges, each loop in the colour of its face")
{
    const Made cube(example("cube"));
    check_in_space("solid_cube", cube.subjects());
}

TEST_CASE("A cube under way: struts stand on a face of two sides")
{
    const Made cube(example("cube", 7));
    check_in_space("solid_struts", cube.subjects());
}

TEST_CASE("A lone vertex shows the half-edge around it")
{
    const Made point(example("cube", 1));
    check_in_space("solid_lone_vertex", point.subjects());
}

TEST_CASE("Hoffmann's figure on dark ground: a hole through the block and a void beside it")
{
    const Made block(example("hoffmann"));
    check_in_space("solid_hoffmann", block.subjects(), {.theme = ui::ThemeName::Dark});
}

TEST_CASE("A smallest torus: two closed edges at one vertex")
{
    const Made torus(example("torus"));
    check_in_space("solid_torus_closed_edges", torus.subjects(),
                   {.names = {EntityKind::Vertex, EntityKind::Edge, EntityKind::HalfEdge}});
}

TEST_CASE("An exploded block with a through hole")
{
    const Made block(example("through_hole"));
    check_in_space("solid_exploded", block.subjects(), {.explosion = 0.6});
}

TEST_CASE("Schlegel's drawing of a cube: one face is all around the others")
{
    const Made cube(example("cube"));
    check_planar("planar_cube", cube.subjects(), {}, Part{0, cube.face("f2")});
}

TEST_CASE("A block with a void in the plane: two shells side by side")
{
    const Made block(example("void"));
    check_planar("planar_void", block.subjects());
}

TEST_CASE("Struts, a closed edge, two edges between the same vertices, and rings, in the plane")
{
    const Made made("mvfs s1 f1 v1 0 0 0\n"
                    "mev s1 f1 v1 v2 4 0 0\n"
                    "mev s1 f1 v2 v3 4 3 0\n"
                    "mef s1 f1 v1 v3 f2\n"
                    "mev s1 f1 v2 v4 6 1 0\n"
                    "mef s1 f1 v1>v3 v3 f3\n"
                    "mvr s1 f2 w1 1 1 0\n"
                    "mev s1 f2 w1 w2 2 1 0\n");
    check_planar("planar_every_case", made.subjects(),
                 {.names = {EntityKind::Vertex, EntityKind::Face, EntityKind::Edge}});
}

TEST_CASE("A torus has no drawing in the plane, and a sentence says so")
{
    const Made torus(example("torus"));
    check_planar("planar_torus", torus.subjects());
}

TEST_CASE("The plane model of the smallest torus: one polygon whose opposite sides are one edge")
{
    const Made torus(example("torus"));
    check_polygons("polygons_torus", torus.subjects(),
                   {.names = {EntityKind::Vertex, EntityKind::Edge, EntityKind::HalfEdge, EntityKind::Face}});
}

TEST_CASE("The plane model of a block with a through hole: rings within their faces' polygons")
{
    const Made block(example("through_hole"));
    check_polygons("polygons_through_hole", block.subjects(),
                   {.names = {EntityKind::Vertex, EntityKind::Edge, EntityKind::Face}});
}

TEST_SUITE_END();
