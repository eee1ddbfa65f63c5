#pragma once

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

#include "femoop/solver/index.h"

namespace femoop {

/// Lists of numbers, one after the other.
struct Lists {
    std::vector<std::int32_t> start{0};
    std::vector<std::int32_t> items;

    std::int32_t n() const { return static_cast<std::int32_t>(start.size()) - 1; }
    std::span<const std::int32_t> operator[](std::int32_t i) const
    {
        return std::span(items).subspan(begin(i), end(i) - begin(i));
    }
    std::size_t begin(std::int32_t i) const { return at(start[at(i)]); }
    std::size_t end(std::int32_t i) const { return begin(i + 1); }
    /// Ends a list: items that come after this belong to the next one.
    void close() { start.push_back(static_cast<std::int32_t>(items.size())); }
};

/// To whom items 0 .. n - 1 belong: item i of list k becomes item k of list i.
inline Lists transposed(const Lists& lists, std::size_t n)
{
    Lists result;
    result.start.assign(n + 1, 0);
    for (const std::int32_t i : lists.items) ++result.start[at(i) + 1];
    std::partial_sum(result.start.begin(), result.start.end(), result.start.begin());
    result.items.resize(lists.items.size());
    std::vector<std::int32_t> next(result.start.begin(), result.start.end() - 1);
    for (std::int32_t k = 0; k < lists.n(); ++k)
        for (const std::int32_t i : lists[k]) result.items[at(next[at(i)]++)] = k;
    return result;
}

} // namespace femoop
