#include "femoop/methods/dice.h"

namespace femoop {

double Dice::roll(int least, int most, int step)
{
    state_ ^= state_ << 13;
    state_ ^= state_ >> 7;
    state_ ^= state_ << 17;
    const auto n = static_cast<std::uint64_t>((most - least) / step + 1);
    return least + step * static_cast<int>(state_ % n);
}

} // namespace femoop
