#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tabular {

/// One value of a table: words, or a number with what people and programs read of it.
struct Cell {
    std::string shown{};            ///< as people read it; a number without one has the digits of its column
    std::string exact{};            ///< as programs read it; empty: every digit of the number, or the words shown
    std::optional<double> number{}; ///< absent for words

    Cell() = default; ///< nothing
    Cell(std::string words) : shown(std::move(words)) {}
    Cell(std::string_view words) : shown(words) {}
    Cell(const char* words) : shown(words) {}
    Cell(double value) : number(value) {}
    Cell(std::size_t count) : shown(std::to_string(count)), number(static_cast<double>(count)) {}
    /// A number that is rounded, and written for a language, already.
    Cell(double value, std::string as_shown, std::string as_exact = {})
        : shown(std::move(as_shown)), exact(std::move(as_exact)), number(value)
    {}

    bool is_number() const { return number.has_value(); }
    friend bool operator==(const Cell&, const Cell&) = default;
};

/// A number as people write it, with a true minus or a decimal comma: programs read a hyphen; words where it is none.
Cell written_cell(std::string shown);

/// As a program reads it: the shortest number that reads back as the same double, with a decimal point; words as shown.
std::string exact_text(const Cell& cell);

/// As people read it; a number that is not written yet has all its digits.
std::string shown_text(const Cell& cell);

/// The shortest decimal that reads back as the same double: 0.1, -25, 2.05e+08; minus zero is 0.
std::string shortest(double value);

enum class Alignment { Left, Right };

struct Column {
    std::string heading;
    std::string unit{};                   ///< "kN*m"; empty for words and plain numbers
    std::optional<Alignment> alignment{}; ///< absent: right where the column has numbers

    Column(std::string of, std::string in = {}, std::optional<Alignment> at = std::nullopt)
        : heading(std::move(of)), unit(std::move(in)), alignment(at)
    {}
    Column(std::string_view of) : heading(of) {}
    Column(const char* of) : heading(of) {}

    std::string label() const; ///< "M [kN*m]"
};

struct Row {
    std::vector<Cell> cells;
    std::size_t kind = 0; ///< numbers of one column and one kind have as many decimals
};

std::vector<std::string> shown_texts(const Row& row);

/// Rows and columns with what is said of them: a value that every writer beside this file can write.
struct Table {
    std::string title{};
    std::vector<std::string> notes{}; ///< sentences above it
    std::vector<Column> columns{};
    std::vector<Row> rows{};
    std::size_t n_sums = 0; ///< rows at the end that are set apart: they add up those above

    Table() = default;
    explicit Table(std::vector<Column> of) : columns(std::move(of)) {}

    /// \throws std::invalid_argument unless there are as many cells as columns
    void add_row(std::vector<Cell> cells, std::size_t kind = 0);
    bool is_empty() const { return rows.empty(); }

    /// Numbers below 1e-12 of the largest in these columns become 0: they are round-off of a sum of large numbers.
    void silence_round_off(const std::vector<std::size_t>& of_columns);
};

std::vector<std::string> labels(const Table& table); ///< of its columns

/// That of the column, else by what it holds.
Alignment alignment(const Table& table, std::size_t column);
bool has_headings(const Table& table); ///< one that says something

/// These columns of all rows; the title, the notes and the sums go with them.
Table columns_of(const Table& table, const std::vector<std::size_t>& chosen);

} // namespace tabular
