#pragma once

#include "femoop/model/ids.h"

namespace femoop::plane {

using CurveId = Id<struct CurveTag>;
using RegionId = Id<struct RegionTag>;
using ElementId = Id<struct ElementTag>;

} // namespace femoop::plane
