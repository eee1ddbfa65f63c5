#pragma once

#include <string>
#include <vector>

#include "femoop/methods/truss/reciprocal.h"
#include "femoop/methods/truss/zero_force.h"
#include "femoop/model/fault/translator.h"

namespace femoop::truss {

/// Why not, and what to do.
std::string sentence(const Refusal& refusal, const Model& model, const Translator& tr);

/// By which rule the bar carries nothing.
std::string sentence(const ZeroForceBar& bar, const Model& model, const Translator& tr);

/// How many bars carry nothing, and which.
std::string zero_force_summary(const Truss& truss, const Model& model, const Translator& tr);

/// "tension", "compression" or "zero".
std::string sense_name(double force, const Translator& tr);

/// "AB = 30 kN, load at D": a side of the diagram that is a force from outside; `i` counts Reciprocal::forces.
std::string force_sentence(const Truss& truss, const Reciprocal& diagram, std::size_t i, const Model& model,
                           const Translator& tr);

/// What one stage of the diagram draws, and how; then, where it ends the polygon of a joint, the sides of this in order
/// and the forces that they give.
std::vector<std::string> stage_lines(const DiagramStep& step, const Truss& truss, const Reciprocal& diagram,
                                     const Model& model, const Translator& tr);
/// The same in one line.
std::string sentence(const DiagramStep& step, const Truss& truss, const Reciprocal& diagram, const Model& model,
                     const Translator& tr);

/// How a bar is read from the diagram: about which joint, from where to where, tension or compression.
std::string reading_sentence(const Truss& truss, const Reciprocal& diagram, MemberId bar, const Model& model,
                             const Translator& tr);

} // namespace femoop::truss
