#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "topology/tables/entity_tables.h"

namespace topology {

/// An entity's row before and after a step; one is absent of what the step made or killed.
struct ComparedRow {
    std::optional<TableRow> before, after;
};

/// The tables before and after a step side by side, a row for every entity of either, with the marks of what the step
/// made, killed and changed, and in both rows of each cell that differs. Rows are made when they are asked for.
class ComparedTables {
public:
    ComparedTables() = default;
    ComparedTables(EntityRows before, EntityRows after);

    std::size_t size(TableKind kind) const { return pairs(kind).size(); }
    ComparedRow operator()(TableKind kind, std::size_t row) const; ///< \pre row < size(kind)
    /// The first row that the step made, killed or changed.
    std::optional<std::size_t> first_changed(TableKind kind) const { return changed_[static_cast<std::size_t>(kind)]; }

private:
    /// Places in the tables before and after.
    struct Pair {
        std::uint32_t before, after;
    };
    static constexpr std::uint32_t absent = static_cast<std::uint32_t>(-1);
    const std::vector<Pair>& pairs(TableKind kind) const { return pairs_[static_cast<std::size_t>(kind)]; }
    std::vector<Pair> paired(TableKind kind) const;
    bool is_same(TableKind kind, const Pair& pair) const;

    EntityRows before_, after_;
    std::array<std::vector<Pair>, n_table_kinds> pairs_;
    std::array<std::optional<std::size_t>, n_table_kinds> changed_;
};

} // namespace topology
