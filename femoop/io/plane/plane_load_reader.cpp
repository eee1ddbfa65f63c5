#include <cmath>
#include <utility>

#include "femoop/io/plane/plane_names.h"
#include "femoop/io/plane/plane_reader.h"
#include "femoop/model/quantity/dof_dimension.h"

namespace femoop::plane {

namespace {

constexpr Keys<6> case_keys{{"id", "self_weight", "points", "curves", "regions", "settlements"}, 1};
constexpr Keys<3> point_load_keys{{"point", "fx", "fy"}, 1};
constexpr Keys<5> curve_load_keys{{"curve", "kind", "qx", "qy", "axes"}, 2};
constexpr Keys<3> pressure_keys{{"curve", "kind", "value"}, 3};
constexpr Keys<4> body_keys{{"kind", "region", "bx", "by"}, 1};
constexpr Keys<3> temperature_keys{{"kind", "rise", "region"}, 2};
constexpr Keys<4> rotation_keys{{"kind", "omega", "region", "about"}, 2};
constexpr Keys<4> settlement_keys{{"point", "curve", "ux", "uy"}, 0};
constexpr Keys<1> polynomial_keys{{"polynomial"}, 1};
constexpr Keys<3> table_keys{{"along", "table", "about"}, 2};

constexpr Dimension body_force{.length = -3, .force = 1};
constexpr Dimension angular_velocity{.time = -1, .angle = 1};

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

PlaneLoadCase PlaneReader::load_case(JsonValue value, const Place& place)
{
    const auto [id, self_weight, points, curves, regions, settlements] = reader_.fields(value, case_keys, place);
    PlaneLoadCase load_case;
    load_case.id = reader_.id(id, place);
    unreadable_.load_cases.push_back(load_case.id.empty());
    load_case.self_weight = reader_.number(self_weight, place).value_or(0.0);
    read_parts(*this, points, place, load_case.points, unreadable_.point_loads.emplace_back(),
               &PlaneReader::point_load);
    read_parts(*this, curves, place, load_case.curves, unreadable_.curve_loads.emplace_back(),
               &PlaneReader::curve_load);
    read_parts(*this, regions, place, load_case.regions, unreadable_.region_loads.emplace_back(),
               &PlaneReader::region_load);
    read_parts(*this, settlements, place, load_case.settlements, unreadable_.settlements.emplace_back(),
               &PlaneReader::settlement);
    return load_case;
}

NodeLoad PlaneReader::point_load(JsonValue value, const Place& place)
{
    const auto [point, fx, fy] = reader_.fields(value, point_load_keys, place);
    NodeLoad load;
    load.node = NodeId(reference(point, points_, place));
    if (auto force = reader_.quantity(fx, dimension::force, place)) load.components.push_back({Dof::ux, *force});
    if (auto force = reader_.quantity(fy, dimension::force, place)) load.components.push_back({Dof::uy, *force});
    return load;
}

CurveLoad PlaneReader::curve_load(JsonValue value, const Place& place)
{
    CurveLoad load;
    if (!reader_.is_object(value, place)) return load;
    const JsonValue kind = field(value, "kind");
    if (!kind.is_present()) reader_.missing_key("kind", place);
    const auto chosen = reader_.choice(kind, names::curve_loads, place);
    load.curves = references<CurveId>(field(value, "curve"), curves_, place);
    if (!chosen) return load;
    load.kind = static_cast<CurveLoadKind>(*chosen);
    if (load.kind == CurveLoadKind::Pressure) {
        load.value = field_value(reader_.fields(value, pressure_keys, place)[2], dimension::stress, place);
        return load;
    }
    const Dimension dimension = load.kind == CurveLoadKind::Traction ? dimension::stress : dimension::force_per_length;
    const auto found = reader_.fields(value, curve_load_keys, place);
    load.qx = field_value(found[2], dimension, place);
    load.qy = field_value(found[3], dimension, place);
    load.axes = axes(found[4], place);
    return load;
}

RegionLoad PlaneReader::region_load(JsonValue value, const Place& place)
{
    RegionLoad load;
    if (!reader_.is_object(value, place)) return load;
    const JsonValue kind = field(value, "kind");
    if (!kind.is_present()) reader_.missing_key("kind", place);
    const auto chosen = reader_.choice(kind, names::region_loads, place);
    load.regions = references<RegionId>(field(value, "region"), regions_, place);
    if (!chosen) return load;
    if (*chosen == 0) {
        const auto found = reader_.fields(value, body_keys, place);
        load.load = BodyForce{.bx = field_value(found[2], body_force, place),
                              .by = field_value(found[3], body_force, place)};
    } else if (*chosen == 1) {
        const auto found = reader_.fields(value, temperature_keys, place);
        load.load = TemperatureRise{.rise = field_value(found[1], dimension::temperature, place)};
    } else {
        const auto found = reader_.fields(value, rotation_keys, place);
        load.load = SteadyRotation{.omega = reader_.quantity(found[1], angular_velocity, place).value_or(no_number),
                                   .about = location(found[3], place)};
    }
    return load;
}

PlaneSettlement PlaneReader::settlement(JsonValue value, const Place& place)
{
    const auto [point, curve, ux, uy] = reader_.fields(value, settlement_keys, place);
    PlaneSettlement settlement;
    if (value.is(JsonKind::Object) && point.is_present() == curve.is_present())
        reader_.add({FaultKind::SettlementPlace, {place.text()}});
    if (point.is_present()) settlement.point = NodeId(reference(point, points_, place));
    settlement.curves = references<CurveId>(curve, curves_, place);
    settlement.ux = field_value(ux, dimension::length, place);
    settlement.uy = field_value(uy, dimension::length, place);
    return settlement;
}

std::optional<Field> PlaneReader::field_value(JsonValue value, Dimension dimension, const Place& place)
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

Field::Ends PlaneReader::ends(JsonValue value, Dimension dimension, const Place& place)
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

Field::Polynomial PlaneReader::polynomial(JsonValue value, Dimension dimension, const Place& place)
{
    Field::Polynomial terms;
    if (value.is(JsonKind::Array) && value.size() == 0) reader_.add({FaultKind::EmptyField, {place.text(value.key())}});
    for_each(value, place, [&](JsonValue entry, const Place& own_place) {
        if (auto found = term(entry, dimension, own_place)) terms.push_back(std::move(*found));
    });
    return terms;
}

std::optional<Field::Term> PlaneReader::term(JsonValue value, Dimension dimension, const Place& place)
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

Field::Table PlaneReader::table(JsonValue about, JsonValue along, JsonValue rows, Dimension dimension,
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
