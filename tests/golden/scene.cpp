#include "tests/golden/scene.h"

#include "tests/browser_build.h"
#include "tests/golden/gallery.h"
#include "tests/golden/text_alone.h"
#include "ui/context/gl.h"
#include "ui/context/rasterize.h"
#include "ui/paint/surface/golden_text.h"

#include <doctest/doctest.h>

#include <cstdlib>
#include <string_view>

namespace golden {

namespace {

#if defined(__has_feature)
#define HAS_FEATURE(name) __has_feature(name)
#else
#define HAS_FEATURE(name) 0
#endif
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) || HAS_FEATURE(address_sanitizer)
constexpr bool is_sanitized = true;
#else
constexpr bool is_sanitized = false;
#endif

std::string environment(const char* variable)
{
    const char* value = std::getenv(variable);
    return value ? value : "";
}

bool is_text_alone() { return is_for_browser || environment("CREMONA_PICTURES") == "text"; }
bool is_drawn_only() { return is_sanitized || environment("CREMONA_PICTURES") == "draw"; }

void judge(Exhibit exhibit)
{
    if (is_drawn_only()) return;
    if (is_text_alone() || text_alone(CREMONA_SOURCE_DIR "/tests/golden/text_alone.txt").contains(exhibit.name))
        exhibit.pixels.reset();
    const Gallery gallery(CREMONA_SOURCE_DIR "/tests/golden/pictures", CREMONA_BINARY_DIR "/pictures");
    const Verdict verdict = gallery.judge(exhibit);
    CHECK_MESSAGE(verdict.is_good, verdict.words);
}

} // namespace

Machine this_machine()
{
    const std::string ci = environment("CI");
    return ci.empty() || ci == "false" ? Machine::Laptop : Machine::BuildServer;
}

std::optional<ui::Pixels> if_drawn(const std::function<ui::Pixels()>& draw, Machine machine)
{
    try {
        return draw();
    } catch (const ui::ContextError& error) {
        if (machine == Machine::BuildServer) FAIL_CHECK("pictures cannot be compared: ", std::string(error.what()));
        else MESSAGE("the picture is not compared: ", std::string(error.what()));
        return std::nullopt;
    }
}

ui::Offscreen offscreen(const ui::Offscreen::Setup& setup)
{
    return is_text_alone() ? ui::Offscreen(setup, ui::OffscreenKind::Empty) : ui::Offscreen(setup);
}

std::optional<ui::Pixels> drawn(const ui::Picture& picture, const ui::Fonts& fonts, const ui::Sheet& sheet)
{
    const ui::Raster raster{.scale = sheet.scale, .background = sheet.background};
    return if_drawn([&] { return ui::rasterized(picture, fonts, raster); });
}

void check_scene(const std::string& name, const ui::Sheet& sheet, const ui::Drawing& drawing)
{
    const ui::Fonts fonts;
    const ui::Picture picture = ui::painted(sheet, fonts, drawing);
    judge({name, ui::golden_text(picture), drawn(picture, fonts, sheet)});
}

void check_picture(const std::string& name, const ui::Pixels& pixels, const std::string& text)
{
    judge({name, text, pixels});
}

} // namespace golden
