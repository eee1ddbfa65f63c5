#pragma once

#include <string_view>
#include <vector>

#include "apps/mohr/exercise/answer.h"

namespace mohr {

/// A mistake that is often made, and what it gives.
struct Slip {
    double value;
    std::string_view words;
};

/// Those of one question, from the numbers before it.
std::vector<Slip> slips(Asked asked, const Exercise& exercise, const Numbers& numbers);

} // namespace mohr
