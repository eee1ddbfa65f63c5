#include "apps/euler/view/draw/draw.h"
#include "apps/euler/view/solid/solid_shapes.h"
#include "tests/apps/euler_view/example_solids.h"
#include "tests/topology/halfedge/random_walk.h"

#include <doctest/doctest.h>

using namespace euler;
using topology::EntityKind;
using view_test::example;
using view_test::Made;

TEST_SUITE_BEGIN("euler view: drawing");

namespace {

constexpr ui::Size sheet{800.0, 600.0};
const Look everything{
    .names = {EntityKind::Vertex, EntityKind::Edge, EntityKind::HalfEdge, EntityKind::Loop, EntityKind::Face}};

ui::Picture in_space(const std::vector<Subject>& subjects, const Look& look, const ui::Fonts& fonts)
{
    ui::OrbitCamera camera;
    camera.look(-0.7, 0.5);
    camera = fitted(camera, subjects, look, sheet);
    return picture(solid_shapes(subjects, camera, look), subjects, look, sheet, fonts);
}

bool overlap_anywhere(const std::vector<ui::Box>& boxes)
{
    for (std::size_t i = 0; i < boxes.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            if (boxes[i].overlaps(boxes[j])) return true;
    return false;
}

topology::Solid random_solid(std::uint32_t seed, int n_steps)
{
    RandomWalk walk(seed);
    for (int i = 0; i < n_steps; ++i) walk.step(2.0);
    return walk.solid;
}

std::vector<topology::Entity> every_entity(const topology::Solid& solid)
{
    std::vector<topology::Entity> all;
    for (const auto v : solid.vertices()) all.push_back(v);
    for (const auto e : solid.edges()) all.push_back(e);
    for (const auto f : solid.faces()) all.push_back(f);
    for (const auto h : solid.half_edges()) all.push_back(h);
    for (const auto l : solid.loops()) all.push_back(l);
    return all;
}

} // namespace

TEST_CASE("No name lies on another, whatever is named")
{
    const ui::Fonts fonts;
    for (const char* name : {"cube", "tetrahedron", "through_hole", "hoffmann", "void", "torus"}) {
        const Made made(example(name));
        CAPTURE(name);
        CHECK_FALSE(overlap_anywhere(in_space(made.subjects(), everything, fonts).text_boxes(fonts)));
    }
}

TEST_CASE("What is said on the sheet stands in lines, whole")
{
    const ui::Fonts fonts;
    constexpr ui::Size narrow{280.0, 240.0};
    Shapes shapes;
    for (const ui::Language language : ui::all_languages) {
        CAPTURE(static_cast<int>(language));
        shapes.sentences = {
            ui::Catalogue(language)("A shell has genus {genus}: it cannot be drawn in the plane without "
                                    "crossings. Its plane model shows it.",
                                    {{"genus", "1"}})};
        const std::vector<ui::Box> lines = picture(shapes, {}, {}, narrow, fonts).text_boxes(fonts);
        CHECK(lines.size() > 1);
        CHECK_FALSE(overlap_anywhere(lines));
        for (const ui::Box& line : lines) CHECK(line.max.x <= narrow.width);
    }
}

TEST_CASE("Random solids of every topology are drawn without a place that is not finite")
{
    const ui::Fonts fonts;
    const topology::Names names;
    for (std::uint32_t seed = 1; seed <= 60; ++seed) {
        const topology::Solid solid = random_solid(seed, 1 + static_cast<int>(seed) * 2);
        CAPTURE(seed);
        for (const double explosion : {0.0, 0.7}) {
            Look look = everything;
            look.explosion = explosion;
            Marks marks;
            marks.created = every_entity(solid);
            marks.progress = 0.35;
            const ui::Picture drawn = in_space({{&solid, &names, marks}}, look, fonts);
            CHECK(drawn.n_refused() == 0);
            CHECK_FALSE(overlap_anywhere(drawn.text_boxes(fonts)));
        }
    }
}

TEST_CASE("A vertex without any edge, and no solid at all, have a picture")
{
    const ui::Fonts fonts;
    const Made point(example("cube", 1));
    CHECK(in_space(point.subjects(), {}, fonts).n_shapes() > 2);
    CHECK(in_space({}, {}, fonts).n_refused() == 0);
}

TEST_CASE("A new edge grows out of its old vertex: at the beginning the new vertex stands on the old one")
{
    const Made cube(example("cube", 6)); // its last operator made v5 over v1
    const auto place = [&](double progress, const char* vertex) {
        const Marks marks = marks_of(cube.last_change(), progress);
        const std::vector<Subject> subjects = cube.subjects(marks);
        const Shapes shapes = solid_shapes(subjects, fitted({}, subjects, {}, sheet), {});
        for (const Shapes::Vertex& shape : shapes.vertices)
            if (shape.vertex == cube.vertex(vertex)) return shape.at;
        return ui::Point{-1.0, -1.0};
    };
    CHECK(ui::distance(place(0.0, "v5"), place(0.0, "v1")) < 1e-9);
    CHECK(ui::distance(place(0.5, "v5"), 0.5 * (place(0.0, "v5") + place(1.0, "v5"))) < 1e-9);
    CHECK(ui::distance(place(1.0, "v5"), place(1.0, "v1")) > 50.0);
}

TEST_CASE("Steps that kill an edge are drawn on the solid before them, steps that make one on the solid after")
{
    const Made cube(example("cube"));
    topology::Change made = cube.last_change();
    CHECK_FALSE(is_drawn_before(made));
    CHECK(is_drawn_before(topology::reversed(made)));
}

TEST_SUITE_END();
