#include "femoop/model/check/suggestion.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <utility>

namespace femoop {

namespace {

constexpr std::size_t longest = 40; // longer names are compared by their beginnings

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

/// Optimal string alignment distance.
std::size_t distance(std::string_view a, std::string_view b)
{
    using Row = std::array<std::size_t, longest + 1>;
    Row before{}, above{}, row{};
    std::iota(above.begin(), above.end(), std::size_t{0});
    for (std::size_t i = 1; i <= a.size(); ++i) {
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const bool is_same = lower(a[i - 1]) == lower(b[j - 1]);
            row[j] = std::min({above[j] + 1, row[j - 1] + 1, above[j - 1] + (is_same ? 0 : 1)});
            const bool is_swap = i > 1 && j > 1 && lower(a[i - 1]) == lower(b[j - 2]) &&
                                 lower(a[i - 2]) == lower(b[j - 1]);
            if (is_swap) row[j] = std::min(row[j], before[j - 2] + 1);
        }
        before = above;
        above = row;
    }
    return above[b.size()];
}

} // namespace

std::optional<std::string> nearest(std::string_view typed, const std::vector<std::string_view>& candidates)
{
    const std::string_view name = typed.substr(0, longest);
    const std::size_t allowed = name.size() / 3; // one slip in three letters
    std::pair best{allowed + 1, std::size_t{0}}; // how far, and of equally far ones how unlike in length
    std::string_view found;
    for (const std::string_view candidate : candidates) {
        const std::string_view other = candidate.substr(0, longest);
        const std::size_t apart = std::max(name.size(), other.size()) - std::min(name.size(), other.size());
        if (apart > best.first) continue;
        const std::pair far{distance(name, other), apart};
        if (far >= best) continue;
        best = far;
        found = candidate;
    }
    if (best.first > allowed) return std::nullopt;
    return std::string(found);
}

} // namespace femoop
