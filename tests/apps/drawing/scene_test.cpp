// Golden pictures of the frame view: models, themes and languages.
#include <doctest/doctest.h>

#include "apps/drawing/draw.h"
#include "apps/drawing/reading.h"
#include "femoop/analysis/linear_static.h"
#include "femoop/typical/typical.h"
#include "tests/apps/drawing/view_model.h"
#include "tests/golden/scene.h"

using namespace drawing;

TEST_SUITE_BEGIN("pictures");

namespace {

DrawOptions shown(std::string_view list, ui::ThemeName theme = ui::ThemeName::Light)
{
    return {.show = parse_show(list), .theme = theme};
}

DrawOptions in_portuguese(DrawOptions options)
{
    options.tr = ui::Catalogue(ui::Language::Portuguese);
    options.numbers.mark = ui::DecimalMark::Comma;
    return options;
}

DrawOptions of_case(DrawOptions options, const femoop::Model& model, std::string_view name)
{
    options.load_case = model.find_case(name).value();
    return options;
}

void check_picture(const std::string& name, const femoop::Model& model, const DrawOptions& options, ui::Size size)
{
    const femoop::Results results = femoop::analyse(model);
    golden::check_scene(name, {.size = size, .background = background(options)}, [&](ui::Painter& painter) {
        draw(painter, {model, &results}, options);
    });
}

} // namespace

TEST_CASE("Portal: loads, reactions and diagrams on light ground")
{
    const auto model = view_test::example("portal");
    check_picture("frame_portal", model, of_case(shown("loads,reactions,labels,N,V,M"), model, "G"), {1200.0, 800.0});
}

TEST_CASE("Portal: a combination on dark ground in Portuguese, with the deformed shape")
{
    const auto model = view_test::example("portal");
    check_picture("frame_portal_combination", model,
                  of_case(in_portuguese(shown("loads,reactions,labels,M,deformed", ui::ThemeName::Dark)), model, "ULS"),
                  {1200.0, 900.0});
}

TEST_CASE("Continuous beam on the projector: shear and moment below one another")
{
    check_picture("frame_continuous_beam", view_test::example("continuous_beam"),
                  shown("loads,reactions,labels,V,M", ui::ThemeName::Projector), {1400.0, 1000.0});
}

TEST_CASE("Eight hundred members: small symbols, slim lines, and the numbers that have room")
{
    check_picture("frame_storeys", femoop::StoreyFrame{.bays = 12, .storeys = 32}.model(),
                  shown("loads,reactions,labels,M"), {1000.0, 800.0});
}

TEST_CASE("Gerber beam in print in Portuguese, moments on the compression side, with dimensions")
{
    DrawOptions options = in_portuguese(shown("loads,reactions,labels,M,dimensions", ui::ThemeName::Print));
    options.moment_side = MomentSide::Compression;
    check_picture("frame_gerber_beam", view_test::example("gerber_beam"), options, {1200.0, 600.0});
}

TEST_CASE("Pratt truss in Portuguese: bars as broad as their force is large")
{
    check_picture("frame_truss", view_test::example("pratt_truss"), in_portuguese(shown("loads,reactions,labels,N")),
                  {1300.0, 760.0});
}

TEST_CASE("Grillage seen from above at an angle")
{
    check_picture("frame_grillage", view_test::example("grillage"), shown("loads,reactions,labels,M"), {1300.0, 560.0});
}

TEST_CASE("Bent cantilever in space on dark ground: moments, torsion, deformed shape")
{
    check_picture("frame_bent_cantilever", view_test::example("bent_cantilever"),
                  shown("loads,reactions,labels,dimensions,M,T,deformed", ui::ThemeName::Dark), {1300.0, 860.0});
}

TEST_CASE("A crowded frame keeps all its values apart")
{
    check_picture("frame_crowded", view_test::model("crowded_frame"), shown("M,labels"), {1500.0, 950.0});
}

TEST_CASE("Loads of every kind on one structure, with dimensions")
{
    check_picture("frame_every_load", view_test::model("every_load"), shown("loads,labels,dimensions"),
                  {1400.0, 850.0});
}

TEST_CASE("Supports of every kind in print")
{
    check_picture("frame_supports", view_test::model("supports"), shown("loads,values,nodes", ui::ThemeName::Print),
                  {1600.0, 640.0});
}

TEST_CASE("Joints and special members: hinges, releases, springs, arms, foundation, local axes")
{
    check_picture("frame_joints", view_test::model("joints"), shown("labels,axes"), {1400.0, 560.0});
}

TEST_CASE("Supports and loads in space")
{
    check_picture("frame_space", view_test::model("space"), shown("loads,values,nodes,legend"), {1200.0, 760.0});
}

TEST_CASE("Three-hinged arch on the projector in Portuguese: no moment where the arch is funicular")
{
    check_picture("frame_arch", view_test::example("three_hinged_arch"),
                  in_portuguese(shown("loads,reactions,labels,N", ui::ThemeName::Projector)), {1500.0, 700.0});
}

TEST_CASE("Diagrams of any size lie whole in a fitted picture")
{
    const auto model = view_test::example("portal");
    const femoop::Results results = femoop::analyse(model);
    const DrawState state;
    const ui::Fonts fonts;
    for (const double factor : {0.2, 1.0, 2.5, 6.0}) {
        DrawOptions options = shown("loads,reactions,M,labels");
        options.diagram_factor = factor;
        ui::Painter painter({680.0, 740.0}, fonts);
        CHECK_MESSAGE(Subject({model, &results}, options, state).draw(painter).is_whole, factor);
    }
}

TEST_CASE("A picture whose loads reach below its legend is not whole")
{
    const auto model = view_test::example("portal");
    const femoop::Results results = femoop::analyse(model);
    DrawOptions options = shown("loads,N,V,M,labels,legend");
    options.layout = Layout::Overlay;
    const ui::Fonts fonts;
    const auto drawn_at = [&](const std::optional<Camera>& camera) {
        const DrawState state{.camera = camera};
        ui::Painter painter({680.0, 740.0}, fonts);
        return Subject({model, &results}, options, state).draw(painter);
    };
    const Subject::Picture fitted = drawn_at(std::nullopt);
    CHECK(fitted.is_whole);
    double highest = 740.0;
    for (const LoadMark& mark : fitted.grips.loads) highest = std::min(highest, mark.tip.y);
    Camera moved = fitted.plan.camera;
    std::get<ui::PlaneCamera>(moved).pan({0.0, fitted.legend_bottom - 3.0 - highest});
    CHECK(fitted.legend_bottom - 3.0 > fitted.plan.panels.front().box.min.y + 25.0); // not out of the panel
    CHECK(!drawn_at(moved).is_whole);
}

TEST_CASE("The section under the cursor is read")
{
    const auto model = view_test::example("portal");
    const femoop::Results results = femoop::analyse(model);
    const DrawOptions options = of_case(shown("M,labels"), model, "Q");
    golden::check_scene(
        "frame_reading", {.size = {900.0, 620.0}, .background = background(options)}, [&](ui::Painter& painter) {
            const DrawInput input{model, &results};
            const DrawState state;
            const Subject::Picture picture = Subject(input, options, state).draw(painter);
            draw_reading(painter, input, options,
                         {.plan = picture.plan, .cut = {femoop::MemberId{1}, 6.4}, .beside = {620.0, 260.0}});
        });
}

TEST_SUITE_END();
