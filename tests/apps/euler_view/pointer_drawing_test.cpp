#include "apps/euler/view/pointers/pointer_drawing.h"
#include "tests/apps/euler_view/example_solids.h"

#include <doctest/doctest.h>

#include <algorithm>

using namespace euler;
using view_test::example;
using view_test::Made;

TEST_SUITE_BEGIN("euler view: pointers");

namespace {

constexpr ui::Size pointer_sheet{900.0, 700.0};

} // namespace

TEST_CASE("Every entity of a pointer graph has a box of its own, and is picked there")
{
    const ui::Fonts fonts;
    const Made cube(example("cube"));
    const Subject subject = cube.subjects().front();
    for (const topology::HalfEdgeId h : cube.solid().half_edges()) {
        const auto graph = topology::pointer_graph(cube.solid(), h, 2);
        const PointerDrawing drawing(graph, subject, {}, pointer_sheet, fonts);
        REQUIRE(drawing.nodes().size() == graph.nodes.size());
        CAPTURE(h);
        CHECK(drawing.pick({0.5 * pointer_sheet.width, 0.5 * pointer_sheet.height}) == topology::Entity(h));
        for (const PointerDrawing::Node& node : drawing.nodes()) CHECK(drawing.pick(node.box.center()) == node.entity);
    }
}

TEST_CASE("Links of one entity to another are one arrow with all their names")
{
    const ui::Fonts fonts;
    const Made edge(example("cube", 2)); // one edge, whose halves are each other's next, prev and mate
    const auto graph = topology::pointer_graph(edge.solid(), topology::HalfEdgeId{0});
    const PointerDrawing drawing(graph, edge.subjects().front(), {}, pointer_sheet, fonts);
    const auto has = [&](const std::string& label) {
        return std::any_of(drawing.arrows().begin(), drawing.arrows().end(),
                           [&](const PointerDrawing::Arrow& arrow) { return arrow.label == label; });
    };
    CHECK(has("next, prev, mate"));
    CHECK(has("start"));
}

TEST_CASE("Every link has a name in Portuguese")
{
    const ui::Catalogue portuguese(ui::Language::Portuguese);
    const ui::Fonts fonts;
    const Made block(example("through_hole")); // a face of it has a ring
    const topology::Solid& solid = block.solid();
    const auto check = [&](topology::Entity entity) {
        for (const topology::Pointer& pointer : topology::pointers(solid, entity)) {
            CAPTURE(pointer.label);
            CHECK(portuguese.has(pointer.label));
        }
    };
    for (const auto h : solid.half_edges()) check(h);
    for (const auto f : solid.faces()) check(f);
    check(*solid.vertices().begin());
    check(*solid.edges().begin());
    check(*solid.loops().begin());
    const Made edge(example("cube", 2));
    const auto graph = topology::pointer_graph(edge.solid(), topology::HalfEdgeId{0});
    Look look;
    look.tr = portuguese;
    const PointerDrawing drawing(graph, edge.subjects().front(), look, pointer_sheet, fonts);
    CHECK(std::ranges::count(drawing.arrows(), "próxima, anterior, oposta", &PointerDrawing::Arrow::label) > 0);
}

TEST_SUITE_END();
