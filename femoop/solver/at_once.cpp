#include "femoop/solver/at_once.h"

#include <algorithm>
#include <cstdint>

#include "femoop/solver/team.h"

namespace femoop {

void at_once(const std::function<void()>& first, const std::function<void()>& second)
{
    Team(std::min(2, Team::natural_size())).for_each(2, [&](std::int32_t item, int) {
        (item == 0 ? first : second)();
    });
}

void in_ranges(std::size_t n, std::size_t length, const RangeWork& work)
{
    const std::size_t n_ranges = (n + length - 1) / length;
    const auto do_range = [&](std::int32_t range, int) {
        const std::size_t begin = static_cast<std::size_t>(range) * length;
        work(begin, std::min(n, begin + length));
    };
    Team(n_ranges > 1 ? Team::natural_size() : 1).for_each(static_cast<std::int32_t>(n_ranges), do_range);
}

} // namespace femoop
