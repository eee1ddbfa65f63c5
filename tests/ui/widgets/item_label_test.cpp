#include "ui/widgets/item_label.h"

#include "tests/ui/widget_stage.h"

#include <doctest/doctest.h>

#include <string>

TEST_SUITE_BEGIN("item labels");

TEST_CASE("A name is as wide in a label as it is written, whatever signs it has")
{
    if (!ui_test::has_renderer()) return;
    ui_test::WidgetStage stage{1.0};
    stage.frame({}, [] {
        for (const std::string name : {"beam", "beam##2", "beam###2", "##", "a#", "100 %s", ""}) {
            CAPTURE(name);
            const std::string label = ui::item_label(name, "7");
            const float written = ImGui::CalcTextSize(name.c_str()).x;
            CHECK(ImGui::CalcTextSize(label.c_str(), nullptr, true).x == written);
            CHECK(ImGui::CalcTextSize(ui::shown_whole(name).c_str(), nullptr, true).x == written);
        }
    });
}

TEST_CASE("A widget is known by the id of its label alone")
{
    if (!ui_test::has_renderer()) return;
    ui_test::WidgetStage stage{1.0};
    stage.frame({}, [] {
        for (const std::string name : {"beam", "beam##2", "beam###2", "a#"}) {
            CAPTURE(name);
            CHECK(ImGui::GetID(ui::item_label(name, "7").c_str()) == ImGui::GetID("###7"));
            CHECK(ImGui::GetID(ui::item_label(name, "7").c_str()) != ImGui::GetID(ui::item_label(name, "8").c_str()));
        }
    });
}

TEST_SUITE_END();
