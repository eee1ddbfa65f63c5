#pragma once

#include <span>

#include "femoop/element/span_load.h"

namespace femoop {

/// What stands on one element in one load case. An element reads the kinds of load that it knows.
struct ElementLoads {
    std::span<const SpanLoad> span_loads; ///< of a member, in its own axes
    SpanLoading* room = nullptr;          ///< to sort them in: used again from member to member, if there is one
};

} // namespace femoop
