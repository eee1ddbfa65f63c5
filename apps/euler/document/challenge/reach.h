#pragma once

#include <cstddef>
#include <cstdint>

#include "apps/euler/document/stepper.h"

namespace euler {

enum class Level : std::uint8_t { Easy, Middle, Hard };

/// "Reach this solid in at most n operators." The structure counts, not where the vertices are: operators change links,
/// and a student should not be held up by typing coordinates.
struct ReachChallenge {
    ui::Message task;
    topology::Solid target;
    std::string way;                ///< a script that reaches it with the fewest operators that are known
    std::size_t most_operators = 0; ///< of that script
};
ReachChallenge reach_challenge(std::uint32_t seed, Level level);

/// How an attempt stands at its place. A sweep counts as the operators that it is made of.
struct ReachState {
    std::size_t n_operators = 0;
    bool is_reached = false; ///< whatever number of operators it took
    bool is_won = false;     ///< and with no more than are allowed
    ui::Message hint;        ///< what is still missing, or too much; shown when asked for
};
ReachState judged(const ReachChallenge& challenge, const Stepper& attempt);

} // namespace euler
