#pragma once

#include <algorithm>
#include <array>

namespace cli {

/// What the command tells the shell.
enum class ExitStatus : int {
    Done = 0,
    No = 1,          ///< the answer is no: a check failed
    BadInput = 2,    ///< the input or the arguments are bad
    CannotSolve = 3, ///< the structure is a mechanism, or its constraints contradict its loads
};

/// Of several files the status is 2 before 3 before 1.
constexpr ExitStatus worse(ExitStatus a, ExitStatus b)
{
    constexpr std::array ranks{0, 1, 3, 2};
    return ranks[static_cast<std::size_t>(a)] >= ranks[static_cast<std::size_t>(b)] ? a : b;
}

} // namespace cli
