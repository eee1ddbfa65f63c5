// The window in which a section is made, played by scenarios.
#include "tests/apps/frame_window/played.h"

#include <doctest/doctest.h>

TEST_SUITE("frame window: sections")
{
    TEST_CASE("A shape is chosen and a dimension typed; picture, properties and diagrams follow")
    {
        check_window("window_section", opened("examples/portal.json"), R"(
            click member BC 50%
            key C
            wait 0.1
            click pixel 1120 148
            wait 0.1
            click pixel 1190 211
            key Ctrl+A
            type "400 mm"
            key Enter
            wait 0.1
            hover pixel 600 700
            expect undo Change section beam
        )");
    }

    TEST_CASE("A profile is found by a part of its name, in Portuguese on the projector")
    {
        frame::Session session = opened("examples/portal.json");
        session.set_language(ui::Language::Portuguese);
        session.view.theme = ui::ThemeName::Projector;
        check_window("window_section_profile", std::move(session), R"(
            command edit.new_section
            wait 0.1
            command section.profile UPN 200
            wait 0.1
            hover pixel 600 700
        )");
    }

    TEST_CASE("An angle shows its principal axes, in the dark")
    {
        check_window("window_section_angle", opened("examples/portal.json"), R"(
            command view.theme.dark
            click member AB 50%
            command edit.section
            command section.new
            command section.shape l
            wait 0.1
            hover pixel 600 700
            expect undo New section column2
        )");
    }

    TEST_CASE("A dimension that cannot be stays in its field with what is wanted")
    {
        check_window("window_section_wrong", opened("examples/portal.json"), R"(
            command edit.new_section
            command section.shape tube
            wait 0.1
            click pixel 1190 186
            key Ctrl+A
            type "20"
            key Enter
            hover pixel 600 700
        )");
    }
}
