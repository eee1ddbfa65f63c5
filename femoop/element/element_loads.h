#pragma once

#include <span>

#include "femoop/element/continuum/continuum_load.h"
#include "femoop/element/span_load.h"

namespace femoop {

/// What stands on one element in one load case. An element reads the kinds of load that it knows.
struct ElementLoads {
    std::span<const SpanLoad> span_loads{}; ///< of a member, in its own axes
    SpanLoading* room = nullptr;            ///< to sort them in: used again from member to member, if there is one
    std::span<const EdgeLoad> edge_loads{}; ///< of a continuum element, like body_loads
    std::span<const BodyLoad> body_loads{};
    std::span<const ThermalLoad> thermal_loads{};
};

} // namespace femoop
