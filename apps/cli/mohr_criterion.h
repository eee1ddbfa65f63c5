#pragma once

#include "apps/cli/mohr_problem.h"

namespace cli {

/// Reads --criterion and --strength. \pre the state was read. \throws UsageError naming the option
void take_criterion(MohrProblem& problem, const MohrWords& words, const ui::Catalogue& tr);

} // namespace cli
