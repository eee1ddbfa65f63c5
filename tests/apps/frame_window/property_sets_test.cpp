// Materials and sections in the panel at the right, played by scenarios.
#include "tests/apps/frame_window/played.h"

#include <doctest/doctest.h>

TEST_SUITE("frame window: property sets")
{
    TEST_CASE("A new material of the selected member is renamed in the panel")
    {
        check_window("window_property_renamed", opened("examples/portal.json"), R"(
            click member BC 50%
            command edit.new_material
            wait 0.1
            click pixel 1120 92
            key Ctrl+A
            type "S355"
            key Enter
            hover pixel 600 700
            expect undo Rename: Material steel2
            expect selection Material S355
        )");
    }

    TEST_CASE("The list offers to add, import and condense, and says what was condensed")
    {
        frame::Session session = opened("examples/portal.json");
        session.set_language(ui::Language::Portuguese);
        check_window("window_property_condensed", std::move(session), R"(
            command edit.new_material
            command edit.deselect
            command edit.condense
            hover pixel 600 700
        )");
    }
}
