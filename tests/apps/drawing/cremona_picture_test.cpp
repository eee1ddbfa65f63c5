// Trusses beside their Cremona diagrams.
#include "apps/drawing/truss/cremona_picture.h"

#include <doctest/doctest.h>

#include <set>

#include "apps/drawing/draw.h"
#include "apps/drawing/sheet/subject.h"
#include "apps/drawing/truss/joint_picture.h"
#include "femoop/analysis/linear_static.h"
#include "tests/apps/drawing/view_model.h"
#include "tests/golden/scene.h"

using namespace drawing;

namespace {

TrussPicture diagram_of(const femoop::Model& model, const ui::Catalogue& tr = {})
{
    return truss_picture(TrussMethod::Cremona, model,
                         femoop::truss::truss_of(model, femoop::analyse(model), femoop::CaseId(0)), tr);
}

DrawOptions shown_beside(ui::ThemeName theme = ui::ThemeName::Light)
{
    DrawOptions options;
    options.theme = theme;
    options.show = {Show::Values, Show::NodeNames, Show::Legend, Show::Truss};
    return options;
}

void draw_truss_and_diagram(ui::Painter& painter, const femoop::Model& model, const TrussPicture& picture,
                            const DrawOptions& options)
{
    const femoop::Results results = femoop::analyse(model);
    draw(painter, {.model = model, .results = &results, .truss = &picture}, options);
}

} // namespace

TEST_CASE("The pointer on the middle of a side means its bar, on a point that many share one of them, and beside none")
{
    const femoop::Model model = view_test::example("truss");
    const TrussPicture picture = diagram_of(model);
    const DiagramPlan plan = plan_of(*picture.diagram, {{0.0, 0.0}, {400.0, 400.0}}, ui::Theme(ui::ThemeName::Light));
    for (std::size_t i = 0; i < picture.truss.bars.size(); ++i) {
        const auto& [left, right] = picture.diagram->bar_spaces[i];
        const ui::Point middle = 0.5 * (plan((*picture.diagram)[left].point) + plan((*picture.diagram)[right].point));
        CHECK(side_at(picture, plan, middle, 5.0) == femoop::MemberId(i));
    }
    CHECK(!side_at(picture, plan, {2.0, 2.0}, 5.0));
}

TEST_CASE("At a stage of a diagram one bar is new, of joint by joint those of one joint, and at the end all are found")
{
    const femoop::Model model = view_test::example("pratt_truss");
    const femoop::truss::Truss truss = femoop::truss::truss_of(model, femoop::analyse(model), femoop::CaseId(0));
    for (const TrussMethod method : {TrussMethod::Joints, TrussMethod::Cremona}) {
        TrussPicture picture = truss_picture(method, model, truss, {});
        std::size_t n_found = 0;
        for (const TrussStage& stage : picture.stages) {
            n_found += stage.found.size();
            CHECK(stage.lit.size() <= (method == TrussMethod::Cremona ? 1U : 2U));
            CHECK(!stage.lines.empty());
        }
        CHECK(n_found == truss.bars.size());
        for (std::size_t i = 0; i < truss.bars.size(); ++i) CHECK(picture.is_found(femoop::MemberId(i)));
    }
}

TEST_CASE("The pointer on the stub of a bar, or on its side of the joint's polygon, means the bar")
{
    const femoop::Model model = view_test::example("truss");
    const femoop::truss::Truss truss = femoop::truss::truss_of(model, femoop::analyse(model), femoop::CaseId(0));
    TrussPicture picture = truss_picture(TrussMethod::Joints, model, truss, {});
    picture.n_stages = 2; // joint A: AC to the right, the support below
    const ui::Box panel{{0.0, 0.0}, {400.0, 640.0}};
    const ui::Theme theme(ui::ThemeName::Light);
    std::set<femoop::MemberId> meant;
    for (double x = 0.0; x < 400.0; x += 4.0)
        for (double y = 0.0; y < 640.0; y += 4.0)
            if (const auto bar = bar_of_joint_at(picture, panel, theme, {x, y}, 3.0)) meant.insert(*bar);
    CHECK(meant == std::set{*model.find_member("AC"), *model.find_member("AD")});
    CHECK(!bar_of_joint_at(picture, panel, theme, {2.0, 2.0}, 3.0));
}

TEST_CASE("Each bar is found at one stage of the diagram, and at the first none")
{
    const femoop::Model model = view_test::example("pratt_truss");
    TrussPicture picture = diagram_of(model);
    for (std::size_t i = 0; i < picture.truss.bars.size(); ++i) CHECK(picture.is_found(femoop::MemberId(i)));
    picture.n_stages = 1;
    for (std::size_t i = 0; i < picture.truss.bars.size(); ++i) CHECK(!picture.is_found(femoop::MemberId(i)));
    CHECK(picture.stages.size() == picture.diagram->steps.size());
}

TEST_CASE("Where a low sheet leaves a flat truss over its diagram no room it stands beside it, and is larger there")
{
    const femoop::Model model = view_test::example("pratt_truss");
    const TrussPicture picture = diagram_of(model);
    const femoop::Results results = femoop::analyse(model);
    const ui::Fonts fonts;
    const auto plan_on = [&](ui::Size sheet) {
        return Subject({.model = model, .results = &results, .truss = &picture}, shown_beside(), {}).plan(sheet, fonts);
    };
    const auto is_beside = [](const Subject::Plan& plan) {
        return plan.panels[0].box.min.y == plan.panels[1].box.min.y;
    };
    CHECK(is_beside(plan_on({405.0, 380.0})));
    CHECK_FALSE(is_beside(plan_on({900.0, 760.0})));
}

TEST_SUITE("Cremona diagrams")
{
    TEST_CASE("cremona_pratt: a Pratt truss beside its diagram")
    {
        const femoop::Model model = view_test::example("pratt_truss");
        const TrussPicture picture = diagram_of(model);
        golden::check_scene(
            "cremona_pratt", {.size = {1280.0, 700.0}, .background = background(shown_beside())},
            [&](ui::Painter& painter) { draw_truss_and_diagram(painter, model, picture, shown_beside()); });
    }

    TEST_CASE(
        "cremona_projector_pt: the same in Portuguese on the projector, where short bars leave the sense to line and hue")
    {
        const femoop::Model model = view_test::example("pratt_truss");
        DrawOptions options = shown_beside(ui::ThemeName::Projector);
        options.tr = ui::Catalogue(ui::Language::Portuguese);
        options.numbers.mark = ui::DecimalMark::Comma;
        const TrussPicture picture = diagram_of(model, options.tr);
        golden::check_scene("cremona_projector_pt", {.size = {1280.0, 700.0}, .background = background(options)},
                            [&](ui::Painter& painter) { draw_truss_and_diagram(painter, model, picture, options); });
    }

    TEST_CASE("cremona_stage: a king-post truss half way, on the projector")
    {
        const femoop::Model model = view_test::example("truss");
        TrussPicture picture = diagram_of(model);
        picture.n_stages = 3;
        const DrawOptions options = shown_beside(ui::ThemeName::Projector);
        golden::check_scene("cremona_stage", {.size = {1280.0, 700.0}, .background = background(options)},
                            [&](ui::Painter& painter) { draw_truss_and_diagram(painter, model, picture, options); });
    }
}
