#pragma once

#include <string>
#include <vector>

#include "apps/plane/document/document.h"
#include "apps/plane/document/number.h"
#include "femoop/model/ids.h"

namespace plane {

/// Load cases and the combinations behind them share one set of names.

/// A name that no load case and no combination has: the wanted one, or the next with a number at its end.
std::string fresh_case_id(const PlaneModel& model, const std::string& wanted);

/// An empty one behind the others; combinations count on from it.
femoop::CaseId add_load_case(Document& document);
/// Of every load case once.
femoop::CaseId add_combination(Document& document);
/// With what refers to it. \pre id.index < model.n_cases()
void erase_case(Document& document, femoop::CaseId id);

/// What can be changed of a case: of a load case its factor of self-weight, of a combination the factors of the load cases
/// and of the combinations that it is made of, "factor G". \pre id.index < model.n_cases()
std::vector<Number> numbers(const PlaneModel& model, femoop::CaseId id);

} // namespace plane
