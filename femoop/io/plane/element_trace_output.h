#pragma once

#include <string>

#include "femoop/model/fault/translator.h"
#include "femoop/plane/analysis/element_trace.h"

namespace femoop::plane {

/// An element's way into the system of equations, for people: D, of each integration point N, J and B, the stiffness,
/// the forces of its loads, and where the rows are added.
std::string trace_text(const ElementTrace& trace, const Units& units, const Translator& tr = english);

/// The same as JSON:
///
///   {"cremona": 1, "units", "trace": {"element", "kind", "formulation", "region", "nodes", "dofs", "equations", "D",
///    "points": [{"xi", "eta", "weight", "at", "N", "J", "det_J", "depth", "B"}], "stiffness", "stiffness_in_node_axes",
///    "loads": {CASE: [..]}}}
std::string trace_json(const ElementTrace& trace, const Units& units);

} // namespace femoop::plane
