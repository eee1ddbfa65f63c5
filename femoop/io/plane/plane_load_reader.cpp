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

constexpr Dimension body_force{.length = -3, .force = 1};
constexpr Dimension angular_velocity{.time = -1, .angle = 1};

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
    load.curves = loaded<CurveId>(field(value, "curve"), curves_, place);
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
    load.regions = loaded<RegionId>(field(value, "region"), regions_, place);
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
        load.load = SteadyRotation{.omega = rotation_speed(found[1], place), .about = location(found[3], place)};
    }
    return load;
}

Quantity PlaneReader::rotation_speed(JsonValue value, const Place& place)
{
    const auto speed = reader_.quantity(value, angular_velocity, place);
    if (speed && speed->text().find("Hz") != std::string_view::npos) // turns, which are more than as many radians
        reader_.add(
            {FaultKind::QuantityWrongDimension,
             {place.key(value.key()).text(), std::string(speed->text()), std::string(translatable("turns in a second")),
              std::string(translatable("an angular velocity")), "rad/s"}});
    return speed.value_or(no_number);
}

PlaneSettlement PlaneReader::settlement(JsonValue value, const Place& place)
{
    const auto [point, curve, ux, uy] = reader_.fields(value, settlement_keys, place);
    PlaneSettlement settlement;
    if (value.is(JsonKind::Object) && point.is_present() == curve.is_present())
        reader_.add({FaultKind::SettlementPlace, {place.text()}});
    if (point.is_present()) settlement.point = NodeId(reference(point, points_, place));
    settlement.curves = loaded<CurveId>(curve, curves_, place);
    settlement.ux = field_value(ux, dimension::length, place);
    settlement.uy = field_value(uy, dimension::length, place);
    return settlement;
}

} // namespace femoop::plane
