#include "femoop/io/plane/field_reader.h"

#include <cmath>
#include <utility>

#include "femoop/io/plane/plane_names.h"

namespace femoop::plane {

namespace {

constexpr Keys<1> polynomial_keys{{"polynomial"}, 1};
constexpr Keys<3> table_keys{{"along", "table", "about"}, 2};

Dimension per_length(Dimension dimension, int power)
{
    dimension.length = static_cast<std::int8_t>(dimension.length - power);
    return dimension;
}

std::optional<int> power(JsonValue value)
{
    if (!value.is(JsonKind::Number)) return std::nullopt;
    const double number = value.number();
    if (!(number >= 0.0 && number <= Field::highest_power) || number != std::floor(number)) return std::nullopt;
    return static_cast<int>(number);
}

} // namespace

std::vector<Quantity> FieldReader::location(JsonValue value, const Place& place)
{
    std::vector<Quantity> at;
    if (!value.is_present()) return at;
    if (!value.is(JsonKind::Array) || value.size() != 2) {
        reader_.add({FaultKind::CheckPlaceSize, {place.text(value.key())}});
        return at;
    }
    const Place here = place.key(value.key());
    for (std::size_t i = 0; const JsonValue entry : value)
        at.push_back(reader_.quantity(entry, dimension::length, here.entry(i++)).value_or(no_number));
    return at;
}

std::optional<Field> FieldReader::field_value(JsonValue value, Dimension dimension, const Place& place)
{
    if (!value.is_present()) return std::nullopt;
    if (value.is(JsonKind::Array)) return Field{ends(value, dimension, place)};
    if (!value.is(JsonKind::Object)) {
        if (value.is(JsonKind::Number) || value.is(JsonKind::String))
            return Field{reader_.quantity(value, dimension, place).value_or(no_number)};
        reader_.wrong_type(value, {translatable("a number, two at the ends, a polynomial or a table"), "[1.5, 3]"},
                           place);
        return Field{Quantity(no_number)};
    }
    const Place here = place.key(value.key());
    if (const JsonValue terms = field(value, "polynomial"); terms.is_present()) {
        reader_.fields(value, polynomial_keys, here);
        return Field{polynomial(terms, dimension, here)};
    }
    const auto [along, rows, about] = reader_.fields(value, table_keys, here);
    return Field{table(about, along, rows, dimension, here)};
}

Field::Ends FieldReader::ends(JsonValue value, Dimension dimension, const Place& place)
{
    const Place here = place.key(value.key());
    Field::Ends ends{Quantity(no_number), Quantity(no_number)};
    if (value.size() != 2) {
        reader_.add({FaultKind::FieldEndsSize, {here.text(), std::to_string(value.size())}});
        return ends;
    }
    std::size_t i = 0;
    for (const JsonValue entry : value) {
        (i == 0 ? ends.start : ends.end) = reader_.quantity(entry, dimension, here.entry(i)).value_or(no_number);
        ++i;
    }
    return ends;
}

Field::Polynomial FieldReader::polynomial(JsonValue value, Dimension dimension, const Place& place)
{
    Field::Polynomial terms;
    if (value.is(JsonKind::Array) && value.size() == 0) reader_.add({FaultKind::EmptyField, {place.text(value.key())}});
    for_each(value, place, [&](JsonValue entry, const Place& own_place) {
        if (auto found = term(entry, dimension, own_place)) terms.push_back(std::move(*found));
    });
    return terms;
}

std::optional<Field::Term> FieldReader::term(JsonValue value, Dimension dimension, const Place& place)
{
    std::vector<JsonValue> parts;
    for (const JsonValue part : value) parts.push_back(part);
    const bool is_triple = value.is(JsonKind::Array) && parts.size() == 3;
    const std::optional<int> i = is_triple ? power(parts[1]) : std::nullopt;
    const std::optional<int> j = is_triple ? power(parts[2]) : std::nullopt;
    if (!i || !j) {
        reader_.add({FaultKind::PolynomialTerm, {place.text()}});
        return std::nullopt;
    }
    return Field::Term{reader_.quantity(parts[0], per_length(dimension, *i + *j), place.entry(0)).value_or(no_number),
                       *i, *j};
}

Field::Table FieldReader::table(JsonValue about, JsonValue along, JsonValue rows, Dimension dimension,
                                const Place& place)
{
    Field::Table table;
    if (const auto chosen = reader_.choice(along, names::along, place))
        table.along = static_cast<Field::Along>(*chosen);
    table.about = location(about, place);
    if (rows.is(JsonKind::Array) && rows.size() == 0) reader_.add({FaultKind::EmptyField, {place.text(rows.key())}});
    for_each(rows, place, [&](JsonValue entry, const Place& own_place) {
        if (!entry.is(JsonKind::Array) || entry.size() != 2) {
            reader_.add({FaultKind::TableRow, {own_place.text()}});
            return;
        }
        auto part = entry.begin();
        Quantity at = reader_.quantity(*part, dimension::length, own_place.entry(0)).value_or(no_number);
        Quantity value = reader_.quantity(*++part, dimension, own_place.entry(1)).value_or(no_number);
        if (!table.rows.empty() && table.rows.back().first >= at)
            reader_.add({FaultKind::TableNotAscending, {own_place.text()}});
        table.rows.emplace_back(std::move(at), std::move(value));
    });
    return table;
}

} // namespace femoop::plane
