#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace femoop {

/// Numbers that a seed determines on every machine, since the standard's distributions are not the same everywhere.
class Dice {
public:
    explicit Dice(std::uint32_t seed) : state_(0x9E3779B97F4A7C15ULL * (seed + 1ULL)) {}
    /// From `least` to `most`, in steps.
    double roll(int least, int most, int step = 1);
    double sign() { return roll(0, 1) == 0.0 ? -1.0 : 1.0; }
    template <class T, std::size_t n> const T& pick(const std::array<T, n>& choices)
    {
        return choices[static_cast<std::size_t>(roll(0, static_cast<int>(n) - 1))];
    }

private:
    std::uint64_t state_;
};

} // namespace femoop
