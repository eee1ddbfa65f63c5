#include "topology/tables/compared_tables.h"

#include <algorithm>

namespace topology {

namespace {

void mark_differences(TableRow& before, TableRow& after)
{
    for (std::size_t i = 0; i < before.cells.size(); ++i) {
        if (before.cells[i].number == after.cells[i].number) continue;
        before.cells[i].is_changed = after.cells[i].is_changed = true;
        before.mark = after.mark = RowMark::Changed;
    }
}

} // namespace

ComparedTables::ComparedTables(EntityRows before, EntityRows after)
    : before_(std::move(before)), after_(std::move(after))
{
    for (std::size_t k = 0; k < n_table_kinds; ++k) {
        const auto kind = static_cast<TableKind>(k);
        pairs_[k] = paired(kind);
        const auto first = std::find_if(pairs_[k].begin(), pairs_[k].end(),
                                        [&](const Pair& pair) { return !is_same(kind, pair); });
        if (first != pairs_[k].end()) changed_[k] = static_cast<std::size_t>(first - pairs_[k].begin());
    }
}

/// Both lists ascend by number.
std::vector<ComparedTables::Pair> ComparedTables::paired(TableKind kind) const
{
    constexpr std::size_t beyond = static_cast<std::size_t>(-1);
    std::vector<Pair> pairs;
    const auto n_before = static_cast<std::uint32_t>(before_.size(kind)),
               n_after = static_cast<std::uint32_t>(after_.size(kind));
    pairs.reserve(std::max(n_before, n_after));
    for (std::uint32_t i = 0, j = 0; i < n_before || j < n_after;) {
        const std::size_t old_number = i < n_before ? before_.number(kind, i) : beyond;
        const std::size_t new_number = j < n_after ? after_.number(kind, j) : beyond;
        pairs.push_back({old_number <= new_number ? i++ : absent, new_number <= old_number ? j++ : absent});
    }
    return pairs;
}

bool ComparedTables::is_same(TableKind kind, const Pair& pair) const
{
    return pair.before != absent && pair.after != absent &&
           before_.numbers(kind, pair.before) == after_.numbers(kind, pair.after);
}

ComparedRow ComparedTables::operator()(TableKind kind, std::size_t row) const
{
    const Pair pair = pairs(kind)[row];
    ComparedRow both;
    if (pair.before != absent) both.before = before_(kind, pair.before);
    if (pair.after != absent) both.after = after_(kind, pair.after);
    if (!both.after) both.before->mark = RowMark::Killed;
    else if (!both.before) both.after->mark = RowMark::Created;
    else mark_differences(*both.before, *both.after);
    return both;
}

} // namespace topology
