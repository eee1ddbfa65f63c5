#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "femoop/tabular/table.h"

namespace tabular {

/// Between two cells and after a row.
struct Separators {
    char cell = ',';
    std::string_view line_end = "\n";
};
inline constexpr Separators tabs{'\t', "\n"}; ///< as spreadsheets copy and paste

/// Cells written one after another as separated values (RFC 4180): a table of a million rows is one string.
///
/// A cell with a separator, a quotation mark or a line end in it stands in quotation marks, its own ones doubled.
/// Words that a spreadsheet would take for a formula, because they begin with = + - @, a tab or a carriage return, get
/// an apostrophe before them, as spreadsheets know it: -M is written '-M. Words that begin with apostrophes and then
/// such a sign get one more, so that `read_separated` gives back every text. Numbers are written as they are.
class SeparatedText {
public:
    explicit SeparatedText(Separators separators = {}) : separators_(separators) {}

    SeparatedText& operator<<(const Cell& cell);
    SeparatedText& operator<<(std::string_view words);
    SeparatedText& operator<<(const std::string& words) { return *this << std::string_view(words); }
    SeparatedText& operator<<(const char* words) { return *this << std::string_view(words); }
    SeparatedText& operator<<(double number); ///< the shortest that reads back as the same double
    void end_row();

    std::string take() { return std::move(text_); }

private:
    void add(std::string_view cell);

    Separators separators_;
    std::string text_;
    bool is_row_begin_ = true;
};

/// The labels of the columns and the rows, as programs read them. Title and notes are left out.
std::string separated(const Table& table, Separators separators = {});

/// Texts by row and column.
using TextBlock = std::vector<std::vector<std::string>>;

/// The cells of what was written so, by `SeparatedText` or by a spreadsheet: without quotation marks and apostrophes
/// that protect them. A quotation mark inside a cell that does not begin with one is a letter.
TextBlock read_separated(std::string_view text, char separator);

} // namespace tabular
