#pragma once

#include <string>
#include <vector>

#include "femoop/io/plane/plane_output.h"
#include "femoop/model/fault/translator.h"
#include "femoop/plane/analysis/natural_modes.h"

namespace femoop::plane {

/// What is printed of each mode's shape.
struct ModesSelection {
    std::optional<std::vector<ShownPoint>> points{}; ///< of a drawing; absent: all points of the model
    bool is_full = false;                            ///< the mesh, and the shape at all its nodes
};

/// The natural modes as JSON, the shape that `cremona solve --analysis modal --json` prints:
///
///   {"cremona": 1, "units", "analysis": {"kind": "modal", "mass": "consistent", "modes"}, "mesh": {..},
///    "modes": [{"frequency", "omega", "period", "count", "nodes": {ID: {"ux", "uy"}}, "participation": {"ux", "uy"},
///               "effective_mass": {"ux", "uy"}}], "total_mass"}
///
/// Units  frequency in Hz, omega in rad/s, period in s and null where the frequency is 0; masses in the base units of
///        force, length and s; the largest displacement of a shape has length 1
std::string natural_modes_json(const NaturalModes& found, const ModesSelection& selection);

/// The same for people: a table of the modes.
std::string natural_modes_text(const NaturalModes& found, const Translator& tr = english);

} // namespace femoop::plane
