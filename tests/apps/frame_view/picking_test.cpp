// What lies under the cursor.
#include <doctest/doctest.h>

#include "apps/frame/view/frame_view.h"
#include "apps/frame/view/pick.h"
#include "femoop/analysis/linear_static.h"
#include "tests/apps/frame_view/view_model.h"

using namespace frame;

TEST_SUITE_BEGIN("frame");

namespace {

constexpr double L = 8.0, q = 5.0;
const ui::PlaneCamera camera({100.0, 300.0}, 50.0); // the beam runs from (100, 300) to (500, 300)

struct Scene {
    femoop::Model model = view_test::simple_beam(L, q);
    femoop::Results results = femoop::analyse(model);
    ui::Fonts fonts;
    ui::Painter painter{{900.0, 600.0}, fonts};
    ViewOptions options{.show = {Show::Loads}, .camera = camera};

    std::optional<Picked> at(ui::Point cursor) const { return pick(model, &results, options, painter, cursor); }
};

} // namespace

TEST_CASE("Near a node the node is picked, beside it the member with the place along it")
{
    const Scene scene;
    CHECK(scene.at({503.0, 298.0}) == Picked(femoop::NodeId{1}));
    const auto member = scene.at({250.0, 304.0});
    REQUIRE(member);
    REQUIRE(std::holds_alternative<MemberPlace>(*member));
    CHECK(std::get<MemberPlace>(*member).x == doctest::Approx(3.0));
    CHECK(!scene.at({250.0, 340.0}));
}

TEST_CASE("Over a diagram a member is picked from farther off")
{
    Scene scene;
    scene.options.show = {Show::M};
    const auto member = scene.at({300.0, 340.0});
    REQUIRE(member);
    CHECK(std::get<MemberPlace>(*member).x == doctest::Approx(4.0));
}

TEST_CASE("A reading tells the section's forces with units")
{
    Scene scene;
    draw_reading(scene.painter, scene.model, scene.results, scene.options, {femoop::MemberId{}, 2.0}, {200.0, 310.0});
    view_test::Marks marks(scene.fonts);
    scene.painter.picture().draw_on(marks);
    CHECK(marks.has_text("2 m"));
    CHECK(marks.has_text("10 kN"));   // V = q (L / 2 - x)
    CHECK(marks.has_text("30 kN·m")); // M = q x (L - x) / 2
    for (const auto& text : marks.texts) CHECK(scene.painter.sheet().contains(text.box));
}

TEST_SUITE_END();
