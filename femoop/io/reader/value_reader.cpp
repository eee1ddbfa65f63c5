#include "femoop/io/reader/value_reader.h"

#include <algorithm>
#include <utility>
#include <variant>

#include "femoop/model/check/suggestion.h"
#include "femoop/model/fault/translator.h"

namespace femoop {

namespace {

// An array's value has no key of its own: then the place is the array's entry already.
std::string text_of(const Place& place, JsonValue value) { return place.text(value.key()); }

/// As much of a text as a message has room for, cut between characters.
std::string_view beginning(std::string_view text)
{
    constexpr std::size_t longest = 40;
    std::size_t end = std::min(text.size(), longest);
    while (end < text.size() && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) ++end;
    return text.substr(0, end);
}

std::string joined(const std::vector<std::string_view>& names)
{
    std::string text;
    for (const std::string_view name : names) text += (text.empty() ? "" : ", ") + std::string(name);
    return text;
}

const ValueReader::Wanted object{name(JsonKind::Object), "{\"...\": ...}"};

std::string example(Dimension dimension, const Units& units)
{
    const std::string unit = unit_text(dimension, units);
    return unit.empty() ? "1.5" : "\"1.5 " + unit + '"';
}

} // namespace

void ValueReader::wrong_type(JsonValue value, const Wanted& wanted, const Place& place)
{
    const bool is_text = value.is(JsonKind::String);
    add({is_text ? FaultKind::WrongTypeText : FaultKind::WrongType,
         {text_of(place, value), is_text ? quoted_json(beginning(value.text())) : std::string(name(value.kind())),
          std::string(wanted.words), std::string(wanted.example)}});
}

void ValueReader::not_an_object(JsonValue value, const Place& own_place)
{
    if (!value.is_present()) return;
    add({FaultKind::WrongType,
         {own_place.text(), std::string(name(value.kind())), std::string(object.words), std::string(object.example)}});
}

void ValueReader::unknown_key(JsonValue value, const std::vector<std::string_view>& known, const Place& place)
{
    constexpr std::size_t patience = 1000; // a file with so many mistakes is of another kind
    auto near = n_troubles() < patience ? nearest(value.key(), known) : std::nullopt;
    if (near) add({FaultKind::UnknownKeyNear, {text_of(place, value), std::move(*near)}});
    else add({FaultKind::UnknownKey, {text_of(place, value), joined(known)}});
}

void ValueReader::missing_key(std::string_view key, const Place& place)
{
    add({FaultKind::MissingKey, {place.text(), std::string(key)}});
}

bool ValueReader::is_object(JsonValue value, const Place& place)
{
    if (value.is_present() && !value.is(JsonKind::Object)) wrong_type(value, object, place);
    return value.is(JsonKind::Object);
}

bool ValueReader::is_list(JsonValue value, const Place& place)
{
    if (value.is_present() && !value.is(JsonKind::Array)) wrong_type(value, {name(JsonKind::Array), "[...]"}, place);
    return value.is(JsonKind::Array);
}

std::optional<std::string> ValueReader::text(JsonValue value, const Place& place)
{
    if (!value.is_present()) return std::nullopt;
    if (value.is(JsonKind::String)) return std::string(value.text());
    wrong_type(value, {name(JsonKind::String), "\"...\""}, place);
    return std::nullopt;
}

std::string ValueReader::id(JsonValue value, const Place& place)
{
    const auto id = text(value, place);
    if (id && id->empty()) add({FaultKind::EmptyId, {place.text()}});
    return id.value_or("");
}

std::optional<double> ValueReader::number(JsonValue value, const Place& place)
{
    if (!value.is_present()) return std::nullopt;
    if (value.is(JsonKind::Number)) return value.number();
    wrong_type(value, {name(JsonKind::Number), "1.5"}, place);
    return std::nullopt;
}

bool ValueReader::boolean(JsonValue value, const Place& place)
{
    if (value.is_present() && !value.is(JsonKind::Boolean)) wrong_type(value, {name(JsonKind::Boolean), "true"}, place);
    return value.is(JsonKind::Boolean) && value.boolean();
}

std::optional<Quantity> ValueReader::quantity(JsonValue value, Dimension dimension, const Place& place, AngleUnit angle)
{
    if (!value.is_present()) return std::nullopt;
    if (value.is(JsonKind::Number)) return Quantity(value.number());
    if (!value.is(JsonKind::String)) {
        wrong_type(value, {translatable("a number, or a text with a unit"), example(dimension, units_)}, place);
        return Quantity(no_number);
    }
    auto parsed = parse_quantity(value.text(), dimension, units_, angle);
    if (const double* const number = std::get_if<double>(&parsed)) return Quantity(*number, std::string(value.text()));
    auto& fault = std::get<Fault>(parsed);
    fault.arguments.front() = text_of(place, value);
    add(std::move(fault));
    return Quantity(no_number);
}

std::optional<std::size_t> ValueReader::choice(JsonValue value, const std::vector<std::string_view>& choices,
                                               const Place& place)
{
    const auto typed = text(value, place);
    if (!typed) return std::nullopt;
    const auto found = std::find(choices.begin(), choices.end(), *typed);
    if (found != choices.end()) return static_cast<std::size_t>(found - choices.begin());
    unknown_choice(text_of(place, value), *typed, choices);
    return std::nullopt;
}

void ValueReader::unknown_choice(std::string place, std::string found, const std::vector<std::string_view>& choices)
{
    const auto near = nearest(found, choices);
    std::vector<std::string> details{std::move(place), std::move(found), joined(choices)};
    if (near) details.push_back(*near);
    add({near ? FaultKind::UnknownChoiceNear : FaultKind::UnknownChoice, std::move(details)});
}

} // namespace femoop
