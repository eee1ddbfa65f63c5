// Trusses beside their Cremona diagrams.
#include "apps/drawing/truss/cremona_picture.h"

#include <doctest/doctest.h>

#include "apps/drawing/draw.h"
#include "femoop/analysis/linear_static.h"
#include "tests/apps/drawing/view_model.h"
#include "tests/golden/scene.h"

using namespace drawing;

namespace {

CremonaPicture diagram_of(const femoop::Model& model, const ui::Catalogue& tr = {})
{
    return cremona_picture(model, femoop::truss::truss_of(model, femoop::analyse(model), femoop::CaseId(0)), tr);
}

DrawOptions shown_beside(ui::ThemeName theme = ui::ThemeName::Light)
{
    DrawOptions options;
    options.theme = theme;
    options.show = {Show::Values, Show::NodeNames, Show::Legend, Show::Cremona};
    return options;
}

void draw_truss_and_diagram(ui::Painter& painter, const femoop::Model& model, const CremonaPicture& picture,
                            const DrawOptions& options)
{
    const femoop::Results results = femoop::analyse(model);
    draw(painter, {.model = model, .results = &results, .cremona = &picture}, options);
}

} // namespace

TEST_CASE("The pointer on the middle of a side means its bar, on a point that many share one of them, and beside none")
{
    const femoop::Model model = view_test::example("truss");
    const CremonaPicture picture = diagram_of(model);
    const DiagramPlan plan = plan_of(picture.diagram, {{0.0, 0.0}, {400.0, 400.0}}, ui::Theme(ui::ThemeName::Light));
    for (std::size_t i = 0; i < picture.truss.bars.size(); ++i) {
        const auto& [left, right] = picture.diagram.bar_spaces[i];
        const ui::Point middle = 0.5 * (plan(picture.diagram[left].point) + plan(picture.diagram[right].point));
        CHECK(side_at(picture, plan, middle, 5.0) == femoop::MemberId(i));
    }
    CHECK(!side_at(picture, plan, {2.0, 2.0}, 5.0));
}

TEST_CASE("Each bar is found at one stage of the diagram, and at the first none")
{
    const femoop::Model model = view_test::example("pratt_truss");
    CremonaPicture picture = diagram_of(model);
    for (std::size_t i = 0; i < picture.truss.bars.size(); ++i) CHECK(picture.is_found(femoop::MemberId(i)));
    picture.n_stages = 1;
    for (std::size_t i = 0; i < picture.truss.bars.size(); ++i) CHECK(!picture.is_found(femoop::MemberId(i)));
    CHECK(picture.is_known(femoop::truss::SpaceId(0)));
    CHECK(picture.sentences.size() == picture.diagram.steps.size());
}

TEST_SUITE("Cremona diagrams")
{
    TEST_CASE("cremona_pratt: a Pratt truss beside its diagram")
    {
        const femoop::Model model = view_test::example("pratt_truss");
        const CremonaPicture picture = diagram_of(model);
        golden::check_scene(
            "cremona_pratt", {.size = {1280.0, 700.0}, .background = background(shown_beside())},
            [&](ui::Painter& painter) { draw_truss_and_diagram(painter, model, picture, shown_beside()); });
    }

    TEST_CASE("cremona_stage: a king-post truss half way, on the projector")
    {
        const femoop::Model model = view_test::example("truss");
        CremonaPicture picture = diagram_of(model);
        picture.n_stages = 2;
        const DrawOptions options = shown_beside(ui::ThemeName::Projector);
        golden::check_scene("cremona_stage", {.size = {1280.0, 700.0}, .background = background(options)},
                            [&](ui::Painter& painter) { draw_truss_and_diagram(painter, model, picture, options); });
    }
}
