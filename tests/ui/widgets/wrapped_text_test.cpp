#include "ui/widgets/wrapped_text.h"

#include "tests/ui/widget_stage.h"

#include <doctest/doctest.h>

#include <string>

TEST_SUITE_BEGIN("wrapped text");

// Dear ImGui ends the program where a draw list gets more vertices than it can count.
TEST_CASE("A line of any length is shown, and as much of a text of any length as there is room for")
{
    if (!ui_test::has_renderer()) return;
    const std::string line(20'000, 'W');
    std::string lines;
    for (int i = 0; i < 4000; ++i) lines += "a line\n";
    for (const std::string& text : {line, lines, lines + line}) {
        ui_test::WidgetStage stage{1.0};
        for (int i = 0; i < 3; ++i)
            stage.frame({}, [&] {
                ui::wrapped_text(text);
                ImGui::SetScrollY(ImGui::GetScrollMaxY());
            });
        CHECK(stage.context.pixels().size.width == 300);
    }
}

TEST_CASE("Lines lie one under the other as in one piece, and what follows at the usual distance")
{
    if (!ui_test::has_renderer()) return;
    ui_test::WidgetStage stage{1.0};
    float in_pieces = 0.0F, in_one = 0.0F;
    stage.frame({}, [&] {
        const float top = ImGui::GetCursorPosY();
        ui::wrapped_text("one\n\ntwo\nthree\n");
        const float middle = ImGui::GetCursorPosY();
        ImGui::TextUnformatted("one\n\ntwo\nthree\n");
        in_pieces = middle - top;
        in_one = ImGui::GetCursorPosY() - middle;
    });
    CHECK(in_pieces > 0.0F);
    CHECK(in_pieces == in_one);
}

TEST_SUITE_END();
