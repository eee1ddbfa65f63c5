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
    const ui::FootMessage offer = ui::offer_message("Moment distribution has changed the structure", {});
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

TEST_CASE("Menus that have no room in the window at the usual distance stand closer, and in smaller type than crowded")
{
    if (!ui_test::has_renderer()) return;
    ui_test::WidgetStage stage{1.0};
    stage.frame({}, [] {
        const float usual = ImGui::GetStyle().ItemSpacing.x;
        CHECK(ui::menu_row({"File", "Edit"}).spacing == usual);
        CHECK(ui::menu_row({"File", "Edit"}).type == 1.0F);
        const float width = ImGui::CalcTextSize("Plano").x, em = ImGui::GetFontSize();
        for (const std::size_t n : {6U, 7U, 9U, 12U}) {
            CAPTURE(n);
            const ui::MenuRow row = ui::menu_row(std::vector<std::string>(n, "Plano"));
            const float words = static_cast<float>(n) * width, gaps = 2.0F * static_cast<float>(n);
            CHECK(words + gaps * usual > 300.0F);
            CHECK(row.type * words + gaps * row.spacing <= 300.0F);
            CHECK(row.spacing >= 0.3F * row.type * em - 1.0F); // whole pixels
        }
    });
}

TEST_SUITE_END();
