#pragma once

#include <span>
#include <string>

#include "femoop/io/results/result_units.h"
#include "femoop/methods/influence/influence_line.h"
#include "femoop/model/fault/translator.h"
#include "femoop/model/model.h"

namespace femoop {
class JsonWriter;
}

namespace femoop::influence {

/// The lines with their pieces, stations, extremes and areas, as courseware/reference/moving-loads.md shows.
/// \param definitions  parallel to lines  \param n_stations  of each member of the path
std::string lines_json(const Model& model, std::span<const InfluenceLineDefinition> definitions,
                       std::span<const InfluenceLine> lines, std::size_t n_stations);

/// "quantity", "node" or "member", "component", "at" (a length), "side": of an open object.
void write_effect(JsonWriter& json, const Model& model, const MovingEffect& effect);

/// The units that tables of a line have.
struct LineUnits {
    PrintedUnit length;   ///< of places
    PrintedUnit ordinate; ///< of the effect per force, or per moment of a couple
};
/// The file's.
LineUnits line_units(const Model& model, const InfluenceLineDefinition& line);

/// The same as tables for a person. \param units  parallel to lines
std::string lines_text(const Model& model, std::span<const InfluenceLineDefinition> definitions,
                       std::span<const InfluenceLine> lines, std::span<const LineUnits> units, std::size_t n_stations,
                       const Translator& tr);

} // namespace femoop::influence
