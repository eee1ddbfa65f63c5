#include "apps/frame/tools/kept_settings.h"

#include <sstream>
#include <variant>

#include "femoop/model/quantity/quantity_parser.h"

namespace frame {

namespace {

constexpr std::string_view on = "on", off = "off";

std::string_view word_of(bool is_on) { return is_on ? on : off; }

void understand(const std::string& word, bool& is_on)
{
    if (word == on || word == off) is_on = word == on;
}

} // namespace

std::optional<double> typed_spacing(const ToolSettings& settings, const femoop::Units& units)
{
    if (settings.spacing.empty()) return std::nullopt;
    const auto read = femoop::parse_quantity(settings.spacing, femoop::dimension::length, units);
    const double* const value = std::get_if<double>(&read);
    return value != nullptr && *value > 0.0 ? std::optional(*value) : std::nullopt;
}

std::string kept_words(const ToolSettings& settings)
{
    std::ostringstream words;
    words << "grid " << word_of(settings.draws_to_grid) << ' ';
    if (!settings.spacing.empty()) words << settings.spacing << ' ';
    words << "snap " << word_of(settings.draws_to_parts);
    return words.str();
}

void take_up(ToolSettings& settings, std::string_view words)
{
    std::istringstream list{std::string(words)};
    std::string name, grid, rest, snap;
    list >> name >> grid;
    if (name != "grid") return;
    settings.spacing.clear();
    while (list >> rest && rest != "snap") settings.spacing += (settings.spacing.empty() ? "" : " ") + rest;
    list >> snap;
    understand(grid, settings.draws_to_grid);
    understand(snap, settings.draws_to_parts);
}

} // namespace frame
