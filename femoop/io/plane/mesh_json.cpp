#include "femoop/io/plane/mesh_json.h"

#include "femoop/plane/mesh/mesh_quality.h"

namespace femoop::plane {

void write_mesh(JsonWriter& json, const PlaneModel& model, bool is_full)
{
    const MeshQuality quality = mesh_quality(model);
    json.key("mesh").begin_object(is_full ? JsonWriter::Layout::Block : JsonWriter::Layout::Line);
    json.member("nodes", model.points.size()).member("elements", model.elements.size());
    json.member("min_angle", quality.min_angle).member("max_angle", quality.max_angle);
    json.member("min_jacobian", quality.min_jacobian);
    if (is_full) {
        json.key("points").begin_object(JsonWriter::Layout::Block);
        for (const PlanePoint& point : model.points)
            json.key(point.id).begin_array().value(point.at[0].value()).value(point.at[1].value()).end();
        json.end().key("elements").begin_array(JsonWriter::Layout::Block);
        for (const PlaneElement& element : model.elements) {
            json.begin_object().member("id", element.id).member("kind", femoop::name(element.kind));
            json.key("points").begin_array();
            for (const NodeId node : element.points) json.value(model[node].id);
            json.end().member("region", model[element.region].id).end();
        }
        json.end();
    }
    json.end();
}

} // namespace femoop::plane
