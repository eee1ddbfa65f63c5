#pragma once

#include <string>

#include "apps/cross/document/solution.h"
#include "ui/text/display_units.h"

namespace cross {

/// E I of a member, in the model's base units; 0 of a bar and of a tapered member.
double stiffness_of(const Task& task, femoop::MemberId member);
/// Of all that bend; 0 where none does.
double smallest_stiffness(const Task& task);
/// In parts of the smallest: "EI", "2EI"; "" of a bar, "EI(x)" along a taper.
std::string stiffness_text(const Task& task, femoop::MemberId member, const ui::NumberFormat& format);

} // namespace cross
