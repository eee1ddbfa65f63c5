// The window of the typical structures, played by scenarios.
#include "tests/apps/frame_window/played.h"

#include <doctest/doctest.h>

TEST_SUITE("frame window: typical structures")
{
    TEST_CASE("A structure is chosen by its picture and changed by a slider, and the document shows it at once")
    {
        check_window("window_typical", opened("examples/portal.json"), R"(
            key T
            wait 0.1
            click pixel 980 220
            drag pixel 1145 570 to pixel 1180 570
            hover pixel 600 700
            expect undo Insert: Gable frame
            expect member FG M at 0% is -47.47 kN·m
        )");
    }

    TEST_CASE("A truss takes the place of a frame, with its normal forces shown")
    {
        frame::Session session = opened("examples/portal.json");
        session.set_language(ui::Language::Portuguese);
        session.view.theme = ui::ThemeName::Projector;
        check_window("window_typical_truss", std::move(session), R"(
            command edit.template
            command template.choose howe
            command template.set panels 4
            command template.set span 12
            wait 0.1
            hover pixel 600 700
            expect member L0L1 N at 50% is 45 kN
        )");
    }

    TEST_CASE("A number that the structure cannot have stays in its field with what is wanted")
    {
        check_window("window_typical_wrong", opened("examples/truss.json"), R"(
            command view.theme.dark
            command edit.template
            command template.choose pratt
            wait 0.1
            click pixel 1235 546
            key Ctrl+A
            type "7"
            key Enter
            hover pixel 600 700
        )");
    }

    TEST_CASE("A choice that is too long for its row goes on in the next: no word is cut")
    {
        frame::Session session = opened("examples/portal.json");
        session.set_language(ui::Language::Portuguese);
        check_window("window_typical_choice", std::move(session), R"(
            command edit.template
            command template.choose arch
            command template.set hinges 2
            command template.replace
            wait 0.1
            hover pixel 600 700
        )");
    }

    TEST_CASE("Enter inserts, Escape takes back")
    {
        check_window("window_typical_inserted", opened("examples/portal.json"), R"(
            key T
            command template.choose beam
            command template.set spans 2
            wait 0.1
            key Enter
            wait 0.1
            expect undo Insert: Continuous beam
            key T
            command template.choose storeys
            wait 0.1
            key Esc
            wait 0.1
            expect undo Insert: Continuous beam
            command view.panel.history
        )");
    }
}
