#include "apps/cross/view/columns.h"

#include <algorithm>

namespace cross {

namespace fc = femoop::cross;

namespace {

void write(Column& column, fc::RowKind kind, double value, std::size_t step)
{
    column.cells.push_back({.kind = kind, .value = value, .level = column.n_levels, .step = step});
    ++column.n_levels;
}

/// All ends of a joint go on from the same line.
void line_up(std::vector<Column>& columns, const fc::Joint& joint)
{
    std::size_t level = 0;
    for (const fc::EndId end : joint.ends) level = std::max(level, columns[end.index].n_levels);
    for (const fc::EndId end : joint.ends) columns[end.index].n_levels = level;
}

} // namespace

std::vector<Column> columns_of(const fc::Problem& problem, const fc::Sheet& sheet)
{
    std::vector<Column> columns;
    for (std::size_t e = 0; e < problem.ends.size(); ++e) {
        columns.push_back({.end = fc::EndId(e)});
        write(columns.back(), fc::RowKind::FixedEnd, sheet.start.moments[e], 0);
    }
    for (std::size_t i = 0; i < sheet.steps.size(); ++i) {
        const fc::Step& step = sheet.steps[i];
        for (std::size_t j = 0; j < problem.joints.size(); ++j)
            if (!step.joint || step.joint->index == j) line_up(columns, problem.joints[j]);
        for (const fc::Change& change : sheet.balanced(step))
            write(columns[change.end.index], fc::RowKind::Balance, change.value, i + 1);
        for (const fc::Change& change : sheet.carried_over(step))
            write(columns[change.end.index], fc::RowKind::CarryOver, change.value, i + 1);
    }
    return columns;
}

} // namespace cross
