#include "topology/tables/table_text.h"

namespace topology {

namespace {

std::string text(const TableCell& cell) { return std::string(cell.label) + " = " + std::to_string(cell.number); }

} // namespace

std::string line_text(const TableRow& row)
{
    std::string line = std::string(row.label) + " = " + std::to_string(row.number) + " (";
    const std::size_t n_inside = row.cells.size() - 2;
    for (std::size_t i = 0; i < n_inside; ++i) {
        if (i != 0) line += row.cells[i].label == "LOOPS" ? " / " : ", ";
        line += text(row.cells[i]);
    }
    return line + ") " + text(row.cells[n_inside]) + " " + text(row.cells[n_inside + 1]);
}

std::string table_text(const Solid& solid, const SolidPlace& place)
{
    std::string lines;
    for (const std::vector<TableRow>& rows : entity_tables(solid, place).rows)
        for (const TableRow& row : rows) lines += line_text(row) + "\n";
    return lines;
}

} // namespace topology
