#include "ui/widgets/offer.h"
#include "ui/widgets/panel.h"

#include "tests/ui/widget_stage.h"

#include <doctest/doctest.h>

#include <imgui.h>

#include <string>
#include <vector>

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

TEST_CASE("Both answers to what a linked program offers stand whole in the window, and the sentence beside them")
{
    if (!ui_test::has_renderer()) return;
    ui_test::WidgetStage stage{1.0};
    const ui::FootMessage offer = ui::offer_message("moment distribution has changed the structure", {});
    REQUIRE(offer.buttons.size() == 2);
    float beyond = 1.0F, hidden = 1.0F;
    for (int i = 0; i < 3; ++i)
        stage.frame({}, [&] {
            ui::show(offer);
            ImGui::Begin("###message");
            beyond = ImGui::GetScrollMaxX();
            hidden = ImGui::GetScrollMaxY();
            ImGui::End();
        });
    CHECK(beyond == 0.0F);
    CHECK(hidden == 0.0F);
    CHECK(ui::answer_of_button(0) == ui::Request::TakeOver);
    CHECK(ui::answer_of_button(1) == ui::Request::KeepAsItIs);
}

TEST_CASE("Menus that have no room in the window at the usual distance stand closer")
{
    if (!ui_test::has_renderer()) return;
    ui_test::WidgetStage stage{1.0};
    stage.frame({}, [] {
        const float usual = ImGui::GetStyle().ItemSpacing.x;
        CHECK(ui::spacing_of_menus({"File", "Edit"}) == usual);
        const std::vector<std::string> many(5, "Arquivo");
        const float words = 5.0F * ImGui::CalcTextSize("Arquivo").x, spacing = ui::spacing_of_menus(many);
        CHECK(words + 10.0F * usual > 300.0F);
        CHECK(words + 10.0F * spacing <= 300.0F);
    });
}

TEST_SUITE_END();
