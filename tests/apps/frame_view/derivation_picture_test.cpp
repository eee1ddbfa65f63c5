// A step of the way to a number: how it looks, and that all of it is on the sheet.
#include "apps/frame/view/derivation/derivation_picture.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <vector>

#include "apps/drawing/results/diagram.h"
#include "femoop/analysis/linear_static.h"
#include "femoop/element/analysis_model.h"
#include "tests/apps/drawing/view_model.h"
#include "tests/golden/scene.h"
#include "ui/paint/text_measure.h"
#include "ui/text/language_manner.h"

using namespace frame;
using femoop::MemberComponent;
using femoop::derivation::Derivation;

namespace {

Derivation derived(const femoop::Model& model, const femoop::MovingEffect& effect, const std::string& load_case)
{
    return femoop::derivation::derive(model, femoop::analyse(model), model.find_case(load_case).value(), effect);
}

Derivation moment(const femoop::Model& model, const std::string& member, double x, const std::string& load_case)
{
    return derived(model,
                   {.member = model.find_member(member), .component = MemberComponent::Mz, .at = femoop::Quantity(x)},
                   load_case);
}

femoop::NodeId supported(const femoop::Model& model)
{
    const auto found = std::ranges::find_if(model.nodes,
                                            [](const femoop::Node& node) { return node.support.has_value(); });
    return femoop::NodeId(static_cast<std::size_t>(found - model.nodes.begin()));
}

DerivationLook look(ui::ThemeName theme, std::size_t step, ui::Language language = ui::Language::English)
{
    const ui::NumberFormat format{.digits = 4, .mark = ui::decimal_mark(language)};
    return {.theme = ui::Theme(theme),
            .tr = ui::Catalogue(language),
            .units = ui::DisplayUnits(ui::UnitSystem::KnM, {}, format),
            .step = step};
}

void check_picture(const std::string& name, const femoop::Model& model, const Derivation& derivation, ui::Size size,
                   const DerivationLook& look)
{
    golden::check_scene(name, {.size = size, .background = look.theme.background()},
                        [&](ui::Painter& painter) { draw_derivation(painter, derivation, model, look); });
}

} // namespace

TEST_SUITE("frame: where a number comes from")
{
    TEST_CASE("The member's k and its place in K, framed in the heat map")
    {
        const femoop::Model portal = view_test::example("portal");
        check_picture("derivation_place", portal, moment(portal, "BC", 3.0, "Q"), {1280.0, 380.0},
                      look(ui::ThemeName::Light, 3));
    }

    TEST_CASE("The equations of a portal, whole, dark")
    {
        const femoop::Model portal = view_test::example("portal");
        check_picture("derivation_equations_dark", portal, moment(portal, "AB", 0.0, "W"), {1280.0, 380.0},
                      look(ui::ThemeName::Dark, 7));
    }

    TEST_CASE("On a projector in Portuguese: the value by superposition")
    {
        const femoop::Model portal = view_test::example("portal");
        const Derivation derivation = moment(portal, "BC", 3.0, "Q");
        check_picture("derivation_projector_pt", portal, derivation, {1280.0, 420.0},
                      look(ui::ThemeName::Projector, derivation.steps.size() - 1, ui::Language::Portuguese));
    }

    TEST_CASE("The extreme of a combination stands beside the loads of its cases, each with its factor")
    {
        const femoop::Model portal = view_test::example("portal");
        const femoop::MovingEffect extreme{.quantity = femoop::ExpectedQuantity::Extreme,
                                           .member = portal.find_member("AB"),
                                           .component = MemberComponent::Mz};
        check_picture("derivation_extreme_combination", portal, derived(portal, extreme, "ULS"), {1280.0, 380.0},
                      look(ui::ThemeName::Light, 0));
    }

    TEST_CASE("In print and in a small window: a row of K of a larger frame")
    {
        const femoop::Model storeys = view_test::example("storey_frame");
        femoop::MovingEffect sway{.quantity = femoop::ExpectedQuantity::Displacement,
                                  .node = femoop::NodeId(storeys.nodes.size() - 1),
                                  .dof = femoop::Dof::ux};
        check_picture("derivation_row_print", storeys, derived(storeys, sway, storeys.load_cases[0].id), {880.0, 320.0},
                      look(ui::ThemeName::Print, 0));
    }

    TEST_CASE("The numbering as it is given and as the solver eliminates, on a projector in Portuguese")
    {
        const femoop::Model storeys = view_test::example("storey_frame");
        check_picture("derivation_numbering_projector_pt", storeys,
                      moment(storeys, storeys.members[0].id, 0.0, storeys.load_cases[0].id), {1280.0, 560.0},
                      look(ui::ThemeName::Projector, 4, ui::Language::Portuguese));
    }

    TEST_CASE("The displacements that inextensible members tie to one another")
    {
        const femoop::Model portal = view_test::example("portal_kleinlogel");
        check_picture("derivation_ties", portal, moment(portal, "AB", 2.0, "W"), {1280.0, 380.0},
                      look(ui::ThemeName::Light, 4));
    }

    TEST_CASE("No number of a step stands on another, nor on the heat map, however wide its matrix is")
    {
        const ui::Fonts fonts;
        for (const std::string name : {"bent_cantilever", "balcony", "portal_kleinlogel", "grillage"}) {
            const femoop::Model model = view_test::example(name);
            const Derivation derivation = moment(model, model.members[0].id, 0.5, model.load_cases[0].id);
            for (const ui::ThemeName theme : {ui::ThemeName::Light, ui::ThemeName::Projector})
                for (std::size_t step = 0; step < derivation.steps.size(); ++step)
                    for (const ui::Size room :
                         {ui::Size{1280.0, 300.0}, ui::Size{1260.0, 380.0}, ui::Size{700.0, 300.0}}) {
                        CAPTURE(name);
                        CAPTURE(step);
                        CAPTURE(room.width);
                        DerivationLook shown = look(theme, step);
                        shown.seen_height = room.height;
                        ui::Painter painter(sheet_for(derivation, model, shown, room, fonts), fonts);
                        draw_derivation(painter, derivation, model, shown);
                        const std::vector<ui::Box> boxes = painter.picture().text_boxes(fonts);
                        std::size_t n_overlaps = 0;
                        for (std::size_t i = 0; i < boxes.size(); ++i)
                            for (std::size_t j = 0; j < i; ++j)
                                n_overlaps += boxes[i].grown(-1.5).overlaps(boxes[j].grown(-1.5)) ? 1 : 0;
                        CHECK(n_overlaps == 0);
                    }
        }
    }

    TEST_CASE("Every step of every kind of number is drawn, its words on the sheet that it asks for")
    {
        const ui::Fonts fonts;
        for (const char* name :
             {"portal", "pratt_truss", "grillage", "storey_frame", "inclined_roller", "portal_kleinlogel"}) {
            const femoop::Model model = view_test::example(name);
            const MemberComponent component = femoop::is_truss(model.analysis) ? MemberComponent::N
                                                                               : MemberComponent::Mz;
            const std::vector<femoop::MovingEffect> effects{
                {.member = femoop::MemberId(0), .component = component, .at = femoop::Percent{30.0}},
                {.quantity = femoop::ExpectedQuantity::Extreme, .member = femoop::MemberId(0), .component = component},
                {.quantity = femoop::ExpectedQuantity::Displacement,
                 .node = femoop::NodeId(1),
                 .dof = femoop::model_dofs(model.analysis).front()},
                {.quantity = femoop::ExpectedQuantity::Reaction,
                 .node = supported(model),
                 .dof = femoop::model_dofs(model.analysis).front()}};
            for (const femoop::MovingEffect& effect : effects) {
                const Derivation derivation = derived(model, effect,
                                                      model.case_name(femoop::CaseId(model.n_cases() - 1)));
                for (std::size_t step = 0; step < derivation.steps.size(); ++step)
                    for (const ui::Size room : {ui::Size{1260.0, 380.0}, ui::Size{560.0, 260.0}}) {
                        const DerivationLook shown = look(ui::ThemeName::Projector, step);
                        const ui::Size sheet = sheet_for(derivation, model, shown, room, fonts);
                        ui::Painter painter(sheet, fonts);
                        draw_derivation(painter, derivation, model, shown);
                        CHECK(painter.picture().n_refused() == 0);
                        CAPTURE(name);
                        CAPTURE(step);
                        CAPTURE(room.width);
                        for (const ui::Box& box : painter.picture().text_boxes(fonts))
                            CHECK(painter.sheet().grown(2.0).contains(box));
                    }
            }
        }
    }
}
