#include "apps/frame/window/options.h"

#include <CLI/CLI.hpp>

#include <cstdlib>
#include <sstream>

#include "ui/text/number_format.h"

namespace frame {

namespace {

constexpr int bad_arguments = 2;
constexpr double smallest_side = 200.0, largest_side = 16384.0;

ui::Size parse_size(const std::string& text)
{
    const std::size_t cross = text.find('x');
    if (cross != std::string::npos) {
        const auto width = ui::number_typed(text.substr(0, cross));
        const auto height = ui::number_typed(text.substr(cross + 1));
        const auto is_side = [](const std::optional<double>& side) {
            return side && *side >= smallest_side && *side <= largest_side;
        };
        if (is_side(width) && is_side(height)) return {*width, *height};
    }
    throw OptionsEnd("frame: --size: found \"" + text + "\", wanted WxH with sides from 200 to 16384, like 1280x800",
                     bad_arguments);
}

template <class Value>
Value wanted(const std::optional<Value>& value, const std::string& option, const std::string& found, const char* list)
{
    if (!value)
        throw OptionsEnd("frame: " + option + ": found \"" + found + "\", wanted one of " + list, bad_arguments);
    return *value;
}

// The language of the system, where it is one of ours.
ui::Language system_language()
{
    for (const char* name : {"LC_ALL", "LC_MESSAGES", "LANG"}) {
        const char* const value = std::getenv(name);
        if (value != nullptr && *value != '\0') return ui::language_named(value).value_or(ui::Language::English);
    }
    return ui::Language::English;
}

std::filesystem::path png_named(const std::string& text)
{
    if (text.ends_with(".png")) return text;
    throw OptionsEnd("frame: --screenshot: found \"" + text + "\", wanted a name that ends with .png", bad_arguments);
}

} // namespace

Options parse_options(int argc, const char* const* argv)
{
    Options options;
    options.language = system_language();
    std::vector<std::string> files;
    std::string screenshot, play, pictures = ".", frames, size, theme, language, units, show, load_case;
    CLI::App app(
        "Shows a frame, truss or grillage at work: loads, supports, N, V, M, deformed shape; every number can be "
        "changed and the results follow.",
        "frame");
    app.set_version_flag("--version", "frame " CREMONA_VERSION);
    app.add_option("FILE", files, "model files (.json) to open, each in a tab")->option_text("...");
    app.add_option("--screenshot", screenshot,
                   "draw one picture of the window to this PNG file and leave; needs no display")
        ->option_text("PNG");
    app.add_flag("--describe", options.describe,
                 "print the model and its results in words and leave; needs no display");
    app.add_option("--size", size, "size of the window in logical pixels, WxH; default 1280x800")->option_text("WxH");
    app.add_option("--scale", options.scale, "physical pixels of a logical one in a screenshot, 0.5 to 4; default 1")
        ->check(CLI::Range(0.5, 4.0))
        ->option_text("K");
    app.add_option("--theme", theme, "light, dark, print or projector")->option_text("NAME");
    app.add_option("--lang", language, "language: en or pt; default that of the system")->option_text("LANG");
    app.add_option("--units", units, "units shown: file, si, kn-m, kn-cm or us")->option_text("NAME");
    app.add_option("--show", show, "what the picture shows, such as loads,N,V,M,deformed,reactions,labels")
        ->option_text("LIST");
    app.add_option("--case", load_case, "load case or combination to show; default the first")->option_text("ID");
    app.add_option("--play", play, "play a scenario without a display")->option_text("SCENARIO");
    app.add_option("--pictures", pictures, "folder for the pictures of a scenario; default the current one")
        ->option_text("FOLDER");
    app.add_option("--frames", frames, "folder for every frame of a scenario as a PNG file, for a film")
        ->needs("--play")
        ->option_text("FOLDER");
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& end) {
        std::ostringstream text;
        const int status = app.exit(end, text, text);
        throw OptionsEnd(text.str(), status == 0 ? 0 : bad_arguments);
    }
    options.files.assign(files.begin(), files.end());
    if (!screenshot.empty()) options.screenshot = png_named(screenshot);
    if (!play.empty()) options.play = play;
    options.pictures = pictures;
    if (!frames.empty()) options.frames = frames;
    if (options.is_headless() && files.size() > 1)
        throw OptionsEnd("frame: found " + std::to_string(files.size()) +
                             " files, wanted one: only a window has room for several",
                         bad_arguments);
    if (!size.empty()) options.size = parse_size(size);
    if (!theme.empty())
        options.theme = wanted(ui::theme_named(theme), "--theme", theme, "light, dark, print, projector");
    if (!language.empty()) options.language = wanted(ui::language_named(language), "--lang", language, "en, pt");
    if (!units.empty())
        options.units = wanted(ui::unit_system_named(units), "--units", units, "file, si, kn-m, kn-cm, us");
    if (!load_case.empty()) options.load_case = load_case;
    try {
        if (!show.empty()) options.show = parse_show(show);
    } catch (const ShowError& error) {
        throw OptionsEnd(std::string("frame: ") + error.what(), bad_arguments);
    }
    return options;
}

} // namespace frame
