#pragma once

#include <optional>
#include <vector>

#include "femoop/methods/cross/exercise/slip.h"

namespace femoop::cross {

/// What a pupil wrote into a cell.
struct Entry {
    double value = 0.0;
    double unit = 0.0; ///< of the last digit that was written: 0.01 for 0.43; 0: exact, as a fraction is
    friend bool operator==(const Entry&, const Entry&) = default;
};

enum class Verdict : std::uint8_t {
    Open, ///< nothing was written yet
    Right,
    FollowsRight, ///< by the right operation from numbers that are wrong
    Slipped,      ///< by one of the mistakes that have a name
    Wrong
};

struct Judgement {
    Verdict verdict = Verdict::Open;
    std::vector<Slip> slips{}; ///< that give what was written, the nearest first
};

/// Judges every cell by what stands before it: what is right in itself, else what is right for the numbers that were
/// had, else which mistake gives it. A number counts as equal to another within one unit of its last digit, but no more
/// than the larger of 1.5 % of it and 0.3 % of the largest number of its kind, and what want of digits before it
/// explains.
///
/// A carry-over that was left out while its joint was gone on with is a mistake; other empty cells are open, and what
/// follows takes them for what belongs there.
std::vector<Judgement> judge(const Form& form, const std::vector<std::optional<Entry>>& entries);

/// What belongs in each cell for the numbers that were had: what "show me this cell" writes.
std::vector<double> following(const Form& form, const std::vector<std::optional<Entry>>& entries);

} // namespace femoop::cross
