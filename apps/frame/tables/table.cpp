#include "apps/frame/tables/table.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace frame {

CellBlock whole(const Table& table)
{
    CellBlock block{std::vector<std::size_t>(table.rows.size()), 0, table.headings.size() - 1};
    std::iota(block.rows.begin(), block.rows.end(), std::size_t{0});
    return block;
}

Heading number_heading(std::string label, bool is_editable)
{
    return {{std::move(label), "", tabular::Alignment::Right}, is_editable};
}

namespace {

// Names that end in numbers are put in the order of the numbers: N2 before N10.
bool is_before_name(std::string_view a, std::string_view b)
{
    const auto digits_at = [](std::string_view s, std::size_t i) {
        return std::min(s.find_first_not_of("0123456789", i), s.size()) - i;
    };
    for (std::size_t i = 0, j = 0; i < a.size() && j < b.size();) {
        const std::size_t n = digits_at(a, i), m = digits_at(b, j);
        if (n > 0 && m > 0) {
            const auto order = std::pair(n, a.substr(i, n)) <=> std::pair(m, b.substr(j, m));
            if (order != 0) return order < 0;
            i += n;
            j += m;
        } else {
            if (a[i] != b[j]) return a[i] < b[j];
            ++i;
            ++j;
        }
    }
    return a.size() < b.size();
}

bool is_before(const tabular::Cell& a, const tabular::Cell& b)
{
    if (a.number && b.number) return *a.number < *b.number;
    if (a.number || b.number) return a.number.has_value();
    if (a.shown.empty() || b.shown.empty()) return !a.shown.empty() && b.shown.empty();
    return is_before_name(a.shown, b.shown);
}

} // namespace

std::vector<std::size_t> sorted_rows(const Table& table, std::size_t column)
{
    std::vector<std::size_t> rows = whole(table).rows;
    std::ranges::stable_sort(rows, [&](std::size_t a, std::size_t b) {
        return is_before(table.rows[a].cells[column].value, table.rows[b].cells[column].value);
    });
    return rows;
}

tabular::Table values(const Table& table, const CellBlock& block)
{
    tabular::Table values;
    for (std::size_t j = block.first_column; j <= block.last_column; ++j)
        values.columns.push_back(table.headings[j].column);
    for (const std::size_t row : block.rows) {
        std::vector<tabular::Cell> cells;
        for (std::size_t j = block.first_column; j <= block.last_column; ++j)
            cells.push_back(table.rows[row].cells[j].value);
        values.add_row(std::move(cells));
    }
    return values;
}

std::string csv(const Table& table, ui::DecimalMark mark)
{
    return separated(values(table, whole(table)), {mark == ui::DecimalMark::Comma ? ';' : ',', "\r\n"});
}

} // namespace frame
