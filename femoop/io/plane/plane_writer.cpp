#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "femoop/io/plane/curve_runs.h"
#include "femoop/io/plane/field_text.h"
#include "femoop/io/plane/plane_file.h"
#include "femoop/io/plane/plane_names.h"
#include "femoop/io/reader/names.h"
#include "femoop/io/writer/part_text.h"

namespace femoop::plane {

namespace {

template <class Enum> std::size_t index_behind(Enum value, Enum first)
{
    return static_cast<std::size_t>(value) - static_cast<std::size_t>(first);
}

std::string word_of(ShapeKind kind) { return word(names::shapes, index_behind(kind, ShapeKind::T3)); }

/// One id alone, several as a list.
template <class Id, class Parts>
void add_ids(ObjectText& object, std::string_view key, const std::vector<Id>& ids, const Parts& parts)
{
    Lines texts;
    for (const Id id : ids) texts.push_back(quoted_json(parts.at(id.index).id));
    if (texts.size() == 1) object.add(key, texts.front());
    else if (!texts.empty()) object.add(key, json_list(texts));
}

void add_location(ObjectText& object, std::string_view key, const std::vector<Quantity>& at)
{
    if (!at.empty()) object.add(key, list_of(at));
}

void add_field(ObjectText& object, std::string_view key, const std::optional<Field>& field)
{
    if (field) object.add(key, field_text(*field));
}

std::string text_of(const PlaneSupport& support)
{
    const bool is_turned = support.angle.has_text() || support.angle.value() != 0.0;
    if (support.kind != PlaneSupportKind::Custom)
        return quoted_json(names::supports.at(index_behind(support.kind, PlaneSupportKind::Fixed)));
    ObjectText object;
    if (!support.fixed.is_empty()) object.add("fixed", femoop::text_of(support.fixed));
    if (is_turned) object.add("angle", support.angle);
    if (support.is_local) object.add("axes", word(femoop::names::axes, LoadAxes::Local));
    if (!support.springs.empty()) object.add("springs", femoop::text_of(support.springs));
    return object.str();
}

std::string text_of(const PlanePoint& point)
{
    ObjectText object;
    object.add_text("id", point.id).add("at", json_list({json_text(point.at[0]), json_text(point.at[1])}));
    if (point.support) object.add("support", text_of(*point.support));
    add_if(object, "size", point.size);
    return object.str();
}

std::string text_of(const DrawnPlace& place, const PlaneModel& model)
{
    if (place.point) return quoted_json(model.points.at(place.point->index).id);
    return json_list({json_text(place.at[0]), json_text(place.at[1])});
}

std::string text_of(const Division& division)
{
    if (!division.ratio) return std::to_string(division.n);
    return ObjectText().add("n", std::to_string(division.n)).add("ratio", *division.ratio).str();
}

void add_shape(ObjectText& object, const DrawnShape& shape, const PlaneModel& model)
{
    Lines places, parts;
    for (const DrawnPlace& place : shape.places) places.push_back(text_of(place, model));
    for (const Division& division : shape.divide) parts.push_back(text_of(division));
    object.add("kind", word(names::drawn_curves, shape.kind));
    if (shape.center) object.add("center", text_of(*shape.center, model));
    add_if(object, "radius", shape.radius);
    if (!shape.axes.empty()) object.add("axes", list_of(shape.axes));
    add_if(object, "angle", shape.angle);
    if (!places.empty()) object.add("points", json_list(places));
    if (shape.is_closed) object.add("closed", "true");
    if (shape.is_clockwise) object.add("turn", word(names::turns, *shape.is_clockwise ? 1 : 0));
    if (shape.is_divided_by_piece) object.add("divide", json_list(parts));
    else if (!parts.empty()) object.add("divide", parts.front());
}

std::string text_of(const PlaneCurve& curve, const PlaneModel& model)
{
    Lines points;
    for (const NodeId point : curve.points) points.push_back(quoted_json(model.points.at(point.index).id));
    ObjectText object;
    object.add_text("id", curve.id);
    if (curve.shape) add_shape(object, *curve.shape, model);
    else object.add("kind", word(names::curves, 0)).add("points", json_list(points));
    if (curve.support) object.add("support", text_of(*curve.support));
    if (!curve.tie.is_empty()) object.add("tie", femoop::text_of(curve.tie));
    return object.str();
}

void add_mesh(ObjectText& object, const MeshOptions& mesh, const PlaneModel& model)
{
    if (!mesh.method.empty()) object.add_text("method", mesh.method);
    if (mesh.element) object.add("element", word_of(*mesh.element));
    if (mesh.formulation) object.add("formulation", word(names::formulations, *mesh.formulation));
    add_if(object, "size", mesh.size);
    add_if(object, "min_angle", mesh.min_angle);
    if (!mesh.diagonal.empty()) object.add_text("diagonal", mesh.diagonal);
    Lines corners;
    for (const NodeId corner : mesh.corners) corners.push_back(quoted_json(model.points.at(corner.index).id));
    if (!corners.empty()) object.add("corners", json_list(corners));
}

std::string text_of(const PlaneRegion& region, const PlaneModel& model)
{
    ObjectText object, mesh;
    object.add_text("id", region.id);
    Lines places;
    for (const auto& [x, y] : region.at) places.push_back(json_list({json_text(x), json_text(y)}));
    if (region.is_listed) object.add("at", json_list(places));
    else if (!places.empty()) object.add("at", places.front());
    if (region.is_hole) object.add("hole", "true");
    else object.add_text("material", model.materials.at(region.material.index).id);
    add_if(object, "thickness", region.thickness);
    add_mesh(mesh, region.mesh, model);
    if (!mesh.is_empty()) object.add("mesh", mesh.str());
    return object.str();
}

std::string text_of(const PlaneElement& element, const PlaneModel& model)
{
    Lines points;
    for (const NodeId point : element.points) points.push_back(quoted_json(model.points.at(point.index).id));
    ObjectText object;
    object.add_text("id", element.id).add("kind", word_of(element.kind)).add("points", json_list(points));
    return object.add_text("region", model.regions.at(element.region.index).id).str();
}

std::string text_of(const NodeLoad& load, const PlaneModel& model)
{
    ObjectText object;
    object.add_text("point", model.points.at(load.node.index).id);
    for (const Component& part : load.components) object.add(force_name(part.dof), part.value);
    return object.str();
}

std::string text_of(const CurveLoad& load, const PlaneModel& model)
{
    ObjectText object;
    add_ids(object, "curve", load.curves, model.curves);
    object.add("kind", word(names::curve_loads, load.kind));
    add_field(object, "qx", load.qx);
    add_field(object, "qy", load.qy);
    add_field(object, "value", load.value);
    if (load.axes == LoadAxes::Local) object.add("axes", word(femoop::names::axes, load.axes));
    return object.str();
}

std::string text_of(const RegionLoad& load, const PlaneModel& model)
{
    ObjectText object;
    add_ids(object, "region", load.regions, model.regions);
    object.add("kind", word(names::region_loads, load.load.index()));
    if (const auto* body = std::get_if<BodyForce>(&load.load)) {
        add_field(object, "bx", body->bx);
        add_field(object, "by", body->by);
    } else if (const auto* heat = std::get_if<TemperatureRise>(&load.load)) {
        add_field(object, "rise", heat->rise);
    } else {
        const auto& rotation = std::get<SteadyRotation>(load.load);
        object.add("omega", rotation.omega);
        add_location(object, "about", rotation.about);
    }
    return object.str();
}

std::string text_of(const PlaneSettlement& settlement, const PlaneModel& model)
{
    ObjectText object;
    if (settlement.point) object.add_text("point", model.points.at(settlement.point->index).id);
    add_ids(object, "curve", settlement.curves, model.curves);
    add_field(object, "ux", settlement.ux);
    add_field(object, "uy", settlement.uy);
    return object.str();
}

std::string text_of(const PlaneLoadCase& load_case, const PlaneModel& model)
{
    ObjectText object;
    object.add_text("id", load_case.id);
    if (load_case.self_weight != 0.0) object.add("self_weight", json_text(load_case.self_weight));
    NamedLists lists{{"points", {}}, {"curves", {}}, {"regions", {}}, {"settlements", {}}};
    for (const NodeLoad& load : load_case.points) lists[0].second.push_back(text_of(load, model));
    for (const CurveLoad& load : load_case.curves) lists[1].second.push_back(text_of(load, model));
    for (const RegionLoad& load : load_case.regions) lists[2].second.push_back(text_of(load, model));
    for (const PlaneSettlement& each : load_case.settlements) lists[3].second.push_back(text_of(each, model));
    return with_lists(std::move(object), lists);
}

std::string text_of(const PlaneExpected& check, const PlaneModel& model)
{
    ObjectText object;
    if (check.load_case) object.add_text("case", model.case_name(*check.load_case));
    if (check.analysis != ExpectedAnalysis::Linear)
        object.add("analysis", word(femoop::names::expected_analyses, check.analysis));
    object.add_text("quantity", name(check.quantity));
    if (check.component) object.add_text("component", name(*check.component));
    if (!check.counted.empty()) object.add_text("component", check.counted);
    if (check.extreme) object.add("which", word(femoop::names::extremes, *check.extreme));
    if (check.rank) object.add("which", std::to_string(*check.rank));
    if (check.point) object.add_text("point", model.points.at(check.point->index).id);
    if (check.curve) object.add_text("curve", model.curves.at(check.curve->index).id);
    if (check.region) object.add_text("region", model.regions.at(check.region->index).id);
    add_location(object, "at", check.at);
    add_location(object, "about", check.about);
    if (!check.cut.empty())
        object.add("cut", json_list({json_list({json_text(check.cut[0]), json_text(check.cut[1])}),
                                     json_list({json_text(check.cut[2]), json_text(check.cut[3])})}));
    if (check.read) object.add("read", word(names::readings, *check.read));
    object.add("value", check.value);
    if (check.rtol) object.add("rtol", json_text(*check.rtol));
    add_if(object, "atol", check.atol);
    if (!check.source.empty()) object.add_text("source", check.source);
    return object.str();
}

} // namespace

std::string write_plane_model(const PlaneModel& model)
{
    if (std::ranges::any_of(model.curves, [](const PlaneCurve& curve) { return curve.reach.has_value(); }))
        return write_plane_model(with_runs_as_curves(model));
    const auto alone = [](const auto& part) { return text_of(part); };
    const auto in_model = [&](const auto& part) { return text_of(part, model); };
    ModelText file;
    ObjectText mesh;
    add_mesh(mesh, model.mesh, model);
    file.add("cremona", "1");
    file.add_text("title", model.title);
    file.add_text("notes", model.notes);
    file.add("analysis", word(names::analyses, model.analysis));
    file.add("units", femoop::text_of(model.units));
    if (model.snap) file.add("snap", json_text(*model.snap));
    if (!mesh.is_empty()) file.add("mesh", mesh.str());
    file.add_list_if("materials", model.materials, [](const Material& part) { return femoop::text_of(part); });
    if (model.is_drawn) {
        file.add_list_if("points", model.points, alone);
        file.add_list_if("curves", model.curves, in_model);
        file.add_list_if("regions", model.regions, in_model);
    } else {
        file.add_list("points", model.points, alone);
        file.add_list_if("curves", model.curves, in_model);
        file.add_list("regions", model.regions, in_model);
        file.add_list("elements", model.elements, in_model);
    }
    file.add_list_if("load_cases", model.load_cases, in_model);
    file.add_list_if("combinations", model.combinations, [&](const Combination& part) {
        return combination_text(part, [&](CaseId id) { return model.case_name(id); });
    });
    file.add_list_if("expected", model.expected, in_model);
    return file.str();
}

} // namespace femoop::plane
