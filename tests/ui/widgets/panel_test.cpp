#include "ui/widgets/panel.h"

#include "tests/ui/widget_stage.h"

#include <doctest/doctest.h>

#include <imgui.h>

TEST_SUITE_BEGIN("panel");

TEST_CASE(
    "A message at the window's foot is as high as what it holds, at every size of type, and leaves the rest alone")
{
    if (!ui_test::has_renderer()) return;
    ui_test::WidgetStage stage{1.0};
    const ui::FootMessage message{{"a sentence for two lines of this window"}, {"Close###close"}};
    for (const float scale : {0.8F, 1.0F, 1.1F, 1.3F}) {
        CAPTURE(scale);
        float hidden = 0.0F, body_ends = 0.0F, message_begins = 0.0F;
        for (int i = 0; i < 3; ++i)
            stage.frame({}, [&] {
                ImGui::GetIO().FontGlobalScale = scale;
                ui::begin_body(ui::height(message));
                body_ends = ImGui::GetWindowPos().y + ImGui::GetWindowHeight();
                ui::end_body();
                ui::show(message);
                ImGui::Begin("###message");
                hidden = ImGui::GetScrollMaxY();
                message_begins = ImGui::GetWindowPos().y;
                ImGui::End();
            });
        CHECK(hidden == 0.0F);
        CHECK(body_ends <= message_begins);
    }
}

TEST_SUITE_END();
