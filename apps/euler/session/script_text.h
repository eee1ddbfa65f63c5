#pragma once

#include <string_view>

#include "topology/text/line_error.h"
#include "ui/text/catalogue.h"

namespace euler {

/// Whether a text can be edited in the window: it is text, and not too long.
bool can_be_edited(std::string_view text);

/// "line 7: mef s1 f1 v1 v9 f3: v9 is not in face f1"
ui::Message sentence(const topology::LineError& fault, const ui::Catalogue& tr);

} // namespace euler
