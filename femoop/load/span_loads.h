#pragma once

#include <vector>

#include "femoop/element/member_properties.h"
#include "femoop/element/span_load.h"
#include "femoop/geometry/member_geometry.h"
#include "femoop/model/load.h"

namespace femoop {

/// What a load on a member means, in the member's own axes: places measured, projected loads per length of the member,
/// components turned from global axes, heat and misfit as imposed strains. A component that is 0 there is left out.
///
///      q along global y on a slope, projected:   q y' = q cos^2,  q x' = q cos sin    (per unit of its length)
///
/// \pre temperature: properties.depth > 0 if top and bottom differ
std::vector<SpanLoad> span_loads(const MemberLoad& load, const MemberGeometry& geometry,
                                 const MemberProperties& properties);

/// The member's own weight, `factor` times, down: -y in plane models, -z otherwise.
std::vector<SpanLoad> self_weight(double factor, AnalysisKind kind, const MemberGeometry& geometry,
                                  const MemberProperties& properties);

} // namespace femoop
