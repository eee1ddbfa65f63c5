#pragma once

#include "femoop/discretisation/solution.h"

namespace femoop {

/// Marks the load cases in which heat, misfit and settlements move the structure and strain nothing, as they move every
/// statically determinate one: forces that are nothing but rounding beside those that would hold it in place are none.
void mark_unstressed_cases(detail::Solution& solution);

} // namespace femoop
