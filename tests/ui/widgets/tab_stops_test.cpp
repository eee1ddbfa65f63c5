#include "ui/widgets/tab_stops.h"

#include "tests/ui/widget_stage.h"
#include "ui/widgets/number_field.h"

#include <doctest/doctest.h>
#include <imgui_stdlib.h>

#include <string>

TEST_SUITE_BEGIN("places of Tab");

namespace {

/// A field of text, a list, a number, a part that is scrolled with a box and a grey button in it, and a button below.
struct PlaceStage final : ui_test::Hand {
    ui_test::WidgetStage stage{1.0};
    ui::NumberFields fields;
    std::string text = "beam", number = "12", chosen = "one";
    bool is_ticked = false;
    std::string place; ///< that has the keyboard

    void add(const std::string& name, ui::TabStops::Kind kind = ui::TabStops::Kind::Widget)
    {
        fields.stops().add(kind);
        const bool has_it = kind == ui::TabStops::Kind::Text ? ImGui::IsItemActive() : ImGui::IsItemFocused();
        if (has_it) place = name;
    }
    void show_list()
    {
        if (!ImGui::BeginCombo("list", chosen.c_str())) return;
        for (const std::string name : {"one", "two"})
            if (ImGui::Selectable(name.c_str(), name == chosen)) chosen = name;
        ImGui::EndCombo();
    }
    void show_scrolled()
    {
        ImGui::BeginChild("scrolled", {0.0F, 40.0F});
        ImGui::Dummy({10.0F, 100.0F});
        ImGui::Checkbox("box", &is_ticked);
        add("box");
        ImGui::BeginDisabled();
        ImGui::Button("grey");
        add("grey");
        ImGui::EndDisabled();
        ImGui::EndChild();
    }
    void frame(const ui::Input& input) override
    {
        stage.frame(input, [&] {
            place.clear();
            fields.stops().begin_window();
            ImGui::InputText("text", &text);
            add("text", ui::TabStops::Kind::Text);
            show_list();
            add("list");
            const auto event = fields.show("number", {.text = number, .exact_text = number, .value = 12.0});
            if (event.kind == ui::NumberFieldEvent::Kind::Typed) number = event.text;
            if (fields.is_open("number")) place = "number";
            show_scrolled();
            ImGui::Button("button");
            add("button");
            fields.stops().end_window();
        });
    }
    std::string tab(ui::Modifiers modifiers = {})
    {
        frame({.modifiers = modifiers, .keys = {{ui::Key::Tab, true, modifiers}}});
        frame({.modifiers = modifiers, .keys = {{ui::Key::Tab, false, modifiers}}});
        rest();
        return place;
    }
};

} // namespace

TEST_CASE("Tab goes through fields, lists, numbers, boxes and buttons as they stand, and round; Shift+Tab goes back")
{
    if (!ui_test::has_renderer()) return;
    PlaceStage stage;
    stage.rest();
    for (int round = 0; round < 2; ++round)
        for (const std::string next : {"text", "list", "number", "box", "button"}) CHECK(stage.tab() == next);
    for (const std::string next : {"box", "number", "list", "text", "button"})
        CHECK(stage.tab({.shift = true}) == next);
}

TEST_CASE("What is typed at a place that Tab has come to takes the place of what stood there")
{
    if (!ui_test::has_renderer()) return;
    PlaceStage stage;
    stage.rest();
    stage.tab();
    stage.type("strut");
    stage.tab();
    stage.tab();
    stage.type("35");
    stage.tab();
    stage.key(ui::Key::Space);
    CHECK(stage.text == "strut");
    CHECK(stage.number == "35");
    CHECK(stage.is_ticked);
}

TEST_CASE("Tab leaves a list that is open, and one in which something was chosen, for the place behind it")
{
    if (!ui_test::has_renderer()) return;
    PlaceStage stage;
    stage.rest();
    stage.tab();
    stage.tab();
    stage.key(ui::Key::Space);
    stage.stage.frame({}, [] { CHECK(ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup)); });
    CHECK(stage.tab() == "number");
    stage.stage.frame({}, [] { CHECK(!ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup)); });
    stage.rest();
    CHECK(stage.tab() == "text"); // the window was away
    CHECK(stage.tab() == "list");
    stage.key(ui::Key::Space);
    stage.key(ui::Key::Down);
    stage.key(ui::Key::Enter);
    CHECK(stage.chosen == "two");
    CHECK(stage.tab() == "number");
}

TEST_SUITE_END();
