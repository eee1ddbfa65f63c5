#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "apps/plane/discretize/shape_curves.h"
#include "femoop/model/check/entry_checker.h"

namespace discretize {

/// An entry of a list as faults name it: curves[2] "hole".
template <class Parts> std::string entry_of(std::string_view list, const Parts& parts, std::size_t i)
{
    return femoop::Entry{list, i, parts[i].id}.text();
}

std::string rounded(double value); ///< six digits
/// "(0.5, 0.25) m"
std::string place_text(const PlaneModel& model, const topology::FlatPoint& at);

} // namespace discretize
