#pragma once

#include <string_view>
#include <vector>

#include "topology/halfedge/check/shells.h"
#include "ui/text/message.h"

namespace euler {

/// What a line of a script did, said with the names that it names: "A strut grows from v1 in face f1 to the new vertex
/// v2." Where an operator does one thing or another, as KFMRH does, the counts tell which.   \pre the line was run
ui::Message meaning(std::string_view line, const topology::EulerCounts& before, const topology::EulerCounts& after);

} // namespace euler
