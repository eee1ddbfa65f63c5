#include "femoop/discretisation/parts.h"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

namespace femoop {

std::size_t n_joints(const Discretisation& structure)
{
    return static_cast<std::size_t>(std::ranges::count(structure.is_attached, true));
}

std::size_t n_parts(const Discretisation& structure)
{
    std::vector<std::uint32_t> root(structure.positions.size());
    std::iota(root.begin(), root.end(), 0U);
    const auto find = [&](std::uint32_t i) {
        while (root[i] != i) i = root[i] = root[root[i]];
        return i;
    };
    for (const Discretisation::MemberRow& member : structure.members)
        root[find(member.nodes[0].index)] = find(member.nodes[1].index);
    std::size_t n = 0;
    for (std::uint32_t i = 0; i < root.size(); ++i) n += structure.is_attached[i] && find(i) == i ? 1 : 0;
    return n;
}

} // namespace femoop
