#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "apps/frame/document/part.h"
#include "ui/text/catalogue.h"
#include "ui/text/display_units.h"

namespace frame {

/// How the texts of a table are written and understood.
struct Manner {
    ui::DisplayUnits units;
    ui::Catalogue tr;
};

struct Heading {
    std::string label; ///< with its unit: "x [m]"
    bool is_number = false;
    bool is_editable = false;
};

/// One value of a table, ready to be read.
struct Cell {
    std::string shown{};            ///< rounded, with a true minus sign
    std::string typed{};            ///< as it is edited: nothing is lost if it is confirmed as it stands
    std::string plain{};            ///< for a spreadsheet: every digit, no unit
    std::optional<double> number{}; ///< in the unit of the heading; what numbers are sorted by
};

struct Row {
    std::optional<Part> part; ///< that the row is about
    std::vector<Cell> cells;
};

/// What a spreadsheet would show: a value made from a document or its results, in one language and one set of units.
struct Table {
    std::vector<Heading> headings;
    std::vector<Row> rows;
};

/// Rows, in the order in which they are seen, and columns from first to last.
struct CellBlock {
    std::vector<std::size_t> rows;
    std::size_t first_column = 0, last_column = 0;
};
CellBlock whole(const Table& table);

/// The rows in ascending order of a column; numbers by value and before words, rows without a value last.
std::vector<std::size_t> sorted_rows(const Table& table, std::size_t column);

/// The block with its headings as tab-separated values, as spreadsheets copy and paste them.
std::string tsv(const Table& table, const CellBlock& block);

/// The same as comma-separated values (RFC 4180); separated by semicolons where the comma is the decimal mark.
std::string csv(const Table& table, ui::DecimalMark mark);

/// Texts by row and column, as a clipboard holds them.
using TextBlock = std::vector<std::vector<std::string>>;
TextBlock read_tsv(std::string_view text);

} // namespace frame
