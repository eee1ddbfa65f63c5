#pragma once

#include "femoop/model/load.h"

namespace femoop {

/// Where a position along a member of length L lies, from its first end; a percentage is of L. As it is written, which
/// may be before the first end or beyond the second.
double written_place(const Position& position, double L);

/// The same, held to the member: 0 .. L.
double along(const Position& position, double L);

} // namespace femoop
