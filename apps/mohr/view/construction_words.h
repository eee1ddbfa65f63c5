#pragma once

#include <string>

#include "apps/mohr/document/solution.h"
#include "apps/mohr/view/look.h"
#include "femoop/methods/mohr/construction.h"

namespace mohr {

/// What is done in a step of the construction, with its numbers.
std::string caption(femoop::mohr::ConstructionStage stage, const Document& document, const Solution& solution,
                    const Look& look);

/// "X", "σ1", "P" ...: how a point of the construction is marked.
std::string mark_name(femoop::mohr::ConstructionMark mark, const Document& document);

} // namespace mohr
