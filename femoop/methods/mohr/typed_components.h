#pragma once

#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "femoop/model/fault/fault.h"
#include "femoop/model/quantity/dimension.h"

namespace femoop::mohr {

/// Numbers of one dimension, counted in one unit.
struct Components {
    std::vector<double> values;
    std::string unit; ///< as it was typed first: "MPa"; "" for bare numbers, which are taken as they are
};

/// Texts such as 120, "120 MPa" or "17.4 ksi". Either none has a unit or all but zeros have; the first unit counts, and
/// a number that has it keeps its digits.
/// A fault names `place` and the component; a number beyond 1e100, or closer to 0 than 1e-100, is refused.
/// \pre as many names as texts
std::variant<Components, Fault> parse_components(std::span<const std::string> texts,
                                                 std::span<const std::string_view> names, std::string_view place,
                                                 Dimension dimension);

} // namespace femoop::mohr
