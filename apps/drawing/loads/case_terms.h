#pragma once

#include "femoop/model/model.h"

#include <vector>

namespace drawing {

/// A load case as it takes part in what is shown.
struct CaseTerm {
    const femoop::LoadCase* load_case;
    double factor;
    std::size_t place; ///< of the load case in the model
};

/// The load cases behind a load case (itself) or a combination, combinations of combinations multiplied out. Empty for
/// an id that the model lacks.
std::vector<CaseTerm> terms_of(const femoop::Model& model, femoop::CaseId id);

/// What the arrows of a case are measured by: the largest of each kind.
struct LargestLoads {
    double per_length = 0.0;
    double force = 0.0;
};
LargestLoads largest_loads(const std::vector<CaseTerm>& terms);

} // namespace drawing
