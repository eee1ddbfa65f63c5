#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "apps/frame/document/part.h"
#include "femoop/model/moving_load.h"
#include "femoop/tabular/separated.h"
#include "ui/text/catalogue.h"
#include "ui/text/display_units.h"

namespace frame {

/// How the texts of a table are written and understood.
struct Manner {
    ui::DisplayUnits units;
    ui::Catalogue tr;
};

/// A column, and whether its cells can be changed.
struct Heading {
    tabular::Column column; ///< labelled with its unit: "x [m]"
    bool is_editable = false;

    bool is_number() const { return column.alignment == tabular::Alignment::Right; }
};
Heading number_heading(std::string label, bool is_editable = false);

/// One value, with the text in which it is edited: nothing is lost if that is confirmed as it stands.
struct Cell {
    tabular::Cell value{}; ///< shown rounded with a true minus; exact for a spreadsheet, without a unit
    std::string typed = exact_text(value);
    std::optional<femoop::MovingEffect> number{}; ///< of the results, that it shows
    std::optional<femoop::CaseId> of_case{};      ///< in an envelope: the one that governs
};

struct Row {
    std::optional<Part> part; ///< that the row is about
    std::vector<Cell> cells;
};

/// A table that is edited: a value made from a document or its results, in one language and one set of units.
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

/// What is written of it: the block with its headings.
tabular::Table values(const Table& table, const CellBlock& block);

/// As comma-separated values with the line ends of RFC 4180; separated by semicolons where the comma is the decimal
/// mark.
std::string csv(const Table& table, ui::DecimalMark mark);

using tabular::TextBlock; ///< as a clipboard holds them

} // namespace frame
