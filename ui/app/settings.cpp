#include "ui/app/settings.h"

#include <fstream>
#include <iterator>
#include <sstream>

namespace ui {

namespace {

constexpr std::string_view shown = "shown", hidden = "hidden";

std::optional<bool> has_panels(std::string_view word)
{
    if (word == shown) return true;
    return word == hidden ? std::optional(false) : std::nullopt;
}

std::optional<Size> window_size(std::istream& words)
{
    const auto is_side = [](double side) { return side >= Settings::smallest_side && side <= Settings::largest_side; };
    Size size;
    words >> size.width >> size.height;
    return words && is_side(size.width) && is_side(size.height) ? std::optional(size) : std::nullopt;
}

void understand(const std::string& line, Settings& settings)
{
    std::istringstream words(line);
    std::string name, word;
    words >> name;
    if (name == "window") {
        settings.window = window_size(words);
        return;
    }
    if (name == "unit") {
        UnitChoices choices = settings.unit_choices.value_or(UnitChoices());
        std::string unit;
        words >> word >> unit;
        if (choices.choose(word, unit)) settings.unit_choices = choices;
        return;
    }
    if (name == "tools") {
        settings.tools = std::string(std::istreambuf_iterator<char>(words >> std::ws), {});
        return;
    }
    words >> word;
    if (name == "theme") settings.theme = theme_named(word);
    if (name == "language") settings.language = language_named(word);
    if (name == "units") settings.units = unit_system_named(word);
    if (name == "panels") settings.has_panels = has_panels(word);
}

} // namespace

Settings Settings::or_else(const Settings& others) const
{
    return {.theme = theme ? theme : others.theme,
            .language = language ? language : others.language,
            .units = units ? units : others.units,
            .unit_choices = unit_choices ? unit_choices : others.unit_choices,
            .has_panels = has_panels ? has_panels : others.has_panels,
            .window = window ? window : others.window,
            .tools = tools ? tools : others.tools};
}

template <class Value> void ChosenSettings::update(std::optional<Value> Settings::*setting, const Settings& now)
{
    std::optional<Value>& asked = asked_for_.*setting;
    if (asked && asked == now.*setting) return;
    asked.reset();
    chosen_.*setting = now.*setting;
}

const Settings& ChosenSettings::update(const Settings& now)
{
    update(&Settings::theme, now);
    update(&Settings::language, now);
    update(&Settings::units, now);
    update(&Settings::unit_choices, now);
    update(&Settings::has_panels, now);
    update(&Settings::window, now);
    update(&Settings::tools, now);
    return chosen_;
}

std::string settings_text(const Settings& settings)
{
    std::ostringstream lines;
    if (settings.theme) lines << "theme " << text(*settings.theme) << '\n';
    if (settings.language) lines << "language " << code(*settings.language) << '\n';
    if (settings.units) lines << "units " << code(*settings.units) << '\n';
    if (settings.unit_choices)
        for (const QuantityUnits& quantity : chosen_quantities())
            if (const auto unit = settings.unit_choices->of(quantity.measure); !unit.empty())
                lines << "unit " << quantity.code << ' ' << unit << '\n';
    if (settings.has_panels) lines << "panels " << (*settings.has_panels ? shown : hidden) << '\n';
    if (settings.window) lines << "window " << settings.window->width << ' ' << settings.window->height << '\n';
    if (settings.tools) lines << "tools " << *settings.tools << '\n';
    return lines.str();
}

Settings settings_of(std::string_view text)
{
    std::istringstream lines{std::string(text)};
    Settings settings;
    for (std::string line; std::getline(lines, line);) understand(line, settings);
    return settings;
}

Settings read_settings(const std::filesystem::path& file)
{
    std::ifstream stream(file, std::ios::binary);
    std::ostringstream text;
    text << stream.rdbuf(); // what cannot be read on, such as a folder's name, is no reason not to begin
    return settings_of(text.str());
}

} // namespace ui
