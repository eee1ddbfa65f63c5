#pragma once

#include <algorithm>

namespace euler {

/// What a challenge is worth: three points, less one for each hint and each wrong answer.
struct Score {
    int hints = 0, misses = 0;

    static constexpr int most = 3;
    int points() const { return std::max(0, most - hints - misses); }
};

} // namespace euler
