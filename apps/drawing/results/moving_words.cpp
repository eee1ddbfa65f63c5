#include "apps/drawing/results/moving_words.h"

#include "apps/drawing/sketch/scene.h"

#include <cstddef>
#include <string_view>

namespace drawing {

namespace {

std::string length_text(const ui::DisplayUnits& units, double value)
{
    return with_minus(units.text(value, ui::Measure::Length));
}

std::string uniform_words(const DrawOptions& options, const ui::DisplayUnits& units,
                          const std::vector<femoop::influence::Stretch>& stretches)
{
    if (stretches.empty()) return options.tr("uniform load nowhere");
    std::string text;
    for (const auto& [from, to] : stretches)
        text += (text.empty() ? "" : ", ") +
                options.tr("s = {from} to {to}", {{"from", length_text(units, from)}, {"to", length_text(units, to)}});
    return options.tr("uniform load on {stretches}", {{"stretches", text}});
}

} // namespace

std::vector<std::string> places_text(const DrawOptions& options, const ui::DisplayUnits& units,
                                     const femoop::influence::LineExtreme& extreme)
{
    std::vector<std::string> places;
    for (std::size_t i = 0; i < extreme.positions.size(); ++i) {
        const std::string place = length_text(units, extreme.positions[i]);
        if (i > 0 && extreme.is_level_after[i - 1]) places.back() += " " + options.tr("to") + " " + place;
        else places.push_back(place);
    }
    return places;
}

std::string paragraph(const std::string& title, const std::vector<std::string>& lines)
{
    std::string text = title + ".\n";
    for (const std::string& line : lines) text += "  " + line + ".\n";
    return text;
}

std::string leading_axle_words(const DrawOptions& options, const ui::DisplayUnits& units, double position,
                               bool is_reversed)
{
    const std::string said = options.tr("leading axle at s = {place}", {{"place", length_text(units, position)}});
    return is_reversed ? said + ", " + options.tr("running backwards") : said;
}

std::string with_places(std::string sentence, const DrawOptions& options, const ui::DisplayUnits& units,
                        const femoop::influence::Placing& placing, bool has_axles, bool has_uniform)
{
    std::string_view before = ": ";
    const auto add = [&](const std::string& part) {
        sentence.append(before).append(part);
        before = "; ";
    };
    if (placing.position) add(leading_axle_words(options, units, *placing.position, placing.reversed));
    else if (has_axles) add(options.tr("no axle on the path"));
    if (has_uniform) add(uniform_words(options, units, placing.uniform));
    for (const auto& place : placing.concentrated)
        if (place) add(options.tr("single force at s = {place}", {{"place", length_text(units, *place)}}));
    return sentence;
}

} // namespace drawing
