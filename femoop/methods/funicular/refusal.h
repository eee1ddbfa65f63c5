#pragma once

#include <cstdint>
#include <vector>

#include "femoop/model/ids.h"

namespace femoop::funicular {

enum class RefusalKind : std::uint8_t {
    // of a chain
    NotPlaneFrame,
    NoMember, ///< that runs from left to right
    Upright,  ///< one of `members`
    Fork,     ///< two of `members` go the same way from one of `nodes`
    Apart,    ///< two of `members` begin parts that do not hang together
    // of its loads
    NoCase,
    NotVertical, ///< on one of `members` or of `nodes`, with the `value` of its part to the right
    Couple,      ///< likewise a moment, with its `value` counter-clockwise
    NoLoad
};

/// Why there is no funicular, and what is to blame. femoop/io/funicular/funicular_text.h has the sentence.
struct Refusal {
    RefusalKind kind = RefusalKind::NotPlaneFrame;
    std::vector<MemberId> members{};
    std::vector<NodeId> nodes{};
    double value = 0.0;
    bool is_distributed = false; ///< `value` is per unit length
};

} // namespace femoop::funicular
