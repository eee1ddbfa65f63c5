#pragma once

#include <string>

#include "ui/paint/geometry.h"

namespace cross {

/// Tells beneath a field on the picture why what was typed was not taken. \param middle  of the field [physical
/// pixels], \param left  of the picture, beyond which it does not go
void show_reason(const std::string& reason, ui::Point middle, double left);

} // namespace cross
