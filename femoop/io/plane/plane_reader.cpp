#include "femoop/io/plane/plane_reader.h"

#include <algorithm>
#include <utility>

#include "femoop/io/plane/plane_names.h"
#include "femoop/io/reader/names.h"
#include "femoop/model/quantity/dof_dimension.h"

namespace femoop::plane {

namespace {

constexpr Keys<15> mesh_file_keys{{"cremona", "analysis", "units", "points", "elements", "regions", "title", "notes",
                                   "materials", "snap", "mesh", "curves", "load_cases", "combinations", "expected"},
                                  6};
constexpr Keys<15> drawing_keys{mesh_file_keys.names, 3};
constexpr Keys<4> point_keys{{"id", "at", "support", "size"}, 2};
constexpr Keys<5> curve_keys{{"id", "kind", "points", "support", "tie"}, 3};
constexpr Keys<4> region_keys{{"id", "material", "thickness", "mesh"}, 2};
constexpr Keys<4> element_keys{{"id", "kind", "points", "region"}, 4};
constexpr Keys<7> mesh_keys{{"method", "element", "formulation", "size", "min_angle", "diagonal", "corners"}, 0};
constexpr Keys<4> support_keys{{"fixed", "angle", "springs", "axes"}, 0};

constexpr Dimension spring_of_point(Dof dof) { return spring_dimension(dof); }
constexpr Dimension spring_of_curve(Dof dof)
{
    Dimension dimension = spring_dimension(dof);
    dimension.length = static_cast<std::int8_t>(dimension.length - 2);
    return dimension;
}

bool is_drawn_kind(JsonValue kind)
{
    return kind.is(JsonKind::String) &&
           std::ranges::find(names::drawn_curves, kind.text()) != names::drawn_curves.end();
}

} // namespace

PlaneReader::PlaneReader(JsonValue file, std::vector<Fault> faults)
{
    model.is_drawn = !field(file, "elements").is_present();
    for (Fault& fault : faults) reader_.add(std::move(fault));
    const Place top;
    const auto [cremona, analysis, units, points, elements, regions, title, notes, materials, snap, mesh, curves,
                load_cases, combinations,
                expected_list] = reader_.fields(file, model.is_drawn ? drawing_keys : mesh_file_keys, top);
    model.title = reader_.text(title, top).value_or("");
    model.notes = reader_.text(notes, top).value_or("");
    read_header(cremona, analysis, units);
    model.snap = reader_.quantity(snap, dimension::length, top);
    materials_.add(materials);
    points_.add(points);
    curves_.add(curves);
    regions_.add(regions);
    cases_.add(load_cases);
    cases_.add(combinations, load_cases.size());
    points_.is_lost = !model.is_drawn && !points.is(JsonKind::Array); // which the file has as a fault already
    regions_.is_lost = !model.is_drawn && !regions.is(JsonKind::Array);
    model.mesh = mesh_options(mesh, top);
    read_parts(*this, materials, {}, model.materials, unreadable_.materials, &PlaneReader::own_material);
    read_parts(*this, points, {}, model.points, unreadable_.points, &PlaneReader::point);
    read_parts(*this, regions, {}, model.regions, unreadable_.regions, &PlaneReader::region);
    read_parts(*this, elements, {}, model.elements, unreadable_.elements, &PlaneReader::element);
    read_parts(*this, curves, {}, model.curves, unreadable_.curves, &PlaneReader::curve);
    for_each(load_cases, {},
             [this](JsonValue value, const Place& place) { model.load_cases.push_back(load_case(value, place)); });
    read_parts(*this, combinations, {}, model.combinations, unreadable_.combinations, &PlaneReader::own_combination);
    read_parts(*this, expected_list, {}, model.expected, unreadable_.expected, &PlaneReader::expected);
    unreadable_.is_incomplete = reader_.n_troubles() > 0;
}

void PlaneReader::read_header(JsonValue cremona, JsonValue analysis, JsonValue units)
{
    const std::size_t before = reader_.n_troubles();
    read_format(cremona);
    if (const auto kind = reader_.choice(analysis, names::analyses, {}))
        model.analysis = static_cast<StressState>(*kind);
    model.units = read_units(units);
    unreadable_.header = reader_.n_troubles() != before || !units.is_present();
}

Combination PlaneReader::own_combination(JsonValue value, const Place& place)
{
    return combination(value, model.n_cases(), place);
}

PlanePoint PlaneReader::point(JsonValue value, const Place& place)
{
    const auto [id, at, support_value, size] = reader_.fields(value, point_keys, place);
    PlanePoint point;
    point.id = reader_.id(id, place);
    if (std::vector<Quantity> found = location(at, place); found.size() == 2)
        point.at = {std::move(found[0]), std::move(found[1])};
    point.support = support(support_value, Holder::Point, place);
    point.size = reader_.quantity(size, dimension::length, place);
    return point;
}

PlaneCurve PlaneReader::curve(JsonValue value, const Place& place)
{
    return model.is_drawn ? drawn_curve(value, place) : mesh_curve(value, place);
}

PlaneCurve PlaneReader::mesh_curve(JsonValue value, const Place& place)
{
    PlaneCurve curve;
    const JsonValue kind = field(value, "kind");
    if (is_drawn_kind(kind)) { // its other keys are those of another kind
        curve.id = reader_.id(field(value, "id"), place);
        reader_.add({FaultKind::CurveKindWithElements, {place.text(), std::string(kind.text())}});
        return curve;
    }
    const auto [id, kind_value, points, support_value, tie] = reader_.fields(value, curve_keys, place);
    curve.id = reader_.id(id, place);
    reader_.choice(kind_value, names::curves, place);
    if (reader_.is_list(points, place)) curve.points = references<NodeId>(points, points_, place);
    curve.support = support(support_value, Holder::Curve, place);
    curve.tie = dof_set(tie, place);
    return curve;
}

PlaneRegion PlaneReader::region(JsonValue value, const Place& place)
{
    if (model.is_drawn) return drawn_region(value, place);
    const auto [id, material_name, thickness, mesh] = reader_.fields(value, region_keys, place);
    PlaneRegion region;
    region.id = reader_.id(id, place);
    region.material = MaterialId(reference(material_name, materials_, place));
    region.thickness = reader_.quantity(thickness, dimension::length, place);
    region.mesh = mesh_options(mesh, place);
    return region;
}

void PlaneReader::repeated_reference(const Place& place)
{
    reader_.add({FaultKind::WrongType,
                 {place.text(), std::string(translatable("an id that stands before it too")),
                  std::string(translatable("each id once")), "[\"A\", \"B\"]"}});
}

void PlaneReader::empty_list(const Place& place)
{
    reader_.add({FaultKind::WrongType,
                 {place.text(), std::string(translatable("an empty list")),
                  std::string(translatable("one id at least")), "[\"A\"]"}});
}

PlaneElement PlaneReader::element(JsonValue value, const Place& place)
{
    const auto [id, kind, points, region_name] = reader_.fields(value, element_keys, place);
    PlaneElement element;
    element.id = reader_.id(id, place);
    if (const auto chosen = reader_.choice(kind, names::shapes, place))
        element.kind = static_cast<ShapeKind>(*chosen + static_cast<std::size_t>(ShapeKind::T3));
    if (reader_.is_list(points, place)) element.points = references<NodeId>(points, points_, place);
    element.region = RegionId(reference(region_name, regions_, place));
    return element;
}

MeshOptions PlaneReader::mesh_options(JsonValue value, const Place& place)
{
    MeshOptions options;
    if (!value.is_present()) return options;
    const Place here = place.key(value.key());
    const auto [method, element_kind, formulation, size, min_angle, diagonal,
                corners] = reader_.fields(value, mesh_keys, here);
    if (const auto chosen = reader_.choice(method, names::methods, here)) options.method = names::methods[*chosen];
    if (const auto chosen = reader_.choice(element_kind, names::shapes, here))
        options.element = static_cast<ShapeKind>(*chosen + static_cast<std::size_t>(ShapeKind::T3));
    if (const auto chosen = reader_.choice(formulation, names::formulations, here))
        options.formulation = static_cast<Formulation>(*chosen);
    options.size = reader_.quantity(size, dimension::length, here);
    options.min_angle = reader_.quantity(min_angle, dimension::angle, here, AngleUnit::Degrees);
    if (const auto chosen = reader_.choice(diagonal, names::diagonals, here))
        options.diagonal = names::diagonals[*chosen];
    if (reader_.is_list(corners, here)) options.corners = references<NodeId>(corners, points_, here);
    return options;
}

std::optional<PlaneSupport> PlaneReader::support(JsonValue value, Holder holder, const Place& place)
{
    if (!value.is_present()) return std::nullopt;
    PlaneSupport support;
    if (value.is(JsonKind::String)) {
        const auto keyword = reader_.choice(value, names::supports, place);
        if (keyword) support.kind = static_cast<PlaneSupportKind>(*keyword + 1); // Custom is the first
        return support;
    }
    if (!value.is(JsonKind::Object)) {
        reader_.wrong_type(
            value, {translatable("\"fixed\", \"pin\", \"roller\", \"symmetry\" or an object"), "\"pin\""}, place);
        return std::nullopt;
    }
    const Place here = place.key("support");
    const auto [fixed, angle, spring_list, axes_value] = reader_.fields(value, support_keys, here);
    support.fixed = dof_set(fixed, here);
    support.angle = reader_.quantity(angle, dimension::angle, here, AngleUnit::Degrees).value_or(0.0);
    support.springs = springs(spring_list, holder == Holder::Curve ? spring_of_curve : spring_of_point, here);
    support.is_local = axes(axes_value, here) == LoadAxes::Local;
    if (support.is_local && angle.is_present()) reader_.add({FaultKind::AxesAndAngle, {here.text()}});
    return support;
}

} // namespace femoop::plane
