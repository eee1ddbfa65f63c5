#pragma once

#include "apps/euler/document/stepper.h"

namespace euler {

inline const topology::Solid& first_solid(const Stepper& lesson) { return lesson.runner().solids().front().solid; }

} // namespace euler
