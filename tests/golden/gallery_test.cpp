#include "tests/folder.h"
#include "tests/golden/comparison.h"
#include "tests/golden/gallery.h"
#include "tests/golden/scene.h"
#include "tests/golden/text_alone.h"
#include "tests/golden/webp.h"
#include "tests/source_folder.h"
#include "ui/context/gl.h"
#include "ui/paint/painter.h"
#include "ui/paint/surface/golden_text.h"

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>

namespace {

/// A small sheet with one reading on it; without pixels where there is no renderer.
golden::Exhibit reading(const std::string& words)
{
    const ui::Fonts fonts;
    ui::Painter painter({160.0, 60.0}, fonts);
    painter.line({10.0, 45.0}, {150.0, 45.0}, {.color = ui::rgb(0x1E2329), .width = 3.0});
    painter.text({80.0, 25.0}, words, {.color = ui::rgb(0x0072B2)});
    return {"reading", ui::golden_text(painter.picture()), golden::drawn(painter.picture(), fonts, {})};
}

ui::Pixels gray(std::uint8_t level)
{
    ui::Pixels pixels{{3, 2}, std::vector<std::uint8_t>(24, level)};
    for (std::size_t i = 3; i < pixels.rgba.size(); i += 4) pixels.rgba[i] = 255;
    return pixels;
}

} // namespace

TEST_SUITE_BEGIN("golden pictures");

TEST_CASE("One wrong digit is seen in the picture and in the text")
{
    const auto right = reading("12.50 kN"), wrong = reading("12.51 kN");
    if (!right.pixels) return;
    CHECK(golden::compare(*right.pixels, *right.pixels).is_same());
    CHECK_FALSE(golden::compare(*wrong.pixels, *right.pixels).is_same());
    CHECK(golden::compare(*wrong.pixels, *right.pixels).n_differing >= 5);
    CHECK(golden::first_difference(wrong.text, right.text) ==
          "line 2: found (80.0, 25.0) center 13 \"12.51 kN\", wanted (80.0, 25.0) center 13 \"12.50 kN\"");
}

TEST_CASE("A channel may be off by 8 and not by 9, even in one pixel")
{
    ui::Pixels found = gray(100);
    found.at(2, 1)[1] = 108;
    CHECK(golden::compare(found, gray(100)).is_same());
    found.at(2, 1)[1] = 91;
    const auto result = golden::compare(found, gray(100));
    CHECK_FALSE(result.is_same());
    CHECK(result.n_differing == 1);
    CHECK(result.largest == 9);
}

TEST_CASE("Pictures of other sizes are never the same")
{
    ui::Pixels wide = gray(100);
    wide.size = {6, 1};
    CHECK_FALSE(golden::compare(wide, gray(100)).is_same());
}

TEST_CASE("A failing picture leaves new, reference, difference, text and pages behind, a good one takes them away")
{
    const Folder references, failures;
    const golden::Gallery gallery(references.path(), failures.path());
    const auto right = reading("12.50 kN"), wrong = reading("12.51 kN");
    if (!right.pixels) return;
    golden::write_webp(references.path() / "reading.webp", *right.pixels);
    std::ofstream(references.path() / "reading.txt") << right.text;

    CHECK(gallery.judge(right).is_good);
    const auto verdict = gallery.judge(wrong);
    CHECK_FALSE(verdict.is_good);
    CHECK(verdict.words.find("pixels differ") != std::string::npos);
    for (const char* file : {"reading.new.png", "reading.new.webp", "reading.reference.png", "reading.difference.png",
                             "reading.new.txt", "reading.html", "index.html"}) {
        CAPTURE(file);
        CHECK(std::filesystem::exists(failures.path() / file));
    }
    CHECK(golden::compare(ui::read_png(failures.path() / "reading.new.png"), *wrong.pixels).is_same());

    CHECK(gallery.judge(right).is_good);
    CHECK_FALSE(std::filesystem::exists(failures.path() / "reading.new.png"));
    CHECK_FALSE(std::filesystem::exists(failures.path() / "reading.html"));
}

TEST_CASE("A picture without a reference fails and shows itself")
{
    const Folder references, failures;
    const golden::Gallery gallery(references.path(), failures.path());
    const auto exhibit = reading("12.50 kN");
    if (!exhibit.pixels) return;
    const auto verdict = gallery.judge(exhibit);
    CHECK_FALSE(verdict.is_good);
    CHECK(verdict.words.find("there is no reference picture") != std::string::npos);
    CHECK(std::filesystem::exists(failures.path() / "reading.new.png"));
}

namespace {

ui::Pixels without_renderer() { throw ui::ContextError("no off-screen renderer"); }

} // namespace

TEST_CASE("Without a renderer a laptop skips the picture")
{
    CHECK_FALSE(golden::if_drawn(without_renderer, golden::Machine::Laptop).has_value());
}

TEST_CASE("Without a renderer a build server fails" * doctest::should_fail())
{
    golden::if_drawn(without_renderer, golden::Machine::BuildServer);
}

TEST_CASE("A picture written as PNG is read back to the last bit")
{
    const Folder folder;
    const auto exhibit = reading("θ ≤ 2·10⁻³");
    if (!exhibit.pixels) return;
    ui::write_png(folder.path("picture.png"), *exhibit.pixels);
    CHECK(ui::read_png(folder.path("picture.png")) == *exhibit.pixels);
}

TEST_CASE("A picture written as WebP is read back to the last bit, and a file that is none is refused by its name")
{
    const Folder folder;
    ui::Pixels pixels = gray(100);
    pixels.at(2, 1)[0] = 3;
    golden::write_webp(folder.path("picture.webp"), pixels);
    CHECK(golden::read_webp(folder.path("picture.webp")) == pixels);
    std::ofstream(folder.path("none.webp")) << "RIFF, but no picture";
    CHECK_THROWS_WITH(golden::read_webp(folder.path("none.webp")), doctest::Contains("none.webp cannot be read"));
}

TEST_CASE("A picture is kept without its pixels only where it is listed, beside one of its kind that has them")
{
    const std::filesystem::path golden = source_folder() + "/tests/golden";
    const auto has = [&](const std::string& name) { return std::filesystem::exists(golden / "pictures" / name); };
    const auto kinds = golden::text_alone(golden / "text_alone.txt");
    for (const auto& listed : kinds) {
        const std::string& name = listed.first;
        CAPTURE(name);
        CHECK(has(name + ".txt"));
        CHECK_FALSE(has(name + ".webp"));
        CHECK(has(listed.second + ".webp"));
    }
    for (const auto& entry : std::filesystem::directory_iterator(golden / "pictures")) {
        const std::string name = entry.path().stem().string();
        CAPTURE(name);
        CHECK((has(name + ".webp") || kinds.contains(name)));
    }
}

TEST_SUITE_END();
