#pragma once

#include <string>

#include "femoop/model/fault/translator.h"
#include "femoop/model/model.h"
#include "femoop/model/quantity/dimension.h"

namespace femoop::influence {

/// What an effect is called where it has no id: M(BC, 50%), M(BC, 2.5 m), fy(A), ux(B), M(BC).
std::string effect_name(const Model& model, const MovingEffect& effect, const Translator& tr = english);

/// Where a section of a member is told to be: one by a hair within an end is told at that end.
double told_place(const Model& model, MemberId member, double x);

/// Of its component alone: M, fy, ux.
std::string component_name(AnalysisKind kind, const MovingEffect& effect);

Dimension dimension_of(const MovingEffect& effect); ///< of its value

} // namespace femoop::influence
