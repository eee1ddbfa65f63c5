#pragma once

#include "apps/drawing/draw_options.h"
#include "femoop/model/model.h"

#include <string>
#include <vector>

namespace drawing {

/// The load cases and combinations that the envelope is of; all of them where none would be left.
std::vector<femoop::CaseId> envelope_cases(const femoop::Model& model, const DrawOptions& options);

/// "Envelope of all cases", "Envelope of G, Q, U1"
std::string envelope_text(const femoop::Model& model, const DrawOptions& options);

/// "58.5 (G)": a number with the case that makes it, whose name is shortened where it is long.
std::string governed(const std::string& number, const std::string& case_name);

} // namespace drawing
