// The states of the force method beside its steps.
#include "apps/frame/view/derivation/state_pictures.h"

#include <doctest/doctest.h>

#include <array>

#include "apps/drawing/draw.h"
#include "femoop/analysis/linear_static.h"
#include "femoop/methods/force_method/force_steps.h"
#include "tests/apps/drawing/view_model.h"
#include "tests/golden/scene.h"

using namespace frame;
using femoop::derivation::Step;
using femoop::derivation::StepKind;
using femoop::force_method::ForceMethod;

namespace {

ForceMethod solved_portal()
{
    const femoop::Model portal = view_test::example("portal");
    return femoop::force_method::solve(portal, femoop::analyse(portal), femoop::CaseId(0), {});
}

} // namespace

TEST_SUITE("frame: the states of the force method")
{
    TEST_CASE("A state under a couple, with its moments")
    {
        const ForceMethod method = solved_portal();
        const DrawOptions view;
        golden::check_scene("force_method_state", {.size = {300.0, 200.0}, .background = drawing::background(view)},
                            [&](ui::Painter& painter) {
                                draw_state(painter, method, 3, {view, Step()});
                            });
    }

    TEST_CASE("Where there is room all states stand side by side, each over its name and none on another")
    {
        const ForceMethod method = solved_portal();
        const DrawOptions view;
        const auto cells = state_cells(method, {700.0, 340.0}, {view, Step()});
        REQUIRE(cells.size() == 5);
        for (const StateCell& cell : cells) {
            CHECK_FALSE(cell.picture.overlaps(cell.name));
            for (const StateCell& other : cells)
                CHECK((other.state == cell.state || !other.picture.overlaps(cell.picture)));
        }
    }

    TEST_CASE("Where they would be too small to be read the state that the step speaks of stands alone")
    {
        const ForceMethod method = solved_portal();
        const DrawOptions view{.theme = ui::ThemeName::Projector};
        const auto state_beside = [&](const Step& step) {
            const auto cells = state_cells(method, {630.0, 300.0}, {view, step});
            REQUIRE(cells.size() == 1);
            return cells[0].state;
        };
        CHECK(state_beside({.kind = StepKind::Redundants}) == 0);
        CHECK(state_beside({.kind = StepKind::State, .state = 2}) == 2);
        CHECK(state_beside({.kind = StepKind::Flexibility, .state = 1}) == 1);
        CHECK(state_beside({.kind = StepKind::StateSuperposition}) == 4);
    }

    TEST_CASE("The states of a frame in space need more room each: 450 x 240 is enough for one of them, not for three")
    {
        const femoop::Model frame = view_test::model("space");
        const femoop::Results results = femoop::analyse(frame);
        const femoop::MovingEffect fz{
            .quantity = femoop::ExpectedQuantity::Reaction, .node = frame.find_node("uz"), .dof = femoop::Dof::uz};
        const std::vector<femoop::MovingEffect> redundants{fz};
        const ForceMethod method = femoop::force_method::solve(frame, results, femoop::CaseId(0), redundants);
        const DrawOptions view;
        const Step step{.kind = StepKind::State, .state = 1};
        const auto cells = state_cells(method, {450.0, 240.0}, {view, step});
        REQUIRE(cells.size() == 1);
        CHECK(cells[0].state == 1);
        CHECK(state_cells(method, {2600.0, 1500.0}, {view, step}).size() == method.n_redundants() + 2);
    }
}
