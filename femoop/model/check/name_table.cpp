#include "femoop/model/check/name_table.h"

#include <cstdint>
#include <functional>

namespace femoop {

namespace {

struct Slot {
    std::uint32_t hash = 0;
    std::uint32_t entry = 0; ///< index + 1; 0 is free
};

std::size_t power_of_two_above(std::size_t n)
{
    std::size_t power = 1;
    while (power < n) power *= 2;
    return power;
}

} // namespace

// Open addressing: half of the slots stay free, so a name is found within a step or two and nothing is allocated for
// it.
std::vector<RepeatedName> repeated_names(const std::vector<std::string_view>& names)
{
    std::vector<Slot> slots(power_of_two_above(2 * names.size() + 1));
    const std::size_t mask = slots.size() - 1;
    std::vector<RepeatedName> repeated;
    for (std::size_t i = 0; i < names.size(); ++i) {
        const std::size_t hash = std::hash<std::string_view>()(names[i]);
        const auto short_hash = static_cast<std::uint32_t>(hash);
        std::size_t at = hash & mask;
        const auto is_other = [&](const Slot& slot) {
            return slot.entry != 0 && (slot.hash != short_hash || names[slot.entry - 1] != names[i]);
        };
        while (is_other(slots[at])) at = (at + 1) & mask;
        if (slots[at].entry != 0) repeated.push_back({i, slots[at].entry - std::size_t{1}});
        else slots[at] = {short_hash, static_cast<std::uint32_t>(i + 1)};
    }
    return repeated;
}

} // namespace femoop
