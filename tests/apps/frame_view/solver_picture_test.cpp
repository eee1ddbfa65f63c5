// The solver at work: what each step shows, and how it looks.
#include <doctest/doctest.h>

#include <algorithm>

#include "apps/frame/view/solver/solver_picture.h"
#include "tests/apps/drawing/view_model.h"
#include "tests/golden/scene.h"

using namespace frame;
using femoop::Ordering;

namespace {

SolverLook look(ui::ThemeName theme, Ordering ordering, std::size_t step, ui::Language language = ui::Language::English)
{
    return {.theme = ui::Theme(theme), .tr = ui::Catalogue(language), .ordering = ordering, .step = step};
}

void check_picture(const std::string& name, const femoop::Model& model, ui::Size size, const SolverLook& look)
{
    const femoop::SolverTrace trace = femoop::trace_solver(model);
    golden::check_scene(name, {.size = size, .background = look.theme.background()},
                        [&](ui::Painter& painter) { draw_solver(painter, trace, look); });
}

view_test::Marks marks(const femoop::SolverTrace& trace, ui::Size size, const SolverLook& look, const ui::Fonts& fonts)
{
    ui::Painter painter(size, fonts);
    draw_solver(painter, trace, look);
    CHECK(painter.picture().n_refused() == 0);
    view_test::Marks marks(fonts);
    painter.picture().draw_on(marks);
    return marks;
}

} // namespace

TEST_SUITE("frame: the solver at work")
{
    TEST_CASE("A step of dissection: separators by number, the tree, the matrix, four factors")
    {
        check_picture("solver_dissection", view_test::example("storey_frame"), {1280.0, 800.0},
                      look(ui::ThemeName::Light, Ordering::NestedDissection, 14));
    }

    TEST_CASE("On a broad dark sheet the four pictures stand in a row")
    {
        check_picture("solver_row_dark", view_test::example("storey_frame"), {1280.0, 430.0},
                      look(ui::ThemeName::Dark, Ordering::CuthillMcKee, 7));
    }

    TEST_CASE("In Portuguese on a projector")
    {
        check_picture("solver_projector", view_test::example("pratt_truss"), {1280.0, 800.0},
                      look(ui::ThemeName::Projector, Ordering::MinimumDegree, 4, ui::Language::Portuguese));
    }

    TEST_CASE("In print entries differ without colour; in space too")
    {
        check_picture("solver_space_print", view_test::model("space"), {1280.0, 800.0},
                      look(ui::ThemeName::Print, Ordering::NestedDissection, 6));
    }

    TEST_CASE("Every step of every order is drawn on sheets of any shape, its words on the sheet")
    {
        const ui::Fonts fonts;
        for (const char* name : {"portal", "pratt_truss", "grillage", "storey_frame"}) {
            const femoop::SolverTrace trace = femoop::trace_solver(view_test::example(name));
            for (const Ordering ordering : femoop::all_orderings)
                for (std::size_t step = 0; step < trace.walk(ordering).fronts.size(); step += 3)
                    for (const ui::Size size :
                         {ui::Size{1280.0, 800.0}, ui::Size{1260.0, 380.0}, ui::Size{800.0, 900.0}}) {
                        const auto drawn = marks(trace, size, look(ui::ThemeName::Light, ordering, step), fonts);
                        CAPTURE(name);
                        CAPTURE(size.width);
                        for (const auto& text : drawn.texts) {
                            CAPTURE(text.words);
                            CHECK(ui::Box{{0.0, 0.0}, {size.width, size.height}}.grown(1.0).contains(text.box));
                        }
                    }
        }
    }

    TEST_CASE("Sheets as small as they may be, and steps beyond the last, are drawn all the same")
    {
        const ui::Fonts fonts;
        const femoop::SolverTrace trace = femoop::trace_solver(view_test::example("storey_frame"));
        marks(trace, {64.0, 64.0}, look(ui::ThemeName::Projector, Ordering::Natural, 2), fonts);
        const auto last = marks(trace, {1280.0, 800.0}, look(ui::ThemeName::Light, Ordering::Natural, 1000), fonts);
        CHECK(last.has_text("Eliminated: F5, A6, B6, C6, D6, E6, F6; left: –"));
    }

    TEST_CASE("Long names are cut short, and constraints are told of")
    {
        const ui::Fonts fonts;
        femoop::Model model = view_test::example("storey_frame");
        for (femoop::Node& node : model.nodes) node.id = "ação " + std::string(60, 'W') + node.id;
        for (femoop::Member& member : model.members) member.inextensible = true;
        const femoop::SolverTrace trace = femoop::trace_solver(model);
        for (const Ordering ordering : femoop::all_orderings) {
            const ui::Size size{1280.0, 800.0};
            const auto drawn = marks(trace, size, look(ui::ThemeName::Projector, ordering, 14), fonts);
            CHECK(drawn.has_text("756 entries of K, before constraints make unknowns follow others"));
            for (const auto& text : drawn.texts) {
                CAPTURE(text.words);
                CHECK(ui::Box{{0.0, 0.0}, {size.width, size.height}}.grown(1.0).contains(text.box));
            }
        }
    }

    TEST_CASE("A system that is too large, or has no unknowns, is told of in a sentence")
    {
        const ui::Fonts fonts;
        femoop::Model model = view_test::example("portal");
        for (femoop::Node& node : model.nodes) node.support = femoop::Support{.kind = femoop::SupportKind::Fixed};
        const SolverLook usual = look(ui::ThemeName::Light, Ordering::Natural, 0);
        const ui::Size size{1280.0, 800.0};
        CHECK(marks(femoop::trace_solver(model), size, usual, fonts)
                  .has_text("Every displacement is held by a support: there is nothing to eliminate."));
        femoop::SolverTrace large;
        large.walks.front().counts.n_unknowns = 401;
        CHECK(marks(large, size, usual, fonts)
                  .has_text("The system has 401 unknowns; the walk of the front is shown of 400 or fewer."));
    }
}
