#include "ui/paint/text_measure.h"
#include "ui/paint/wrapped_lines.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <numbers>
#include <string>
#include <vector>

using doctest::Approx;

TEST_SUITE_BEGIN("text measure");

TEST_CASE("A string is as wide as the advances of its glyphs in the font file")
{
    // hmtx table of DejaVu Sans 2.37, units of 2048 to the em: '1' 1303, '.' 651, '5' 1303, 'k' 1186, 'N' 1532
    const ui::Fonts fonts;
    const double size = 17.0;
    CHECK(fonts.measure("1.5", size).width == Approx((1303 + 651 + 1303) / 2048.0 * size));
    CHECK(fonts.measure("kN", size).width == Approx((1186 + 1532) / 2048.0 * size));
}

TEST_CASE("The width grows in proportion to the size and with every character")
{
    const ui::Fonts fonts;
    const double at_13 = fonts.measure("M = 12.5 kN·m", 13.0).width;
    CHECK(fonts.measure("M = 12.5 kN·m", 39.0).width == Approx(3.0 * at_13));
    CHECK(fonts.measure("M = 12.5 kN·m!", 13.0).width > at_13);
    CHECK(fonts.measure("", 13.0).width == 0.0);
}

TEST_CASE("Bold type is wider than regular type")
{
    const ui::Fonts fonts;
    CHECK(fonts.measure("moment", 13.0, ui::Weight::Bold).width > fonts.measure("moment", 13.0).width);
}

TEST_CASE("No line of a broken text begins with the dot that parts two words, and none is lost")
{
    const ui::Fonts fonts;
    const ui::TextStyle style{.size = 11.0};
    const std::string text = "load case G  ·  units kN, m  ·  statically indeterminate";
    for (double width = 10.0; width < 400.0; width += 1.0) {
        CAPTURE(width);
        std::string all;
        for (const std::string& line : ui::wrapped_lines(fonts, text, style, width)) {
            CHECK_FALSE(line.starts_with("·"));
            all += line;
        }
        std::string letters = text;
        std::erase(letters, ' ');
        std::erase(all, ' ');
        CHECK(all == letters);
    }
}

TEST_CASE("A number stays with its unit, and a sign with its term, on whatever line")
{
    const ui::Fonts fonts;
    const ui::TextStyle style{.size = 13.0};
    const std::vector<std::string> terms{"ΣM ",  "= −40.7825 kN · 1.61 m ", "+ 3.2 kN · 4 m ", "− 54.7 kN·m ", "= M4 ",
                                         "on it"};
    std::string text;
    double widest = 0.0;
    for (const std::string& term : terms) {
        text += term;
        widest = std::max(widest, fonts.measure(term, style).width);
    }
    for (double width = widest; width < 400.0; width += 1.0) {
        CAPTURE(width);
        std::string rest = text;
        for (const std::string& line : ui::wrapped_lines(fonts, text, style, width)) {
            CAPTURE(line);
            rest.erase(0, rest.find_first_not_of(' '));
            REQUIRE(rest.starts_with(line));
            rest.erase(0, line.size());
            const auto begins = [&](const std::string& term) {
                return rest.find_first_not_of(' ') == std::string::npos ||
                       rest.substr(rest.find_first_not_of(' ')).starts_with(term);
            };
            CHECK(std::ranges::any_of(terms, [&](const std::string& term) { return begins(term) || begins("it"); }));
        }
    }
}

TEST_CASE(
    "Neither a place nor a value and its name are broken, and an equation among parts of a head is not where it need not be")
{
    const ui::Fonts fonts;
    const ui::TextStyle style{.size = 13.0};
    const auto lines = [&](const std::string& text, const std::string& first) {
        return ui::wrapped_lines(fonts, text, style, fonts.measure(first, style).width + 1.0);
    };
    CHECK(lines("at (0, 0), (5, 43), (40, 0)", "at (0, 0), (5, 43), (40,") ==
          std::vector<std::string>{"at (0, 0), (5, 43),", "(40, 0)"});
    CHECK(lines("by equilibrium N = 0 N, V = 2 N, M = −50 N·mm", "by equilibrium N = 0 N, V = 2 N, M") ==
          std::vector<std::string>{"by equilibrium N = 0 N, V = 2 N,", "M = −50 N·mm"});
    CHECK(lines("load case F  ·  ΣFx = 0 + 0 = 0 N  ·  ΣM = −6 + 6 = 0",
                "load case F  ·  ΣFx = 0 + 0 = 0 N  ·  ΣM = −6 + 6") ==
          std::vector<std::string>{"load case F  ·  ΣFx = 0 + 0 = 0 N  ·", "ΣM = −6 + 6 = 0"});
}

TEST_CASE("The font has the Greek, Portuguese and mathematical characters that the program writes")
{
    const ui::Fonts fonts;
    const std::u32string needed = U"ΔΣΩαβγδεθκλμνξρσφψωáàâãçéêíóôõúÁÀÂÃÇÉÊÍÓÔÕÚ≤≥·×°²³⁴⁵⁶−→←↑↓∞√½±≈≠⁻¹…–—“”′″";
    for (const char32_t c : needed) {
        CAPTURE(static_cast<unsigned>(c));
        CHECK(fonts.has_glyph(c, ui::Weight::Regular));
        CHECK(fonts.has_glyph(c, ui::Weight::Bold));
    }
}

TEST_CASE("A character that the font lacks takes the room of the replacement box")
{
    const ui::Fonts fonts;
    const char32_t lacking = 0x10FFFD; // private use
    REQUIRE_FALSE(fonts.has_glyph(lacking, ui::Weight::Regular));
    CHECK(fonts.glyph_index(lacking, ui::Weight::Regular) == 0);
    CHECK(fonts.advance(lacking, ui::Weight::Regular) > 0.0);
}

TEST_CASE("Broken UTF-8 gives one replacement character per broken byte and never more")
{
    CHECK(ui::decode_utf8("a\xC3\xA7") == U"aç");
    CHECK(ui::decode_utf8("a\xFF\x62") == U"a\uFFFDb");
    CHECK(ui::decode_utf8("\xE2\x82") == U"\uFFFD\uFFFD"); // cut short
    CHECK(ui::decode_utf8("\xC0\xAF") == U"\uFFFD\uFFFD"); // longer than needed
    CHECK(ui::decode_utf8("\xED\xA0\x80").size() == 3);    // half of a surrogate pair
    CHECK(ui::decode_utf8("\xF0\x9F\x8C\x89") == U"\U0001F309");
}

TEST_CASE("Encoding undoes decoding")
{
    const std::string text = "θ ≤ 2·10⁻³ – ação \xF0\x9F\x8C\x89";
    CHECK(ui::encode_utf8(ui::decode_utf8(text)) == text);
}

TEST_CASE("An anchor is the point of the text's box that stays put")
{
    const ui::Fonts fonts;
    const ui::Point at{100.0, 200.0};
    ui::TextStyle style{.size = 20.0};
    const double width = fonts.measure("7.25 kN", style).width;

    style.anchor = ui::Anchor::TopLeft;
    CHECK(ui::text_box(fonts, at, "7.25 kN", style).min == at);
    style.anchor = ui::Anchor::BottomRight;
    CHECK(ui::text_box(fonts, at, "7.25 kN", style).max.x == Approx(at.x));
    CHECK(ui::text_box(fonts, at, "7.25 kN", style).max.y == Approx(at.y));
    style.anchor = ui::Anchor::Center;
    const ui::Box box = ui::text_box(fonts, at, "7.25 kN", style);
    CHECK(box.center().x == Approx(at.x));
    CHECK(box.width() == Approx(width));
    // the middle of a capital letter lies at the anchor: the baseline is half its height below
    CHECK(box.max.y - at.y == Approx(0.5 * fonts.cap_height() * 20.0 + fonts.measure("x", style).descent));
}

TEST_CASE("A quarter turn counter-clockwise makes text run upward")
{
    const ui::Fonts fonts;
    const ui::TextStyle style{.size = 20.0, .anchor = ui::Anchor::Left, .rotation = std::numbers::pi / 2.0};
    const ui::Box box = ui::text_box(fonts, {100.0, 200.0}, "upward", style);
    CHECK(box.max.y == Approx(200.0));
    CHECK(box.height() == Approx(fonts.measure("upward", style).width));
}

TEST_CASE("A missing font is an error that names the folder and the package")
{
    const std::filesystem::path empty = "tests/ui/no-such-folder";
    try {
        const ui::Fonts fonts(empty);
        FAIL("no error");
    } catch (const ui::FontError& error) {
        CHECK(std::string(error.what()).find(empty.string()) != std::string::npos);
        CHECK(std::string(error.what()).find("fonts-dejavu-core") != std::string::npos);
    }
}

TEST_SUITE_END();
