// What a plane model has that is drawn: curves, and regions by places in them.
#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

#include "femoop/io/plane/plane_names.h"
#include "femoop/io/plane/plane_reader.h"

namespace femoop::plane {

namespace {

/// The keys that a kind has, needed ones first.
std::vector<std::string_view> keys_of(DrawnKind kind)
{
    switch (kind) {
    case DrawnKind::Line:
    case DrawnKind::Spline: return {"id", "kind", "points", "closed"};
    case DrawnKind::Arc: return {"id", "kind", "points", "center", "turn"};
    case DrawnKind::Circle: return {"id", "kind", "center", "radius"};
    case DrawnKind::Ellipse: return {"id", "kind", "center", "axes", "angle", "points", "turn"};
    case DrawnKind::Bezier: break;
    }
    return {"id", "kind", "points"};
}

std::size_t n_needed(DrawnKind kind)
{
    switch (kind) {
    case DrawnKind::Circle:
    case DrawnKind::Ellipse: return 4;
    default: return 3;
    }
}

constexpr double most_parts = 1e6;

} // namespace

PlaneCurve PlaneReader::drawn_curve(JsonValue value, const Place& place)
{
    PlaneCurve curve;
    if (!value.is(JsonKind::Object)) {
        reader_.not_an_object(value, place);
        return curve;
    }
    curve.id = reader_.id(field(value, "id"), place);
    const JsonValue kind = field(value, "kind");
    if (!kind.is_present()) reader_.missing_key("kind", place);
    if (kind.is(JsonKind::String) && kind.text() == names::curves.front()) {
        reader_.add({FaultKind::EdgesWithoutElements, {place.text()}});
        return curve;
    }
    if (const auto chosen = reader_.choice(kind, names::drawn_curves, place)) {
        curve.shape.emplace().kind = static_cast<DrawnKind>(*chosen);
        read_shape(curve, value, place);
    }
    return curve;
}

void PlaneReader::read_shape(PlaneCurve& curve, JsonValue value, const Place& place)
{
    DrawnShape& shape = *curve.shape;
    std::vector<std::string_view> keys = keys_of(shape.kind);
    for (std::size_t i = 0; i < n_needed(shape.kind); ++i)
        if (!field(value, keys[i]).is_present()) reader_.missing_key(keys[i], place);
    keys.insert(keys.end(), {"support", "tie", "divide"});
    for (const JsonValue entry : value)
        if (std::ranges::find(keys, entry.key()) == keys.end()) reader_.unknown_key(entry, keys, place);
    const auto of = [&](std::string_view key) {
        return std::ranges::find(keys, key) == keys.end() ? JsonValue() : field(value, key);
    };
    shape.places = drawn_places(of("points"), place);
    shape.is_closed = reader_.boolean(of("closed"), place);
    if (const JsonValue center = of("center"); center.is_present())
        shape.center = drawn_place(center, place.key("center"));
    shape.radius = reader_.quantity(of("radius"), dimension::length, place);
    shape.angle = reader_.quantity(of("angle"), dimension::angle, place, AngleUnit::Degrees);
    if (const auto chosen = reader_.choice(of("turn"), names::turns, place)) shape.is_clockwise = *chosen == 1;
    read_axes(shape, of("axes"), place);
    read_divide(shape, of("divide"), place);
    curve.support = support(of("support"), Holder::Curve, place);
    curve.tie = dof_set(of("tie"), place);
}

std::vector<DrawnPlace> PlaneReader::drawn_places(JsonValue value, const Place& place)
{
    std::vector<DrawnPlace> places;
    if (!value.is_present() || !reader_.is_list(value, place)) return places;
    const Place here = place.key(value.key());
    for (std::size_t i = 0; const JsonValue entry : value) places.push_back(drawn_place(entry, here.entry(i++)));
    return places;
}

/// \param here  its own place
DrawnPlace PlaneReader::drawn_place(JsonValue value, const Place& here)
{
    DrawnPlace found;
    if (value.is(JsonKind::String)) {
        found.point = NodeId(lookup(value.text(), points_, here));
        return found;
    }
    if (!value.is(JsonKind::Array) || value.size() != 2) {
        reader_.add({FaultKind::CurvePlace, {here.text()}});
        found.at = {no_number, no_number};
        return found;
    }
    for (std::size_t i = 0; const JsonValue coordinate : value) {
        found.at[i] = reader_.quantity(coordinate, dimension::length, here.entry(i)).value_or(no_number);
        ++i;
    }
    return found;
}

void PlaneReader::read_axes(DrawnShape& shape, JsonValue value, const Place& place)
{
    if (!value.is_present() || !reader_.is_list(value, place)) return;
    if (value.size() != 2) {
        reader_.add({FaultKind::EllipseAxes, {place.text(value.key())}});
        return;
    }
    const Place here = place.key(value.key());
    for (std::size_t i = 0; const JsonValue axis : value)
        shape.axes.push_back(reader_.quantity(axis, dimension::length, here.entry(i++)).value_or(no_number));
}

void PlaneReader::read_divide(DrawnShape& shape, JsonValue value, const Place& place)
{
    if (!value.is_present()) return;
    const Place here = place.key(value.key());
    const auto add = [&](JsonValue entry, const Place& own_place) {
        if (auto found = division(entry, own_place)) shape.divide.push_back(*std::move(found));
    };
    shape.is_divided_by_piece = value.is(JsonKind::Array);
    if (!shape.is_divided_by_piece) return add(value, here);
    for (std::size_t i = 0; const JsonValue entry : value) add(entry, here.entry(i++));
}

/// \param here  its own place
std::optional<Division> PlaneReader::division(JsonValue value, const Place& here)
{
    static constexpr Keys<2> keys{{"n", "ratio"}, 1};
    Division found;
    JsonValue n = value;
    if (value.is(JsonKind::Object)) {
        const auto [number, ratio] = reader_.fields(value, keys, here);
        n = number;
        found.ratio = reader_.quantity(ratio, dimension::none, here);
        if (!n.is_present()) return std::nullopt;
    }
    const double parts = n.is(JsonKind::Number) ? n.number() : 0.0;
    if (!(parts >= 1.0 && parts <= most_parts && parts == std::floor(parts))) {
        reader_.add({FaultKind::BadDivision, {here.text(), compact_json(n)}});
        return std::nullopt;
    }
    found.n = static_cast<int>(parts);
    return found;
}

PlaneRegion PlaneReader::drawn_region(JsonValue value, const Place& place)
{
    static constexpr Keys<6> keys{{"id", "material", "thickness", "mesh", "at", "hole"}, 1};
    const auto [id, material_name, thickness, mesh, at, hole] = reader_.fields(value, keys, place);
    PlaneRegion region;
    region.id = reader_.id(id, place);
    region.is_hole = reader_.boolean(hole, place);
    region.material = MaterialId(reference(material_name, materials_, place));
    if (value.is(JsonKind::Object) && region.is_hole && material_name.is_present())
        reader_.add({FaultKind::HoleWithMaterial, {place.text()}});
    if (value.is(JsonKind::Object) && !region.is_hole && !material_name.is_present())
        reader_.missing_key("material", place);
    region.thickness = reader_.quantity(thickness, dimension::length, place);
    region.mesh = mesh_options(mesh, place);
    read_places_of_region(region, at, place);
    return region;
}

/// One place, or a list of them.
void PlaneReader::read_places_of_region(PlaneRegion& region, JsonValue value, const Place& place)
{
    if (!value.is_present()) return;
    const Place here = place.key(value.key());
    const auto add = [&](JsonValue entry, const Place& own_place) {
        if (!entry.is(JsonKind::Array) || entry.size() != 2) {
            reader_.add({FaultKind::CheckPlaceSize, {own_place.text()}});
            return;
        }
        std::array<Quantity, 2> found;
        for (std::size_t i = 0; const JsonValue coordinate : entry) {
            found[i] = reader_.quantity(coordinate, dimension::length, own_place.entry(i)).value_or(no_number);
            ++i;
        }
        region.at.push_back(found);
    };
    region.is_listed = value.is(JsonKind::Array) && value.size() > 0 && (*value.begin()).is(JsonKind::Array);
    if (!region.is_listed) return add(value, here);
    for (std::size_t i = 0; const JsonValue entry : value) add(entry, here.entry(i++));
}

} // namespace femoop::plane
