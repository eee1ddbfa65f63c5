#include "ui/widgets/wrapped_field.h"
#include "ui/widgets/wrapped_text.h"

#include "tests/ui/widget_stage.h"

#include <doctest/doctest.h>

#include <imgui_stdlib.h>

#include <algorithm>
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

TEST_CASE("A number is not broken at its decimal sign: the whole of it goes to the next line")
{
    if (!ui_test::has_renderer()) return;
    ui_test::WidgetStage stage{1.0};
    float in_blanks = 0.0F, in_numbers = 0.0F;
    stage.frame({}, [&] {
        const float room = ImGui::GetCursorPosX() + ImGui::CalcTextSize("1234567; 1,2").x;
        float top = ImGui::GetCursorPosY();
        ui::wrapped_text("1234567; 1,2345 6,7890", room);
        in_numbers = ImGui::GetCursorPosY() - top;
        top = ImGui::GetCursorPosY();
        ui::wrapped_text("1234567;\n1,2345\n6,7890", room);
        in_blanks = ImGui::GetCursorPosY() - top;
    });
    CHECK(in_numbers == in_blanks);
}

TEST_CASE("A choice that is too long for its list is shown in lines, and a click opens the list all the same")
{
    if (!ui_test::has_renderer()) return;
    for (const char* const name : {"short", "a choice that is much too long for a panel of this width"}) {
        CAPTURE(name);
        ui_test::WidgetStage stage{1.0};
        ImVec2 middle{}, list{};
        float height = 0.0F, row = 0.0F, foot = 0.0F;
        bool is_open = false;
        const auto frame = [&](const ui::Input& input) {
            stage.frame(input, [&] {
                const ImVec2 corner = ImGui::GetCursorScreenPos();
                is_open = ui::begin_wrapped_combo(name, {name}, "###choice");
                if (is_open) list = ImGui::GetWindowPos();
                else foot = ImGui::GetItemRectMax().y;
                if (is_open) {
                    ImGui::Selectable("another");
                    ImGui::EndCombo();
                }
                height = ImGui::GetItemRectSize().y;
                row = ImGui::GetFrameHeight();
                middle = {corner.x + 20.0F, corner.y + 0.5F * row};
            });
        };
        frame({});
        CHECK((height > row) == (std::string(name) != "short"));
        const ui::Point at{static_cast<double>(middle.x), static_cast<double>(middle.y)};
        frame({.pointer = at});
        frame({.pointer = at, .is_button_down = {true}});
        frame({.pointer = at});
        frame({.pointer = at}); // a list knows its size, and so its place, when it was drawn once
        CHECK(is_open);
        CHECK(list.y >= foot - 1.0F); // what is chosen stays in sight
    }
}

TEST_CASE("A list is as high as its longest choice asks for, whichever is chosen")
{
    if (!ui_test::has_renderer()) return;
    ui_test::WidgetStage stage{1.0};
    const std::vector<std::string> names{"short", "a choice that is much too long for a panel of this width"};
    std::vector<float> heights;
    float row = 0.0F;
    for (const std::string& chosen : names)
        stage.frame({}, [&] {
            if (ui::begin_wrapped_combo(chosen, names, "###choice")) ImGui::EndCombo();
            heights.push_back(ImGui::GetItemRectSize().y);
            row = ImGui::GetFrameHeight();
        });
    CHECK(heights[0] == heights[1]);
    CHECK(heights[0] > row);
}

TEST_CASE("A label is broken after blanks where it is full, and is one line again when that is undone")
{
    if (!ui_test::has_renderer()) return;
    ui_test::WidgetStage stage{1.0};
    stage.frame({}, [&] {
        const std::string text = "Moment distribution of the selection\nand of overlongwordswithoutanyblankatall";
        const std::string lines = ui::in_lines(text, 120.0F);
        CHECK(std::ranges::count(lines, '\n') > 3);
        CHECK(ui::in_one_line(lines) == text);
        CHECK(ImGui::CalcTextSize(lines.substr(0, lines.find('\n')).c_str()).x <= 120.0F);
        CHECK(ui::in_lines("no need", 1000.0F) == "no need");
        CHECK(ui::in_lines("", 10.0F).empty());
    });
}

TEST_CASE("Notes are wrapped as they are typed, and are what was typed; Enter ends a line")
{
    if (!ui_test::has_renderer()) return;
    ui_test::WidgetStage stage{1.0};
    ui::WrappedField field({.least = 2, .most = 4});
    std::string text = "";
    bool is_done = false, is_left = false;
    const auto show = [&] {
        ImGui::InputText("###other", &text, ImGuiInputTextFlags_ReadOnly);
        if (is_left) ImGui::SetKeyboardFocusHere(-1);
        else if (!ImGui::IsAnyItemActive()) ImGui::SetKeyboardFocusHere();
        std::string notes = text;
        if (field.show("###notes", notes)) {
            text = notes;
            is_done = true;
        }
    };
    const auto type = [&](const std::string& letters) {
        for (const char letter : letters) stage.frame({.text = std::string(1, letter)}, show);
    };
    for (int i = 0; i < 3; ++i) stage.frame({}, show);
    const std::string first = "A long line that goes on far beyond the right hand end of the field ", second = "second";
    type(first);
    stage.frame({.keys = {{ui::Key::Enter, true}}}, show);
    stage.frame({.keys = {{ui::Key::Enter, false}}}, show);
    type(second);
    is_left = true;
    for (int i = 0; i < 3; ++i) stage.frame({}, show);
    CHECK(is_done);
    CHECK(text == first.substr(0, first.size() - 1) + "\n" + second);
}

TEST_SUITE_END();
