#pragma once

#include <vector>

#include "femoop/plane/model/plane_model.h"

namespace plane {

/// A load case with its factor in the case that is shown.
struct CaseShare {
    const femoop::plane::PlaneLoadCase& load_case;
    double factor = 1.0;
};
/// None of a case that the model lacks.
std::vector<CaseShare> shares_of(const femoop::plane::PlaneModel& model, femoop::CaseId shown);

} // namespace plane
