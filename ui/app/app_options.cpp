#include "ui/app/app_options.h"

#include <cstdlib>

#include "ui/text/number_format.h"

namespace ui {

namespace {

Size parse_size(const std::string& program, const std::string& text)
{
    const std::size_t cross = text.find('x');
    if (cross != std::string::npos) {
        const auto width = number_typed(text.substr(0, cross));
        const auto height = number_typed(text.substr(cross + 1));
        const auto is_side = [](const std::optional<double>& side) {
            return side && *side >= Settings::smallest_side && *side <= Settings::largest_side;
        };
        if (is_side(width) && is_side(height)) return {*width, *height};
    }
    throw OptionsEnd::mistake(program + ": --size: found \"" + text +
                              "\", wanted WxH with sides from 200 to 16384, like 1280x800");
}

double parse_scale(const std::string& program, const std::string& text)
{
    const auto scale = number_typed(text);
    if (scale && *scale >= 0.5 && *scale <= 4.0) return *scale;
    throw OptionsEnd::mistake(program + ": --scale: found \"" + text + "\", wanted a number from 0.5 to 4");
}

// The language of the system, where it is one of ours.
Language system_language()
{
    for (const char* name : {"LC_ALL", "LC_MESSAGES", "LANG"}) {
        const char* const value = std::getenv(name);
        if (value != nullptr && *value != '\0') return language_named(value).value_or(Language::English);
    }
    return Language::English;
}

std::filesystem::path png_named(const std::string& program, const std::string& text)
{
    if (text.ends_with(".png")) return text;
    throw OptionsEnd::mistake(program + ": --screenshot: found \"" + text + "\", wanted a name that ends with .png");
}

/// Adds options whose values are texts that are understood at once.
class TextOptions {
public:
    TextOptions(CommandLine& line, AppOptions& options) : line_(line), options_(options) {}

    void add_document(const OptionWords& words)
    {
        line_.words_of_files = words.files;
        line_.take_files = [&to = options_](const auto& files) { to.files.assign(files.begin(), files.end()); };
        add("--screenshot", "PNG", "draw one picture of the window to this PNG file and leave; needs no display",
            [program = name()](AppOptions& to, const std::string& text) { to.screenshot = png_named(program, text); });
        add_flag("--describe", options_.describe, words.describe);
        add_flag("--bare", options_.is_bare, "show the picture and its tools, without menus and panels");
        add_flag("--no-tools", options_.has_no_tools, "show no bar of tools");
        add_flag("--still", options_.is_still,
                 "nothing moves by itself: mechanisms rest displaced, steps are done at once");
        add("--link", "FOLDER", "folder in which the program that has started this one offers its changes",
            [](AppOptions& to, const std::string& text) { to.link = text; });
    }

    void add_look()
    {
        add("--size", "WxH", "size of the window in logical pixels, WxH; default as it was left, at first 1280x800",
            [program = name()](AppOptions& to, const std::string& text) {
                to.settings.window = parse_size(program, text);
            });
        add("--scale", "K", "physical pixels of a logical one in a screenshot, 0.5 to 4; default 1",
            [program = name()](AppOptions& to, const std::string& text) { to.scale = parse_scale(program, text); });
        add("--theme", "NAME", "light, dark, print or projector; default as it was left, at first light",
            [option = name() + ": --theme"](AppOptions& to, const std::string& text) {
                to.settings.theme = NamedOption<ThemeName>{option, text, "light, dark, print, projector",
                                                           theme_named(text)}();
            });
        add("--lang", "LANG", "language: en or pt; default as it was left, at first that of the system",
            [option = name() + ": --lang"](AppOptions& to, const std::string& text) {
                to.settings.language = NamedOption<Language>{option, text, "en, pt", language_named(text)}();
            });
    }

    void add_scenario()
    {
        add("--play", "SCENARIO", "play a scenario without a display",
            [](AppOptions& to, const std::string& text) { to.play = text; });
        add("--pictures", "FOLDER", "folder for the pictures of a scenario; default the current one",
            [](AppOptions& to, const std::string& text) { to.pictures = text; });
        add("--frames", "FOLDER", "folder for every frame of a scenario as a PNG file, for a film",
            [](AppOptions& to, const std::string& text) { to.frames = text; });
        line_.options.back().needs = "--play";
    }

private:
    std::string name() const { return line_.program; }

    template <class Take> void add(const char* option, const char* value, const char* words, Take take)
    {
        const auto understand = [&to = options_, take, start = name() + ": " + option](const std::string& text) {
            if (text.empty()) throw OptionsEnd::mistake(start + ": found nothing, wanted a value");
            take(to, text);
        };
        line_.options.push_back({option, value, words, understand});
    }

    void add_flag(const char* option, bool& to, const std::string& words)
    {
        line_.options.push_back({option, "", words, [&to](const std::string&) { to = true; }});
    }

    CommandLine& line_;
    AppOptions& options_;
};

} // namespace

CommandLine app_command_line(const ProgramWords& words, AppOptions& options)
{
    CommandLine line{.program = words.name, .version = words.version, .purpose = words.purpose};
    TextOptions add(line, options);
    add.add_document(words.options);
    add.add_look();
    add.add_scenario();
    return line;
}

void complete(AppOptions& options, const std::optional<DraftFolder>& folder)
{
    if (options.is_bare || options.settings.theme == ThemeName::Projector)
        options.settings.has_panels = false; // as F5 would
    options.asked_for = options.settings;
    if (folder && !options.is_headless())
        options.settings = options.settings.or_else(read_settings(settings_file(*folder)));
    options.settings = options.settings.or_else(
        {.theme = ThemeName::Light, .language = system_language(), .has_panels = true, .window = Size{1280.0, 800.0}});
}

std::filesystem::path settings_file(const DraftFolder& folder) { return folder.path / "settings"; }

void parse_one_file(const ProgramWords& words, AppOptions& options, int argc, const char* const* argv,
                    const std::vector<CommandLine::Option>& own)
{
    CommandLine line = app_command_line(words, options);
    line.options.insert(line.options.end(), own.begin(), own.end());
    read(line, argc, argv);
    if (options.files.size() > 1)
        throw OptionsEnd::mistake(words.name + ": found " + std::to_string(options.files.size()) +
                                  " files, wanted one");
}

} // namespace ui
