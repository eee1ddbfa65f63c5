// Golden pictures of solids, in space, in the plane and as polygons.
#include <doctest/doctest.h>

#include "apps/euler/view/draw/draw.h"
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

TEST_SUITE_END();
