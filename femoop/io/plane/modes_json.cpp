#include "femoop/io/json/json_writer.h"
#include "femoop/io/json/model_json.h"
#include "femoop/io/plane/mesh_json.h"
#include "femoop/io/plane/modes_output.h"

namespace femoop::plane {

namespace {

using Layout = JsonWriter::Layout;

void write_directions(JsonWriter& json, std::string_view key, const Eigen::Vector2d& value)
{
    json.key(key).begin_object().member("ux", value.x()).member("uy", value.y()).end();
}

void write_shape(JsonWriter& json, const NaturalModes& found, const NaturalMode& mode, const ModesSelection& selection)
{
    json.key("nodes").begin_object(Layout::Block);
    if (selection.points && !selection.is_full) {
        for (const ShownPoint& point : *selection.points)
            write_directions(json, point.id,
                             point.node ? mode.shape[point.node->index]
                                        : found.displacement(mode, found.structure->locator().find(point.at).front()));
    } else {
        for (std::size_t i = 0; i < mode.shape.size(); ++i)
            write_directions(json, found.model().points[i].id, mode.shape[i]);
    }
    json.end();
}

} // namespace

std::string natural_modes_json(const NaturalModes& found, const ModesSelection& selection)
{
    JsonWriter json;
    begin_output(json, found.model().units);
    json.key("analysis").begin_object().member("kind", "modal").member("mass", "consistent");
    json.member("modes", found.modes.size()).end();
    write_mesh(json, found.model(), selection.is_full);
    if (!found.warnings.empty()) {
        json.key("warnings").begin_array(Layout::Block);
        for (const Fault& warning : found.warnings) json.value(message(warning));
        json.end();
    }
    json.key("modes").begin_array(Layout::Block);
    for (const NaturalMode& mode : found.modes) {
        json.begin_object(Layout::Block).member("frequency", mode.frequency()).member("omega", mode.omega);
        json.key("period");
        if (mode.omega > 0.0) json.value(1.0 / mode.frequency());
        else json.null();
        json.member("count", mode.count);
        write_shape(json, found, mode, selection);
        write_directions(json, "participation", mode.participation);
        write_directions(json, "effective_mass", mode.effective_mass);
        json.end();
    }
    json.end().member("total_mass", found.total_mass).end();
    return json.take();
}

} // namespace femoop::plane
