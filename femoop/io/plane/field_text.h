#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "femoop/model/fault/fault.h"
#include "femoop/model/quantity/dimension.h"
#include "femoop/model/quantity/units.h"
#include "femoop/plane/model/field.h"

namespace femoop::plane {

/// A field as the file of a plane model has it: 5, "5 kN/m", [1, 3], {"polynomial": [[2, 1, 0]]}.
std::string field_text(const Field& field);

/// Reads one. \param dimension  of its values; numbers without a unit are in `units`  \returns all that is wrong with it,
/// places counted from the field itself
std::variant<Field, std::vector<Fault>> read_field(std::string_view text, Dimension dimension, const Units& units);

} // namespace femoop::plane
