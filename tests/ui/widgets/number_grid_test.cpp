#include "ui/widgets/number_grid.h"

#include "tests/ui/widget_stage.h"

#include <doctest/doctest.h>

#include <imgui.h>

TEST_SUITE_BEGIN("number grid");

TEST_CASE("A grid's longest number has room in its column, and short ones keep the usual type")
{
    if (!ui_test::has_renderer()) return;
    const ui::NumberRows stresses{{"−1235", "4.25"}, {"4.25", "−16.09"}},
        strains{{"6e−5", "−7.448e−5"}, {"−7.448e−5", "0.000246"}};
    ui_test::WidgetStage stage{1.0};
    stage.frame({}, [&] {
        CHECK(ui::type_in_column(stresses, 100.0F) == 1.0F);
        for (const float column : {100.0F, 60.0F, 40.0F}) {
            CAPTURE(column);
            const float type = ui::type_in_column(strains, column);
            CHECK(type * ImGui::CalcTextSize("−7.448e−5").x <= 1.0001F * column);
        }
        CHECK(ui::type_in_column(strains, 40.0F) < 1.0F);
    });
}

TEST_CASE("What follows a grid of small type is in the usual one")
{
    if (!ui_test::has_renderer()) return;
    ui_test::WidgetStage stage{1.0};
    stage.frame({}, [&] {
        const float usual = ImGui::GetFontSize();
        ImGui::BeginChild("narrow panel", {80.0F, 0.0F});
        ui::number_grid("strains", {{"6e−5", "−7.448e−5"}, {"−7.448e−5", "0.000246"}});
        CHECK(ImGui::GetFontSize() == usual);
        ImGui::EndChild();
    });
}
