#pragma once

#include <cstdint>

#include "femoop/model/model.h"

namespace femoop::cross {

/// How hard an exercise is.
enum class Difficulty : std::uint8_t {
    FixedEnds = 1, ///< two spans with fixed ends
    PinnedEnd,     ///< two spans, an end is pinned
    Overhang,      ///< an overhang and members of different EI
    SeveralSpans,  ///< three or four spans, a span with two loads
    Frame,         ///< a frame that does not sway
    SwayFrame      ///< a portal that sways
};

/// A structure with loads whose fixed-end moments are short numbers, in kN and m; the same for the same difficulty and
/// seed on every machine. At least one joint has something to balance.
Model seeded_model(Difficulty difficulty, std::uint32_t seed);

} // namespace femoop::cross
