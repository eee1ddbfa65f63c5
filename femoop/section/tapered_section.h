#pragma once

#include "femoop/model/member.h"
#include "femoop/model/property.h"

namespace femoop {

/// Can the depth of a member with this section vary along it? It is a rectangle, box, i or c by its dimensions alone,
/// upright: all its sections are symmetric about one straight axis, and only h changes.
bool can_taper(const Section& section);

/// The section with another depth. \pre can_taper(section)
Section at_depth(const Section& section, double h);

/// How deep a tapered member is where this share of its length lies before. \pre it has two depths
double depth_at(const Member& member, double share);

} // namespace femoop
