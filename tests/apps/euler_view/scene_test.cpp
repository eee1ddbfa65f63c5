// Golden pictures of solids, in space, in the plane and as polygons.
#include <doctest/doctest.h>

#include "apps/euler/view/draw/draw.h"
#include "apps/euler/view/planar/planar_shapes.h"
#include "apps/euler/view/pointers/pointer_drawing.h"
#include "apps/euler/view/polygons/plane_model.h"
#include "apps/euler/view/solid/solid_shapes.h"
#include "tests/apps/euler_view/example_solids.h"
#include "tests/golden/scene.h"
#include "topology/modeling/primitives.h"

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
    const PlanarMap map(subjects, outside);
    check(name, map.shapes(subjects, map.fitted(sheet), look), subjects, look);
}

void check_polygons(const std::string& name, const std::vector<Subject>& subjects, const Look& look = {})
{
    check(name, plane_model(subjects, fitted_plane_model(subjects, sheet), look), subjects, look);
}

/// Of the half-edge that a loop names.
void check_pointers(const std::string& name, const Made& made, topology::LoopId loop, const Look& look)
{
    const ui::Fonts fonts;
    const auto graph = topology::pointer_graph(made.solid(), made.solid().half_edge(loop));
    const PointerDrawing drawing(graph, made.subjects().front(), look, sheet, fonts);
    golden::check_scene(name, {.size = sheet, .background = background(look)},
                        [&](ui::Painter& painter) { drawing.draw(painter); });
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

TEST_CASE("The pointers of a half-edge of a cube: next, prev, mate, start, edge and loop, and those that lead back")
{
    const Made cube(example("cube"));
    check_pointers("pointers_half_edge", cube, cube.solid().outer(cube.face("f3")), {});
}

TEST_CASE("The pointers of a lone vertex's half-edge lead back to itself, on the projector")
{
    const Made point(example("cube", 1));
    check_pointers("pointers_lone", point, point.solid().outer(point.face("f1")), {.theme = ui::ThemeName::Projector});
}

TEST_CASE("MEF half done: the new edge has grown half its way, the new face is half there, the rest is pale")
{
    const Made cube(example("cube", 11));
    check_in_space("step_mef_half", cube.subjects(marks_of(cube.last_change(), 0.5)));
}

TEST_CASE("MEV three quarters done on dark ground: the new vertex is on its way from the old one")
{
    const Made cube(example("cube", 8));
    check_in_space("step_mev", cube.subjects(marks_of(cube.last_change(), 0.75)), {.theme = ui::ThemeName::Dark});
}

TEST_CASE("KEF undoes MEF: a third on its way the edge shrinks and the face fades, in the colour of what goes")
{
    const Made cube(example("cube", 11));
    const Marks marks = marks_of(topology::reversed(cube.last_change()), 0.33);
    check_in_space("step_kef", cube.subjects(marks));
}

TEST_CASE("Only the corners that MEF takes are offered, on the projector; one is under the pointer")
{
    const Made cube(example("cube", 11));
    Marks marks;
    marks.legal.emplace();
    for (const auto h : cube.solid().chain(cube.solid().outer(cube.face("f1")))) marks.legal->push_back(h);
    marks.hovered = marks.legal->front();
    marks.selected = {cube.face("f1")};
    check_in_space("picks_offered", cube.subjects(marks), {.theme = ui::ThemeName::Projector});
}

TEST_CASE("A preview is dashed")
{
    const Made cube(example("cube", 12));
    Marks marks;
    marks.preview = cube.last_change().created;
    check_in_space("preview_mef", cube.subjects(marks), {.names = {EntityKind::Vertex}});
}

TEST_CASE("Two solids in print, with every kind of name")
{
    const Made two(example("tetrahedron") + "mvfs b g1 u1 1.4 0 0\n"
                                            "mev b g1 u1 u2 2.2 0 0\n"
                                            "mev b g1 u2 u3 2.2 1.2 0\n"
                                            "mvr b g1 u4 1.6 0.9 0\n");
    check_in_space(
        "solids_print", two.subjects(),
        {.names = {EntityKind::Vertex, EntityKind::Edge, EntityKind::HalfEdge, EntityKind::Loop, EntityKind::Face},
         .theme = ui::ThemeName::Print});
}

TEST_CASE("A closed edge on a lone vertex has a face inside and one outside")
{
    const Made made(example("torus", 2));
    check_in_space("solid_closed_edge", made.subjects(),
                   {.names = {EntityKind::Vertex, EntityKind::HalfEdge, EntityKind::Face}});
}

TEST_CASE("A torus by rotation on dark ground: its far side is seen from inside through the hole")
{
    topology::NamedSolid torus;
    topology::EulerOperator op(torus.solid, torus.journal);
    topology::add_torus(op, {.radius = 3.0, .tube = 1.1}, 16, 10);
    check_in_space("solid_torus", {{&torus.solid, &torus.names}}, {.half_edges = false, .theme = ui::ThemeName::Dark});
}

TEST_SUITE_END();
