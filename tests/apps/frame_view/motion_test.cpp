// A structure that cannot be solved: its motions in words, and how they look.
#include <doctest/doctest.h>

#include "apps/drawing/draw.h"
#include "apps/frame/view/motion_words.h"
#include "femoop/analysis/linear_static.h"
#include "tests/apps/drawing/view_model.h"
#include "tests/golden/scene.h"

using namespace frame;

namespace {

std::string motion_sentence(const femoop::Model& model, std::size_t shown)
{
    try {
        femoop::analyse(model);
    } catch (const femoop::MechanismError& error) {
        return motion_choice(error.mechanisms(), shown, ui::Catalogue()).sentence;
    }
    return "solved";
}

} // namespace

TEST_SUITE("frame")
{

    TEST_CASE("Of several motions the sentence says which one is shown, of a single one it does not")
    {
        femoop::Model model = view_test::example("mechanism");
        CHECK(motion_sentence(model, 0).find("motion 1 of") == std::string::npos);
        model.nodes[3].support->kind = femoop::SupportKind::Roller; // the foot D slides as well
        CHECK(motion_sentence(model, 0).find("motion 1 of 2: ") == 0);
        CHECK(motion_sentence(model, 1).find("motion 2 of 2: ") == 0);
    }

    TEST_CASE("A mechanism moves and is named in Portuguese")
    {
        const auto model = view_test::example("mechanism");
        DrawOptions options{.show = parse_show("labels"), .tr = ui::Catalogue(ui::Language::Portuguese)};
        options.numbers.mark = ui::DecimalMark::Comma;
        try {
            femoop::analyse(model);
            FAIL("the mechanism was solved");
        } catch (const femoop::MechanismError& error) {
            golden::check_scene("frame_mechanism", {.size = {900.0, 600.0}, .background = background(options)},
                                [&](ui::Painter& painter) {
                                    const auto motion = motion_choice(error.mechanisms(), 0, options.tr);
                                    draw(painter, {.model = model, .motion = motion}, options);
                                });
        }
    }

} // TEST_SUITE
