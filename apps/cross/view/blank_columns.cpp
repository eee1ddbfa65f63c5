#include "apps/cross/view/blank_columns.h"

#include <algorithm>

namespace cross {

namespace fc = femoop::cross;
using fc::Asked;

namespace {

class Filler {
public:
    Filler(const Worksheet& worksheet, std::size_t stage) : form_(worksheet.form), stage_(stage)
    {
        for (std::size_t e = 0; e < form_.problem.ends.size(); ++e) columns_.push_back({.end = fc::EndId(e)});
    }

    std::vector<BlankColumn> of_sheet()
    {
        for (BlankColumn& column : columns_) {
            if (stage_ == 0) {
                put(column, Asked::Stiffness, 0, "k", 0);
                put(column, Asked::Factor, 0, "µ", 1);
            }
            const std::size_t line = stage_ == 0 ? 2 : 0;
            put(column, Asked::FixedEnd, 0, "M", line);
            column.n_lines = std::max(column.n_lines, line + 1);
        }
        for (std::size_t step = 0; step < form_.turns[stage_].size(); ++step) put_turn(step);
        for (BlankColumn& column : columns_) put(column, Asked::Sum, 0, "Σ", column.n_lines);
        for (BlankColumn& column : columns_)
            if (!form_.problem[column.end].joint) move_up(column);
        return std::move(columns_);
    }

    std::vector<BlankColumn> of_all_sheets()
    {
        for (BlankColumn& column : columns_)
            if (const auto blank = form_.find(Asked::Final, 0, 0, column.end.index))
                column.cells.push_back({*blank, column.n_lines++, "M"});
        return std::move(columns_);
    }

private:
    void put(BlankColumn& column, Asked asked, std::size_t step, const std::string& label, std::size_t line)
    {
        const auto blank = form_.find(asked, stage_, step, column.end.index);
        if (!blank) return;
        column.cells.push_back({*blank, line, label});
        column.n_lines = std::max(column.n_lines, line + 1);
    }

    /// A far end has no neighbour to be in line with.
    static void move_up(BlankColumn& column)
    {
        if (column.cells.empty()) return;
        const std::size_t first = column.cells.front().line;
        for (BlankCell& cell : column.cells) cell.line -= first;
        column.n_lines -= first;
    }

    void put_turn(std::size_t step)
    {
        const fc::Turn& turn = form_.turns[stage_][step];
        const std::string number = std::to_string(step + 1);
        for (std::size_t j = 0; j < form_.problem.joints.size(); ++j) {
            if (turn && turn->index != j) continue;
            const std::vector<fc::EndId>& ends = form_.problem.joints[j].ends;
            std::size_t line = 0;
            for (const fc::EndId e : ends) line = std::max(line, columns_[e.index].n_lines);
            for (const fc::EndId e : ends) put(columns_[e.index], Asked::Balance, step, number, line);
        }
        for (BlankColumn& column : columns_) put(column, Asked::CarryOver, step, "→" + number, column.n_lines);
    }

    const fc::Form& form_;
    std::size_t stage_;
    std::vector<BlankColumn> columns_;
};

} // namespace

std::vector<BlankColumn> blank_columns(const Worksheet& worksheet, std::size_t stage)
{
    Filler filler(worksheet, stage);
    return stage < worksheet.n_sheets() ? filler.of_sheet() : filler.of_all_sheets();
}

std::vector<BlankCell> superposition_cells(const Worksheet& worksheet)
{
    std::vector<BlankCell> cells;
    for (std::size_t i = 0; i < worksheet.form.blanks.size(); ++i) {
        const fc::Blank& blank = worksheet.form.blanks[i];
        const std::string of = worksheet.form.problem.sways.size() > 1 ? std::to_string(blank.sway + 1) : "";
        if (blank.asked == Asked::Holding)
            cells.push_back({fc::BlankId(i), cells.size(), "R" + of + std::to_string(blank.sheet)});
        if (blank.asked == Asked::Multiplier) cells.push_back({fc::BlankId(i), cells.size(), "x" + of});
    }
    return cells;
}

} // namespace cross
