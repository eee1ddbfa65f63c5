#pragma once

#include <cstdint>
#include <vector>

#include "femoop/methods/influence/train/train_search.h"

namespace frame {

/// A position where a train may be worst, and what it does to the line's effect there, all that stays included.
struct CandidatePosition {
    /// Where an axle passes an end of a piece of the line, on both sides alike or on one; or where the effect over the
    /// position is level.
    enum class Kind : std::uint8_t { Break, BreakBefore, BreakAfter, Root };
    double position = 0.0; ///< of the leading axle
    bool reversed = false;
    double value = 0.0;
    Kind kind = Kind::Root;
};

/// What the search for a largest or least value looked at: forwards, ascending, then reversed. None of a train without
/// axles.
std::vector<CandidatePosition> candidate_positions(const femoop::influence::TrainSearch& search,
                                                   femoop::ExtremeKind kind);

} // namespace frame
