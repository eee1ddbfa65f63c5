#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace femoop {

/// A table for people: columns of words to the left, columns of numbers set on their decimal points, counts to the
/// right.
///
/// A column of numbers keeps one count of decimals, six significant digits of its largest number, so that round-off
/// beside large numbers reads 0; very large and very small columns are written with powers of ten.
class TextTable {
public:
    using Cell = std::variant<std::string, double, std::size_t>;

    explicit TextTable(std::vector<std::string> headers) : headers_(std::move(headers)) {}

    /// Numbers of one column and one kind have as many decimals: six significant digits of the largest.
    /// \pre as many cells as headers; a column holds words alone or numbers alone ("" stands for no number)
    void add_row(std::vector<Cell> cells, std::size_t kind = 0);
    bool is_empty() const { return rows_.empty(); }

    /// Numbers below 1e-12 of the largest in these columns become 0: they are round-off of a sum of large numbers.
    void silence_round_off(const std::vector<std::size_t>& columns);

    /// Every line begins with `indent` blanks and ends with a line break; none has blanks at its end.
    std::string text(std::size_t indent = 0, char decimal_mark = '.') const;

private:
    std::vector<std::string> headers_;
    struct Row {
        std::vector<Cell> cells;
        std::size_t kind;
    };
    std::vector<Row> rows_;
};

/// How many characters a terminal shows for a UTF-8 text.
std::size_t shown_width(std::string_view utf8);

} // namespace femoop
