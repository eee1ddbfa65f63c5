#include "femoop/methods/mohr/typed_components.h"

#include <charconv>
#include <cmath>
#include <optional>

#include "femoop/model/quantity/quantity_parser.h"

namespace femoop::mohr {

namespace {

constexpr double largest_typed = 1e100, least_typed = 1e-100;
constexpr Units base{.length = LengthUnit::mm, .force = ForceUnit::N};

struct Split {
    double number = 0.0;
    std::string unit;
};

/// The number that a text begins with, and what stands behind it.
std::optional<Split> split(std::string_view text)
{
    while (text.starts_with(' ')) text.remove_prefix(1);
    if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
    Split result;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), result.number);
    if (error != std::errc() || !std::isfinite(result.number)) return std::nullopt;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    while (text.starts_with(' ')) text.remove_prefix(1);
    while (text.ends_with(' ')) text.remove_suffix(1);
    result.unit = text;
    return result;
}

bool is_out_of_range(double value)
{
    return std::abs(value) > largest_typed || (value != 0.0 && std::abs(value) < least_typed);
}

Fault fault_in(Fault fault, const std::string& place)
{
    fault.arguments.front() = place;
    return fault;
}

/// One text counted in `unit`, or in its own where that is "".
std::variant<double, Fault> value_in(const std::string& text, std::string& unit, Dimension dimension)
{
    const auto typed = split(text);
    const auto in_base = parse_quantity(text, dimension, base);
    const bool is_bare = typed && typed->unit.empty();
    const bool needs_unit = !unit.empty() && dimension != dimension::none;
    if (is_bare && (!needs_unit || typed->number == 0.0)) return typed->number;
    if (const auto* fault = std::get_if<Fault>(&in_base)) return *fault;
    if (!typed) return std::get<double>(in_base); // such as .5: the parser of quantities is the more patient
    if (unit.empty()) unit = typed->unit;
    if (typed->unit == unit) return typed->number;
    return std::get<double>(in_base) / std::get<double>(parse_quantity("1 " + unit, dimension, base));
}

/// The first unit among the texts.
std::string first_unit(std::span<const std::string> texts)
{
    for (const std::string& text : texts)
        if (const auto typed = split(text); typed && !typed->unit.empty()) return typed->unit;
    return "";
}

} // namespace

std::variant<Components, Fault> parse_components(std::span<const std::string> texts,
                                                 std::span<const std::string_view> names, std::string_view place,
                                                 Dimension dimension)
{
    Components result{{}, first_unit(texts)};
    for (std::size_t i = 0; i < texts.size(); ++i) {
        const std::string where = std::string(place) + (names[i].empty() ? "" : " " + std::string(names[i]));
        const auto value = value_in(texts[i], result.unit, dimension);
        if (const auto* fault = std::get_if<Fault>(&value)) return fault_in(*fault, where);
        result.values.push_back(std::get<double>(value));
        if (is_out_of_range(result.values.back())) return Fault{FaultKind::QuantityTooLarge, {where, texts[i]}};
    }
    return result;
}

} // namespace femoop::mohr
