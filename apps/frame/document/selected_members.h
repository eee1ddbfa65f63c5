#pragma once

#include <vector>

#include "apps/frame/document/selection.h"

namespace frame {

/// The members among the chosen parts, in the order in which they were chosen.
std::vector<femoop::MemberId> selected_members(const Selection& selection);

} // namespace frame
