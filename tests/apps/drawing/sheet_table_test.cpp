// Tables at the foot of a sheet: every column seen, in type that can be read.
#include <doctest/doctest.h>

#include "apps/drawing/sheet/sheet_table.h"
#include "tests/apps/drawing/view_model.h"

#include <algorithm>
#include <string>

using namespace drawing;

TEST_SUITE_BEGIN("frame");

namespace {

constexpr double sheet_height = 400.0;

/// Work of a beam on elastic ground: power series beside short numbers.
tabular::Table series_table(std::size_t)
{
    using tabular::Alignment;
    tabular::Table table({"member",
                          "",
                          {"x", "m"},
                          {"F(x)", "", Alignment::Left},
                          {"f(x)", "", Alignment::Left},
                          {"F f", "", Alignment::Left},
                          {"∫ F f dx", "", Alignment::Right},
                          "stiffness",
                          {"work", "mm", Alignment::Right}});
    const std::string real = "-0.3677 + 40.39 x + 0.001471 x² - 0.03231 x³ + 6.732 x⁴ + 0.2413 x⁵ + …";
    const std::string unit = "-2.736 + 0.7182 x + 0.1402 x² - 0.07456 x³ + 0.01095 x⁴ - 0.0005746 x⁵ + …";
    for (const char* member : {"AM", "MB"})
        table.add_row({member, "M", "1.33333 … 2.66667", real, unit, "…", "-116.887", "EIz = 208333", "-0.561"});
    table.add_row({"MB", "p", "0 … 4", "3.1 x", unit, "9.3 - 4.1 x + 5.7 x² - 7.9 x³ + 2.9 x⁴ + 8.3 x⁵ + 1.7 x⁶",
                   "-5.37587", "k = 20000", "-0.269"});
    table.add_row({"sum", "", "", "", "", "", "", "", "-1.391"});
    table.n_sums = 1;
    return table;
}

view_test::Marks drawn_table(double width, const ui::Theme& theme, const ui::Fonts& fonts)
{
    ui::Painter painter({width, sheet_height}, fonts);
    const SheetTable table(
        series_table, {.width = width, .height = sheet_height, .folded = {5, 6, 7}, .shortened = {3, 4}}, theme, fonts);
    table.draw(painter, {0.0, 0.0});
    view_test::Marks marks(fonts);
    painter.picture().draw_on(marks);
    return marks;
}

const view_test::Marks::Text* found_text(const view_test::Marks& marks, std::string_view words)
{
    const auto found = std::ranges::find(marks.texts, words, &view_test::Marks::Text::words);
    return found == marks.texts.end() ? nullptr : &*found;
}

} // namespace

TEST_CASE("A table with long formulas keeps its last column and sum on the sheet, in type that can be read")
{
    const ui::Fonts fonts;
    for (const ui::ThemeName name : {ui::ThemeName::Light, ui::ThemeName::Projector}) {
        const ui::Theme theme(name);
        const double normal = theme.type().normal;
        ui::TextStyle least = theme.text(ui::Role::Label, ui::Anchor::TopLeft);
        least.size = 0.69 * normal;
        for (double width = 32.0 * normal; width < 1300.0; width += 31.0) {
            CAPTURE(width);
            const view_test::Marks marks = drawn_table(width, theme, fonts);
            for (const auto& text : marks.texts) {
                CAPTURE(text.words);
                CHECK(text.box.max.x <= width + 0.5);
                CHECK(text.box.width() >= fonts.measure(text.words, least).width);
                for (const auto& other : marks.texts) CHECK((&other == &text || !other.box.overlaps(text.box)));
            }
            for (const char* words : {"work [mm]", "−0.561", "−0.269", "−1.391"})
                CHECK_MESSAGE(found_text(marks, words), words);
        }
    }
}

TEST_CASE("A formula without room in a table ends after a whole term, with three dots; what is short stays whole")
{
    const ui::Fonts fonts;
    const view_test::Marks marks = drawn_table(560.0, ui::Theme(ui::ThemeName::Light), fonts);
    CHECK(found_text(marks, "3.1 x"));
    const std::string whole = "−2.736 + 0.7182 x + 0.1402 x² − 0.07456 x³ + 0.01095 x⁴ − 0.0005746 x⁵ + …";
    CHECK_FALSE(found_text(marks, whole));
    const auto cut = std::ranges::find_if(marks.texts, [](const auto& t) { return t.words.starts_with("−2.736"); });
    REQUIRE(cut != marks.texts.end());
    REQUIRE(cut->words.ends_with(" + …"));
    const std::string kept = cut->words.substr(0, cut->words.size() - std::string(" + …").size());
    CHECK(whole.starts_with(kept));
    const std::string behind = whole.substr(kept.size());
    CHECK((behind.starts_with(" + ") || behind.starts_with(" − ")));
}
