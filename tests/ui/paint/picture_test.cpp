#include "tests/folder.h"
#include "ui/paint/mesh/polygon_mesh.h"
#include "ui/paint/paint_to_file.h"
#include "ui/paint/painter.h"
#include "ui/paint/surface/golden_text.h"
#include "ui/paint/surface/svg.h"
#include "ui/paint/trim.h"

#include <doctest/doctest.h>

#include <limits>
#include <memory>
#include <numbers>
#include <string>
#include <utility>

using doctest::Approx;

namespace {

/// Writes down what it is asked to draw.
class Notes final : public ui::Surface {
public:
    void clip(const ui::Box& box) override { clips.push_back(box); }
    void stroke(const ui::Path& path, const ui::Stroke&) override
    {
        lines.emplace_back(path.points.begin(), path.points.end());
        offsets.push_back(path.dash_offset);
        order += 'l';
    }
    void fill(std::span<const ui::Point> polygon, ui::Color) override
    {
        areas.emplace_back(polygon.begin(), polygon.end());
        order += 'a';
    }
    void stroke_arc(const ui::Arc& arc, const ui::Stroke&) override
    {
        arcs.push_back(arc);
        order += 'c';
    }
    void fill_disc(ui::Point, double, ui::Color) override { order += 'd'; }
    void text(ui::Point, std::string_view utf8, const ui::TextStyle&) override
    {
        strings.emplace_back(utf8);
        order += 't';
    }

    std::vector<ui::Box> clips;
    std::vector<std::vector<ui::Point>> lines, areas;
    std::vector<double> offsets;
    std::vector<ui::Arc> arcs;
    std::vector<std::string> strings;
    std::string order;
};

Notes notes_of(const ui::Painter& painter)
{
    Notes notes;
    painter.picture().draw_on(notes);
    return notes;
}

struct Sheet {
    ui::Fonts fonts;
    ui::Painter painter{{400.0, 300.0}, fonts};
};

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

} // namespace

TEST_SUITE_BEGIN("picture");

TEST_CASE("Layers are drawn from background to overlay whatever the order of the calls")
{
    Sheet sheet;
    sheet.painter.set_layer(ui::Layer::Labels);
    sheet.painter.text({10.0, 10.0}, "label", {});
    sheet.painter.set_layer(ui::Layer::Areas);
    sheet.painter.rectangle({{1.0, 2.0}, {3.0, 5.0}}, {});
    {
        const ui::LayerScope scope(sheet.painter, ui::Layer::Background);
        sheet.painter.disc({20.0, 20.0}, 4.0, {});
    }
    sheet.painter.line({0.0, 0.0}, {7.0, 9.0}, {});
    CHECK(notes_of(sheet.painter).order == "dalt");
}

TEST_CASE("A clip within a clip is their common part, and the first one is back afterwards")
{
    Sheet sheet;
    const ui::ClipScope outer(sheet.painter, {{10.0, 10.0}, {200.0, 100.0}});
    {
        const ui::ClipScope inner(sheet.painter, {{150.0, 50.0}, {500.0, 500.0}});
        sheet.painter.line({0.0, 0.0}, {100.0, 90.0}, {});
    }
    sheet.painter.line({0.0, 0.0}, {100.0, 90.0}, {});
    const auto clips = notes_of(sheet.painter).clips;
    REQUIRE(clips.size() == 2);
    CHECK(clips[0] == ui::Box{{150.0, 50.0}, {200.0, 100.0}});
    CHECK(clips[1] == ui::Box{{10.0, 10.0}, {200.0, 100.0}});
}

TEST_CASE("Popping a clip that was not pushed is a fault of the program")
{
    Sheet sheet;
    CHECK_THROWS_AS(sheet.painter.pop_clip(), std::logic_error);
}

TEST_CASE("Shapes with numbers that are not finite are left out and counted")
{
    Sheet sheet;
    sheet.painter.line({not_a_number, 0.0}, {1.0, 1.0}, {});
    sheet.painter.polygon({{0.0, 0.0}, {infinity, 0.0}, {1.0, 1.0}}, {});
    sheet.painter.circle({0.0, 0.0}, -1.0, {});
    sheet.painter.arc({{0.0, 0.0}, 5.0, not_a_number, 1.0}, {});
    sheet.painter.disc({0.0, 0.0}, not_a_number, {});
    sheet.painter.text({0.0, 0.0}, "lost", {.size = not_a_number});
    sheet.painter.line({0.0, 0.0}, {1.0, 1.0}, {.width = -2.0});
    CHECK(sheet.painter.picture().n_refused() == 7);
    CHECK(notes_of(sheet.painter).order.empty());
}

TEST_CASE("A line that runs out of sight for a million kilometres is cut near the sheet")
{
    Sheet sheet;
    sheet.painter.line({-1e12, 150.0}, {1e12, 150.0}, {.width = 2.0, .dash = {6.0, 4.0}});
    const auto notes = notes_of(sheet.painter);
    REQUIRE(notes.lines.size() == 1);
    CHECK(notes.lines[0].front().x < 0.0);
    CHECK(notes.lines[0].front().x > -200.0);
    CHECK(notes.lines[0].back().x < 600.0);
    CHECK(notes.offsets[0] == Approx(1e12 + notes.lines[0].front().x)); // the dashes stay where they were
}

TEST_CASE("A circle as large as the Earth is drawn where it crosses the sheet and nowhere else")
{
    Sheet sheet;
    const double radius = 6.4e9;
    sheet.painter.circle({200.0, 150.0 + radius}, radius, {});
    const auto notes = notes_of(sheet.painter);
    REQUIRE_FALSE(notes.lines.empty());
    for (const auto& line : notes.lines) {
        CHECK(line.size() < 100);
        for (const ui::Point p : line) {
            CHECK(p.y == Approx(150.0).epsilon(1e-3));
            CHECK(std::abs(p.x - 200.0) < 400.0);
        }
    }
}

TEST_CASE("The parts of a polyline inside a box know how far along they begin")
{
    const std::vector<ui::Point> line = {{-10.0, 5.0}, {10.0, 5.0}, {10.0, 25.0}, {5.0, 25.0}, {5.0, 5.0}};
    const auto inside = ui::stretches_inside(line, {{0.0, 0.0}, {20.0, 20.0}});
    REQUIRE(inside.size() == 2);
    CHECK(inside[0].points == std::vector<ui::Point>{{0.0, 5.0}, {10.0, 5.0}, {10.0, 20.0}});
    CHECK(inside[0].begin == Approx(10.0));
    CHECK(inside[1].points == std::vector<ui::Point>{{5.0, 20.0}, {5.0, 5.0}});
    CHECK(inside[1].begin == Approx(20.0 + 20.0 + 5.0 + 5.0));
}

TEST_CASE("A polygon larger than its box becomes the box")
{
    const std::vector<ui::Point> large = {{-100.0, -100.0}, {300.0, -100.0}, {300.0, 300.0}, {-100.0, 300.0}};
    const ui::Box box{{0.0, 0.0}, {30.0, 20.0}};
    const auto inside = ui::polygon_inside(large, box);
    CHECK(inside.size() == 4);
    for (const ui::Point p : inside) CHECK(box.contains(p));
}

TEST_CASE("A point at angle t on an arc is counter-clockwise as seen")
{
    const ui::Arc arc{{50.0, 60.0}, 10.0, 0.0, 1.0};
    const ui::Point top = arc.at(std::numbers::pi / 2.0);
    CHECK(top.x == Approx(50.0));
    CHECK(top.y == Approx(50.0)); // above the centre: y is down
}

TEST_CASE("The golden text lists every string with place, anchor, size, weight and turn")
{
    Sheet sheet;
    sheet.painter.text({10.25, 20.0}, "M = 12.5 kN·m", {.size = 13.0});
    sheet.painter.text(
        {30.0, 40.0}, "q",
        {.size = 11.5, .weight = ui::Weight::Bold, .anchor = ui::Anchor::TopLeft, .rotation = std::numbers::pi / 2.0});
    sheet.painter.line({0.0, 0.0}, {5.0, 7.0}, {});
    CHECK(ui::golden_text(sheet.painter.picture()) == "sheet 400 x 300, 1 lines, 0 areas, 2 strings, 0 refused\n"
                                                      "(10.3, 20.0) center 13 \"M = 12.5 kN·m\"\n"
                                                      "(30.0, 40.0) top-left 11.5 bold rotated 90 \"q\"\n");
}

TEST_CASE("SVG keeps text as text, at the measured width")
{
    Sheet sheet;
    sheet.painter.text({100.0, 50.0}, "N < 0 & \"V\"",
                       {.size = 20.0, .weight = ui::Weight::Bold, .anchor = ui::Anchor::TopLeft});
    const std::string svg = ui::svg_document(sheet.painter.picture(), sheet.fonts, ui::rgb(0xFFFFFF));
    CHECK(svg.find(">N &lt; 0 &amp; &quot;V&quot;</text>") != std::string::npos);
    CHECK(svg.find("font-weight=\"bold\"") != std::string::npos);
    const double width = sheet.fonts.measure("N < 0 & \"V\"", 20.0, ui::Weight::Bold).width;
    const auto at = svg.find("textLength=\"");
    REQUIRE(at != std::string::npos);
    CHECK(std::stod(svg.substr(at + 12)) == Approx(width).epsilon(1e-3));
}

TEST_CASE("SVG turns text clockwise where we turn it counter-clockwise, about the same point")
{
    Sheet sheet;
    sheet.painter.text({100.0, 50.0}, "up", {.rotation = std::numbers::pi / 2.0});
    const std::string svg = ui::svg_document(sheet.painter.picture(), sheet.fonts, ui::rgb(0xFFFFFF));
    CHECK(svg.find("transform=\"rotate(-90 100 50)\"") != std::string::npos);
}

TEST_CASE("SVG is valid whatever bytes a string has")
{
    Sheet sheet;
    sheet.painter.text({1.0, 1.0}, "a\x01\xFF", {});
    const std::string svg = ui::svg_document(sheet.painter.picture(), sheet.fonts, ui::rgb(0xFFFFFF));
    CHECK(svg.find(">a \xEF\xBF\xBD</text>") != std::string::npos);
}

namespace {

std::shared_ptr<const ui::Photo> gray_photo(const std::string& file)
{
    ui::Image image{.width = 3, .height = 2, .pixels = {}, .version = 1, .kind = ui::PixelKind::Color};
    image.pixels.assign(24, 128);
    return std::make_shared<const ui::Photo>(ui::Photo{image, file, "image/png"});
}

constexpr ui::ImagePlace beneath{.corner = {10.0, 20.0}, .right = {30.0, -4.0}, .down = {4.0, 30.0}, .opacity = 0.5};

} // namespace

TEST_CASE("SVG and the golden text say where a photo lies, and SVG holds its file")
{
    Sheet sheet;
    sheet.painter.photo(gray_photo("Man"), beneath);
    const std::string svg = ui::svg_document(sheet.painter.picture(), sheet.fonts, ui::rgb(0xFFFFFF));
    CHECK(svg.find(R"_(<image width="1" height="1" preserveAspectRatio="none" transform="matrix(30 -4 4 30 10 20)" )_"
                   R"_(opacity="0.5" href="data:image/png;base64,TWFu"/>)_") != std::string::npos);
    CHECK(ui::golden_text(sheet.painter.picture()) ==
          "sheet 400 x 300, 0 lines, 0 areas, 0 strings, 0 refused\n"
          "(10.0, 20.0) image of 3 x 2 pixels, right (30.0, -4.0), down (4.0, 30.0), opacity 50%\n");
}

TEST_CASE("A file whose length is no multiple of three is filled up as RFC 4648 says")
{
    for (const auto& [file, text] : {std::pair("M", "TQ=="), std::pair("Ma", "TWE=")}) {
        Sheet sheet;
        sheet.painter.photo(gray_photo(file), beneath);
        const std::string svg = ui::svg_document(sheet.painter.picture(), sheet.fonts, ui::rgb(0xFFFFFF));
        CHECK(svg.find("base64," + std::string(text) + "\"/>") != std::string::npos);
    }
}

TEST_CASE("A photo without a place or more than opaque is left out and counted, one that nobody would see is not")
{
    Sheet sheet;
    ui::ImagePlace nowhere = beneath, opaque = beneath, flat = beneath;
    nowhere.corner.x = std::numeric_limits<double>::quiet_NaN();
    opaque.opacity = 1.5;
    flat.down = 2.0 * flat.right;
    for (const ui::ImagePlace& place : {nowhere, opaque, flat}) sheet.painter.photo(gray_photo("Man"), place);
    CHECK(sheet.painter.picture().n_shapes() == 0);
    CHECK(sheet.painter.picture().n_refused() == 2);
}

TEST_CASE("A PDF holds a photo")
{
    const Folder folder;
    ui::paint_to_pdf(folder.path("plate.pdf"), {.size = {400.0, 300.0}, .title = "Plate"},
                     [](ui::Painter& painter) { painter.photo(gray_photo("Man"), beneath); });
    CHECK(folder.read("plate.pdf").find("/Subtype /Image") != std::string::npos);
}

TEST_CASE("A PDF has a page of 72 points to 96 pixels, and its text can be searched for")
{
    const Folder folder;
    ui::paint_to_pdf(folder.path("portal.pdf"), {.size = {400.0, 300.0}, .title = "Portal"}, [](ui::Painter& painter) {
        painter.text({100.0, 50.0}, "M = 12.5 kN·m", {});
    });
    const std::string pdf = folder.read("portal.pdf");
    CHECK(pdf.starts_with("%PDF-"));
    CHECK(pdf.find("/MediaBox [ 0 0 300 225 ]") != std::string::npos);
    CHECK(pdf.find("/ToUnicode") != std::string::npos); // glyphs name their characters
    CHECK(pdf.find("(Portal)") != std::string::npos);
}

TEST_CASE("A sheet without area, too large or not a number is refused before anything is drawn")
{
    for (const ui::Size size :
         {ui::Size{0.0, 100.0}, ui::Size{100.0, -5.0}, ui::Size{20000.0, 10.0}, ui::Size{not_a_number, 10.0}})
        CHECK_THROWS_AS(ui::paint_to_text({.size = size}, [](ui::Painter&) {}), std::invalid_argument);
    CHECK_THROWS_AS(ui::paint_to_text({.size = {8000.0, 8000.0}, .scale = 3.0}, [](ui::Painter&) {}),
                    std::invalid_argument);
}

TEST_CASE("A file that cannot be written is an error that names it")
{
    const std::filesystem::path nowhere = "tests/no-such-folder/picture";
    const auto nothing = [](ui::Painter&) {};
    for (const bool is_pdf : {false, true}) {
        try {
            if (is_pdf) ui::paint_to_pdf(nowhere, {}, nothing);
            else ui::paint_to_svg(nowhere, {}, nothing);
            FAIL("no error");
        } catch (const std::runtime_error& error) {
            CHECK(std::string(error.what()).find("tests/no-such-folder/picture") != std::string::npos);
        }
    }
}

TEST_CASE("A region reaches surfaces that know no holes as one polygon of the same area")
{
    const ui::Fonts fonts;
    ui::Painter painter({100.0, 100.0}, fonts);
    const std::vector<std::vector<ui::Point>> loops = {{{10.0, 10.0}, {90.0, 10.0}, {90.0, 80.0}, {10.0, 80.0}},
                                                       {{30.0, 30.0}, {50.0, 30.0}, {50.0, 60.0}}};
    painter.region(loops, ui::rgb(0x0072B2));
    const Notes notes = notes_of(painter);
    REQUIRE(notes.areas.size() == 1);
    CHECK(std::abs(ui::twice_area(notes.areas[0])) == Approx(2.0 * 80.0 * 70.0 - 20.0 * 30.0));
}

TEST_SUITE_END();
