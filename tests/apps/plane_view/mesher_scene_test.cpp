// Golden pictures of every mesher half way.
#include <doctest/doctest.h>

#include <string>

#include "apps/plane/discretize/mesh_player.h"
#include "tests/apps/plane_view/plate_subject.h"
#include "tests/golden/scene.h"

TEST_SUITE_BEGIN("pictures");

namespace {

/// A quarter of a ring of radii 20 and 60, or of the whole circle.
std::string quarter(const std::string& mesh, bool is_ring = true)
{
    const std::string inner = R"({"id": "inner", "kind": "arc", "center": "O", "points": ["C", "D"], "turn": "cw"}, )";
    return R"({"cremona": 1, "title": "A quarter of a ring", "analysis": "plane_stress",
        "units": {"length": "mm", "force": "N"}, "materials": [{"id": "m", "E": "200 GPa", "nu": 0.3}],
        "mesh": {"size": 5, )" +
           mesh + R"(}, "points": [{"id": "O", "at": [0, 0]}, {"id": "A", "at": [60, 0]}, {"id": "B", "at": [0, 60]},
        {"id": "C", "at": [0, 20]}, {"id": "D", "at": [20, 0]}], "curves": [)" +
           (is_ring ? inner : "") + R"({"id": "arc", "kind": "arc", "center": "O", "points": ["A", "B"]},
        {"id": "up", "kind": "line", "points": [")" +
           (is_ring ? "C" : "O") + R"(", "B"]}, {"id": "right", "kind": "line", "points": [")" + (is_ring ? "D" : "O") +
           R"(", "A"]}], "regions": [{"id": "ring", "at": [26, 26], "material": "m", "thickness": 1}]})";
}

/// The picture after so many hundredths of all steps.
void check_half_way(const std::string& name, const std::string& text, std::size_t hundredths,
                    ui::ThemeName theme = ui::ThemeName::Light, const ui::Catalogue& tr = {})
{
    const PlateSubject subject(text);
    plane::PlateInput input = subject.input();
    discretize::MeshPlayer player(*input.drawing);
    player.go_to(player.n_steps() * hundredths / 100);
    input.player = &player;
    plane::PlateOptions options{.show = {}, .theme = theme, .tr = tr};
    for (const char* const word : {"geometry", "regions", "mesh", "legend"})
        options.show = options.show | plane::plate_shown(word).value();
    golden::check_scene(name, {.size = {640.0, 560.0}, .background = plane::background(options)},
                        [&](ui::Painter& painter) { plane::draw(painter, input, options); });
}

} // namespace

TEST_CASE("Delaunay's mesher half way: a triangle with its circle, and what its new place makes anew")
{
    check_half_way("mesher_delaunay", quarter(R"("method": "delaunay", "element": "T3")"), 70);
}

TEST_CASE("The front half way, with its shortest side and the triangle that this got")
{
    check_half_way("mesher_front", quarter(R"("method": "front", "element": "T3")"), 48);
}

TEST_CASE("The quadtree half way, on the projector in Portuguese: a square is filled")
{
    check_half_way("mesher_quadtree", quarter(R"("method": "quadtree", "element": "T3")"), 75, ui::ThemeName::Projector,
                   ui::Catalogue(ui::Language::Portuguese));
}

TEST_CASE("Quadrilaterals half way: two triangles in one")
{
    check_half_way("mesher_quads", quarter(R"("method": "quads", "element": "Q4")"), 45);
}

TEST_CASE("A swept mesh half way: a row between the sides")
{
    check_half_way("mesher_sweep", quarter(R"("method": "sweep", "element": "Q4")"), 50);
}

TEST_CASE("A trilateral mesh half way")
{
    check_half_way("mesher_trilateral",
                   quarter(R"("method": "trilateral", "corners": ["O", "A", "B"], "element": "Q4")", false), 60);
}
