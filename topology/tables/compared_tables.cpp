#include "topology/tables/compared_tables.h"

#include <utility>

namespace topology {

namespace {

void compare_cells(TableRow& before, TableRow& after)
{
    for (std::size_t i = 0; i < before.cells.size(); ++i) {
        if (before.cells[i].number == after.cells[i].number) continue;
        before.cells[i].is_changed = after.cells[i].is_changed = true;
        before.mark = after.mark = RowMark::Changed;
    }
}

/// Both lists ascend by number.
void compare_rows(std::vector<TableRow>& before, std::vector<TableRow>& after)
{
    auto old_row = before.begin();
    auto new_row = after.begin();
    while (old_row != before.end() || new_row != after.end()) {
        const bool is_killed = new_row == after.end() || (old_row != before.end() && old_row->number < new_row->number);
        const bool is_created = old_row == before.end() || (!is_killed && new_row->number < old_row->number);
        if (is_killed) (old_row++)->mark = RowMark::Killed;
        else if (is_created) (new_row++)->mark = RowMark::Created;
        else compare_cells(*old_row++, *new_row++);
    }
}

} // namespace

ComparedTables compared(EntityTables before, EntityTables after)
{
    ComparedTables both{std::move(before), std::move(after)};
    for (std::size_t kind = 0; kind < n_table_kinds; ++kind)
        compare_rows(both.before.rows[kind], both.after.rows[kind]);
    return both;
}

} // namespace topology
