#include "femoop/io/influence/influence_json.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "femoop/geometry/member_geometry.h"
#include "femoop/io/json/json_writer.h"
#include "femoop/io/json/model_json.h"
#include "femoop/io/reader/names.h"
#include "femoop/load/place_along.h"
#include "femoop/methods/influence/effect_name.h"
#include "femoop/result/magnitudes.h"

namespace femoop::influence {

namespace {

constexpr std::size_t n_coefficients = 4; // of a polynomial of degree three

void write_pieces(JsonWriter& json, const Model& model, const InfluenceLine& line)
{
    json.key("pieces").begin_array(JsonWriter::Layout::Block);
    for (const LineStretch& stretch : line.stretches) {
        json.begin_object().member("member", model[stretch.member].id);
        json.member("from", stretch.from).member("to", stretch.to).key("polynomial");
        if (stretch.is_series) {
            json.null().end();
            continue;
        }
        const std::vector<double>& c = line.ordinates.pieces[stretch.first_piece].coefficients;
        json.begin_array();
        for (std::size_t i = 0; i < n_coefficients; ++i) json.value(i < c.size() ? c[i] : 0.0);
        json.end().end();
    }
    json.end();
}

void write_stations(JsonWriter& json, const InfluenceLine& line, std::size_t n, double size)
{
    json.key("stations").begin_array(JsonWriter::Layout::Block);
    for (const LineStation& station : stations(line, n))
        json.begin_object().member("position", station.s).member("value", without_rounding(station.value, size)).end();
    json.end();
}

void write_extreme(JsonWriter& json, std::string_view key, const LineExtreme& extreme, double size)
{
    json.key(key).begin_object().key("position").begin_array();
    for (const double s : extreme.positions) json.value(s);
    json.end().member("value", without_rounding(extreme.value, size)).end();
}

void write_line(JsonWriter& json, const Model& model, const InfluenceLineDefinition& definition,
                const InfluenceLine& line, std::size_t n_stations)
{
    const double size = line.ordinates.largest();
    json.begin_object(JsonWriter::Layout::Block).member("id", definition.id);
    write_effect(json, model, line.effect);
    write_pieces(json, model, line);
    write_stations(json, line, n_stations, size);
    write_extreme(json, "max", line.ordinates.max(), size);
    write_extreme(json, "min", line.ordinates.min(), size);
    const LineAreas areas = line.ordinates.areas();
    const double area = size * line.ordinates.length();
    json.key("areas")
        .begin_object()
        .member("positive", without_rounding(areas.positive, area))
        .member("negative", without_rounding(areas.negative, area))
        .end();
    json.end();
}

} // namespace

void write_effect(JsonWriter& json, const Model& model, const MovingEffect& effect)
{
    json.member("quantity", names::quantities.at(static_cast<std::size_t>(effect.quantity)));
    if (effect.node) json.member("node", model[*effect.node].id);
    if (effect.member) json.member("member", model[*effect.member].id);
    json.member("component", component_name(model.analysis, effect));
    if (effect.member && effect.at)
        json.member("at", along(*effect.at, geometry_of(model, model[*effect.member]).length));
    if (effect.side) json.member("side", names::sides.at(static_cast<std::size_t>(*effect.side)));
}

std::string lines_json(const Model& model, std::span<const InfluenceLineDefinition> definitions,
                       std::span<const InfluenceLine> lines, std::size_t n_stations)
{
    JsonWriter json;
    begin_output(json, model.units);
    json.key("lines").begin_array(JsonWriter::Layout::Block);
    for (std::size_t i = 0; i < lines.size(); ++i) write_line(json, model, definitions[i], lines[i], n_stations);
    json.end().end();
    return json.take();
}

} // namespace femoop::influence
