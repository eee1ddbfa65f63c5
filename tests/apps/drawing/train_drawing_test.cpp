// A train to scale on a sheet of its own.
#include "apps/drawing/train_drawing.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "tests/apps/drawing/view_model.h"

using namespace drawing;

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
