#include "ui/widgets/number_field.h"

#include "tests/ui/widget_stage.h"

#include <doctest/doctest.h>

#include <cmath>
#include <optional>
#include <string>
#include <vector>

using Kind = ui::NumberFieldEvent::Kind;

TEST_SUITE_BEGIN("number fields");

namespace {

/// One field that shows 12 and takes no text: whatever is typed is rejected.
struct FieldStage {
    ui_test::WidgetStage stage{1.0};
    ui::NumberFields fields;
    ui::Point middle;
    std::vector<ui::NumberFieldEvent> events;

    void frame(const ui::Input& input)
    {
        stage.frame(input, [&] {
            const ui::NumberFieldEvent event = fields.show("q", {.text = "12", .exact_text = "12", .value = 12.0});
            const ImVec2 a = ImGui::GetItemRectMin(), b = ImGui::GetItemRectMax();
            middle = ui::Point{static_cast<double>(a.x + b.x), static_cast<double>(a.y + b.y)} / 2.0;
            if (event.kind != Kind::None) events.push_back(event);
            if (event.kind == Kind::Typed) fields.reject(event, "no number");
        });
    }
    void key(ui::Key key)
    {
        frame({.keys = {{key, true}}});
        frame({.keys = {{key, false}}});
        frame({});
    }
    void click()
    {
        frame({});
        frame({});
        const ui::Input hover{.pointer = middle};
        ui::Input press = hover;
        press.is_button_down[0] = true;
        for (const ui::Input& input : {hover, press, hover, hover, hover}) frame(input);
    }
    void type_nonsense()
    {
        click();
        frame({.text = "abc"});
        key(ui::Key::Enter);
    }
};

} // namespace

TEST_CASE("A text that is rejected stays to be mended; Esc leaves the number as it was")
{
    if (!ui_test::has_renderer()) return;
    FieldStage field;
    field.type_nonsense();
    REQUIRE(field.events.size() == 1);
    CHECK(field.events[0].text == "abc");
    CHECK(field.fields.is_typing());
    field.key(ui::Key::Escape);
    CHECK(!field.fields.is_typing());
    CHECK(field.events.size() == 1);
}

TEST_CASE("A field that is no longer shown does not keep the keyboard")
{
    if (!ui_test::has_renderer()) return;
    FieldStage field;
    field.type_nonsense();
    REQUIRE(field.fields.is_typing());
    field.stage.frame({}, [] { ImGui::TextUnformatted("another panel"); });
    field.stage.frame({}, [&] { CHECK(!field.fields.is_typing()); });
}

TEST_CASE("Dragging passes through values that a person would type, and settles once")
{
    if (!ui_test::has_renderer()) return;
    FieldStage field;
    field.frame({});
    field.frame({});
    ui::Input input{.pointer = field.middle};
    field.frame(input);
    input.is_button_down[0] = true;
    field.frame(input);
    for (int i = 0; i < 5; ++i) {
        input.pointer->x += 6.0;
        field.frame(input);
    }
    input.is_button_down[0] = false;
    field.frame(input);
    REQUIRE(field.events.size() > 1);
    const double step = ui::drag_step(12.0);
    for (const auto& event : field.events) {
        CAPTURE(event.value);
        CHECK(std::abs(event.value / step - std::round(event.value / step)) < 1e-9);
    }
    CHECK(field.events.back().kind == Kind::Settled);
    CHECK(field.events.back().value > 12.0);
}

TEST_CASE("A name is typed, and not dragged")
{
    if (!ui_test::has_renderer()) return;
    ui_test::WidgetStage stage{1.0};
    ui::NumberFields fields;
    bool is_quiet = true;
    const auto frame = [&](const ui::Input& input) {
        stage.frame(input, [&] {
            const ui::NumberFields::Look look{
                .text = "IPE 300", .exact_text = "IPE 300", .value = std::nullopt, .is_typed_only = true};
            is_quiet = is_quiet && fields.show("section", look).kind == Kind::None;
        });
    };
    ui::Input input{.pointer = ui::Point{60.0, 15.0}};
    frame({});
    frame(input);
    input.is_button_down[0] = true;
    for (int i = 0; i < 5; ++i) {
        input.pointer->x += 6.0;
        frame(input);
    }
    CHECK(is_quiet);
}

TEST_CASE("Tab takes what was typed and goes on to the next field, after the last to the first; Shift+Tab goes back")
{
    if (!ui_test::has_renderer()) return;
    ui_test::WidgetStage stage{1.0};
    ui::NumberFields fields;
    std::string open, typed;
    const auto frame = [&](const ui::Input& input) {
        stage.frame(input, [&] {
            open.clear();
            for (const std::string name : {"a", "b", "c"}) {
                const ui::NumberFieldEvent event = fields.show(name, {.text = "1", .exact_text = "1", .value = 1.0});
                if (event.kind == Kind::Typed) typed += name + "=" + event.text + " ";
                if (event.text == "no") fields.reject(event, "no number");
                if (fields.is_open(name)) open += name;
            }
        });
    };
    const auto tab = [&](ui::Modifiers modifiers) {
        frame({.modifiers = modifiers, .keys = {{ui::Key::Tab, true, modifiers}}});
        frame({.modifiers = modifiers, .keys = {{ui::Key::Tab, false, modifiers}}});
        frame({});
        frame({});
    };
    stage.frame({}, [&] { fields.open("a", "1"); });
    frame({});
    frame({});
    for (const std::string next : {"b", "c", "a"}) {
        frame({.text = "7"});
        tab({});
        CHECK(open == next);
    }
    CHECK(typed == "a=7 b=7 c=7 ");
    for (const std::string next : {"c", "b", "a"}) {
        tab({.shift = true});
        CHECK(open == next);
    }
    frame({.text = "no"});
    tab({});
    CHECK(open == "a");
}

TEST_SUITE_END();
