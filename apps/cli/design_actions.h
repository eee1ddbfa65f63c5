#pragma once

#include <string>

#include "apps/cli/console.h"
#include "femoop/model/model.h"

namespace cli {

/// What the options say: --combinations EN1990 --actions G=permanent,Q=offices,W=wind.
struct DesignActions {
    std::string code;
    std::string actions;
};

/// Adds the combinations of the code for all its limit states, and tells of each what it stands for.
/// \throws UsageError for a code, a load case or a kind of action that is not there
void add_design_combinations(femoop::Model& model, const DesignActions& typed, Console& console);

} // namespace cli
