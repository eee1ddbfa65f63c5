#pragma once

#include "femoop/plane/model/plane_model.h"

namespace femoop::plane {

/// The same body with its bare numbers counted in other base units, as `in_units` of a structure of members does it;
/// numbers of fields are counted by the powers of x and y that they stand before.
PlaneModel in_units(const PlaneModel& model, const Units& units);

} // namespace femoop::plane
