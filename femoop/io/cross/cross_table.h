#pragma once

#include <string>

#include "femoop/io/cross/cross_json.h"
#include "femoop/model/fault/translator.h"

namespace femoop::cross {

/// The sheet for people: factors, every row, the shear equations of sways, final moments beside the stiffness method's.
std::string sheet_text(const Worked& worked, const Translator& tr = english);

} // namespace femoop::cross
