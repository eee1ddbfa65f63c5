#pragma once

#include <string>

#include "femoop/methods/truss/reciprocal.h"
#include "femoop/methods/truss/zero_force.h"
#include "femoop/model/fault/translator.h"

namespace femoop::truss {

/// Why not, and what to do.
std::string sentence(const Refusal& refusal, const Model& model, const Translator& tr);

/// By which rule the bar carries nothing.
std::string sentence(const ZeroForceBar& bar, const Model& model, const Translator& tr);

/// "tension", "compression" or "zero".
std::string sense_name(double force, const Translator& tr);

/// "AB = 30 kN, load at D": a side of the diagram that is a force from outside; `i` counts Reciprocal::forces.
std::string force_sentence(const Truss& truss, const Reciprocal& diagram, std::size_t i, const Model& model,
                           const Translator& tr);

/// What one stage of the diagram draws, and how.
std::string sentence(const DiagramStep& step, const Truss& truss, const Reciprocal& diagram, const Model& model,
                     const Translator& tr);

/// How a bar is read from the diagram: about which joint, from where to where, tension or compression.
std::string reading_sentence(const Truss& truss, const Reciprocal& diagram, MemberId bar, const Model& model,
                             const Translator& tr);

} // namespace femoop::truss
