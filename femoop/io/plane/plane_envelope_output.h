#pragma once

#include <string>
#include <vector>

#include "femoop/io/plane/plane_output.h"

namespace femoop::plane {

/// The envelope over the cases of the selection: every value is {"max": {"value", "case"}, "min": ..}; extremes of
/// regions have "at" too.
///
///   {"cremona": 1, "units", "analysis", "mesh", "envelope": {"cases": [ID..],
///    "points": {ID: {"u", "reaction", "stress": {REGION: {"sx", ..}}}}, "curves": {ID: {"reaction"}},
///    "regions": {ID: {"extremes": {"sx", ..}}}, "probes": [{"at", "u", "stress"}], "cuts": [{"cut", "N", "V", "M"}]}}
///
/// \pre at least one case
std::string plane_envelope_json(const PlaneResults& results, const PlaneSelection& selection);

/// The same for people: of a mesh of many points the displacements of those alone that some case moves most.
std::string plane_envelope_text(const PlaneResults& results, const PlaneSelection& selection, const ResultUnits& units,
                                const Translator& tr);

/// One long table: part (point, curve, region, place, cut), its name, x, y, region, component, unit, max, case of max,
/// min, case of min; of all points of the mesh.
std::vector<CsvFile> plane_envelope_csv(const PlaneResults& results, const PlaneSelection& selection);

} // namespace femoop::plane
