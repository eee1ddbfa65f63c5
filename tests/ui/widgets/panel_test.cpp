#include "ui/widgets/panel.h"

#include "tests/ui/widget_stage.h"

#include <doctest/doctest.h>

#include <imgui.h>

TEST_SUITE_BEGIN("panel");

TEST_CASE("A message box is as high as what it holds, at every size of type")
{
    if (!ui_test::has_renderer()) return;
    ui_test::WidgetStage stage{1.0};
    for (const float scale : {0.8F, 1.0F, 1.1F, 1.3F, 1.45F, 1.6F, 2.0F}) {
        CAPTURE(scale);
        float hidden = 0.0F;
        for (int i = 0; i < 3; ++i)
            stage.frame({}, [&] {
                ImGui::GetIO().FontGlobalScale = scale;
                ui::begin_message_box({"a sentence"});
                ImGui::Button("Close");
                hidden = ImGui::GetScrollMaxY();
                ui::end_message_box();
            });
        CHECK(hidden == 0.0F);
    }
}

TEST_SUITE_END();
