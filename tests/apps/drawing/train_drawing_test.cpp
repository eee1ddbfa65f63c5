// A train to scale on a sheet of its own.
#include "apps/drawing/train_drawing.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <string_view>

#include "tests/apps/drawing/view_model.h"

using namespace drawing;

namespace {

view_test::Marks marks_of_train(const femoop::Train& train, const ui::Fonts& fonts, ui::Size sheet = {250.0, 160.0})
{
    const ui::Catalogue english;
    ui::Painter painter(sheet, fonts);
    draw_train(painter, train, {.theme = ui::Theme(ui::ThemeName::Projector), .units = {}, .tr = english});
    view_test::Marks marks(fonts);
    painter.picture().draw_on(marks);
    return marks;
}

const view_test::Marks::Text& text_of_train(const view_test::Marks& marks, std::string_view words)
{
    const auto found = std::ranges::find(marks.texts, words, &view_test::Marks::Text::words);
    REQUIRE(found != marks.texts.end());
    return *found;
}

} // namespace

TEST_CASE("A distance that is wider than its dimension is written below the others")
{
    const ui::Fonts fonts;
    const femoop::Train train{.id = "HS20",
                              .axles = {8.0, 32.0, 32.0},
                              .spacings = {14.0, 14.0},
                              .spacing_ranges = {{.spacing = 1, .min = 14.0, .max = 30.0}}};
    const view_test::Marks marks = marks_of_train(train, fonts);
    CHECK(text_of_train(marks, "14 … 30").box.min.y > text_of_train(marks, "14").box.max.y - 3.0);
}

TEST_CASE("The loads of a group between two of larger loads are written once, over those")
{
    const ui::Fonts fonts;
    const femoop::Train train{
        .id = "E80",
        .axles = {40.0, 80.0, 80.0, 80.0, 80.0, 52.0, 52.0, 52.0, 52.0, 40.0, 80.0, 80.0, 80.0, 80.0, 52.0, 52.0, 52.0,
                  52.0},
        .spacings = {8.0, 5.0, 5.0, 5.0, 9.0, 5.0, 6.0, 5.0, 8.0, 8.0, 5.0, 5.0, 5.0, 9.0, 5.0, 6.0, 5.0}};
    const view_test::Marks marks = marks_of_train(train, fonts, {294.0, 223.0});
    CHECK(std::ranges::count(marks.texts, "4 × 52", &view_test::Marks::Text::words) == 2);
    CHECK(std::ranges::count(marks.texts, "4 × 80", &view_test::Marks::Text::words) == 2);
    CHECK(std::ranges::count(marks.texts, "40", &view_test::Marks::Text::words) == 2);
    for (const auto& one : marks.texts)
        for (const auto& other : marks.texts) CHECK((&one == &other || !one.box.grown(-1.0).overlaps(other.box)));
}

TEST_CASE("A distance that has no room beside the one before it is written below it")
{
    const ui::Fonts fonts;
    const femoop::Train train{.id = "HL93",
                              .axles = {35.59, 142.3, 142.3},
                              .spacings = {4.267, 4.267},
                              .spacing_ranges = {{.spacing = 1, .min = 4.267, .max = 9.144}}};
    const ui::Catalogue english;
    ui::Painter painter({250.0, 160.0}, fonts);
    draw_train(painter, train, {.theme = ui::Theme(ui::ThemeName::Projector), .units = {}, .tr = english});
    view_test::Marks marks(fonts);
    painter.picture().draw_on(marks);
    const auto first = std::ranges::find(marks.texts, "4.267", &view_test::Marks::Text::words);
    const auto second = std::ranges::find(marks.texts, "4.267 … 9.144", &view_test::Marks::Text::words);
    REQUIRE(first != marks.texts.end());
    REQUIRE(second != marks.texts.end());
    CHECK(!first->box.overlaps(second->box));
    for (const auto& text : marks.texts) CHECK((&text == &*second || !text.box.overlaps(second->box)));
}
