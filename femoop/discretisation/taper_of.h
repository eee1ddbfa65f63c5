#pragma once

#include "femoop/element/taper.h"
#include "femoop/model/property.h"

namespace femoop {

/// What a depth that changes linearly from `first` to `second` over the length makes of A, Iz and Asy, exactly:
///
///      A  = w h + 2 (B - w) t        Iz = (B h^3 - (B - w) (h - 2 t)^3) / 12        Asy in proportion to h
///
/// B and t are the flanges' width and thickness, w that of all webs; a rectangle has w = B.
///
/// \pre can_taper(section), and both depths are possible (`why_not` of the shape)
Taper taper_of(const Section& section, double first, double second, double length);

} // namespace femoop
