#include "femoop/tabular/table.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace tabular {

std::string shortest(double value)
{
    std::array<char, 32> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value == 0.0 ? 0.0 : value).ptr;
    return {digits.data(), end};
}

std::string exact_text(const Cell& cell)
{
    if (!cell.exact.empty()) return cell.exact;
    return cell.number ? shortest(*cell.number) : cell.shown;
}

namespace {

std::optional<double> number_of(std::string text)
{
    std::ranges::replace(text, ',', '.');
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool is_whole = error == std::errc() && end == text.data() + text.size();
    return is_whole && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

} // namespace

Cell written_cell(std::string shown)
{
    constexpr std::string_view minus = "−";
    Cell cell;
    cell.exact = shown;
    for (auto at = cell.exact.find(minus); at != std::string::npos; at = cell.exact.find(minus))
        cell.exact.replace(at, minus.size(), "-");
    cell.number = number_of(cell.exact);
    cell.shown = std::move(shown);
    return cell;
}

std::string shown_text(const Cell& cell)
{
    return cell.number && cell.shown.empty() ? shortest(*cell.number) : cell.shown;
}

std::vector<std::string> shown_texts(const Row& row)
{
    std::vector<std::string> texts;
    for (const Cell& cell : row.cells) texts.push_back(shown_text(cell));
    return texts;
}

std::vector<std::string> labels(const Table& table)
{
    std::vector<std::string> labels;
    for (const Column& column : table.columns) labels.push_back(column.label());
    return labels;
}

std::string Column::label() const { return unit.empty() ? heading : heading + " [" + unit + "]"; }

void Table::add_row(std::vector<Cell> cells, std::size_t kind)
{
    if (cells.size() != columns.size()) throw std::invalid_argument("Table: a row needs as many cells as columns");
    rows.push_back({std::move(cells), kind});
}

void Table::silence_round_off(const std::vector<std::size_t>& of_columns)
{
    constexpr double round_off = 1.0e-12;
    double largest = 0.0;
    const auto each_number = [&](auto&& visit) {
        for (Row& row : rows)
            for (const std::size_t column : of_columns)
                if (auto& number = row.cells[column].number) visit(*number);
    };
    each_number([&](double value) { largest = std::max(largest, std::abs(value)); });
    each_number([&](double& value) {
        if (std::abs(value) < round_off * largest) value = 0.0;
    });
}

Alignment alignment(const Table& table, std::size_t column)
{
    if (table.columns[column].alignment) return *table.columns[column].alignment;
    const auto is_number = [column](const Row& row) { return row.cells[column].is_number(); };
    return std::ranges::any_of(table.rows, is_number) ? Alignment::Right : Alignment::Left;
}

bool has_headings(const Table& table)
{
    return std::ranges::any_of(table.columns, [](const Column& column) { return !column.label().empty(); });
}

Table columns_of(const Table& table, const std::vector<std::size_t>& chosen)
{
    Table part;
    part.title = table.title;
    part.notes = table.notes;
    part.n_sums = table.n_sums;
    for (const std::size_t i : chosen) part.columns.push_back(table.columns[i]);
    for (const Row& row : table.rows) {
        std::vector<Cell> cells;
        for (const std::size_t i : chosen) cells.push_back(row.cells[i]);
        part.add_row(std::move(cells), row.kind);
    }
    return part;
}

} // namespace tabular
