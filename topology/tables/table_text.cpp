#include "topology/tables/table_text.h"

#include <array>
#include <charconv>
#include <vector>

namespace topology {

namespace {

/// The words of a kind's lines, between which the numbers stand: "V = ", " (H = ", ") N = ", " P = ".
class Line {
public:
    explicit Line(const TableRow& like)
    {
        const std::size_t n_inside = like.cells.size() - 2;
        words_.push_back(std::string(like.label) + " = ");
        for (std::size_t i = 0; i < like.cells.size(); ++i) {
            const bool ends_inside = i == n_inside, is_last = i == n_inside + 1;
            const char* before = i == 0                           ? " ("
                                 : ends_inside                    ? ") "
                                 : is_last                        ? " "
                                 : like.cells[i].label == "LOOPS" ? " / "
                                                                  : ", ";
            words_.push_back(before + std::string(like.cells[i].label) + " = ");
        }
    }

    void append(std::string& text, std::size_t number, const EntityRows::Numbers& cells) const
    {
        append(text, words_.front(), number);
        for (std::size_t i = 1; i < words_.size(); ++i) append(text, words_[i], cells[i - 1]);
    }

private:
    static void append(std::string& text, const std::string& words, std::size_t number)
    {
        std::array<char, 24> digits{};
        const auto written = std::to_chars(digits.data(), digits.data() + digits.size(), number);
        text.append(words).append(digits.data(), written.ptr);
    }

    std::vector<std::string> words_;
};

} // namespace

std::string line_text(const TableRow& row)
{
    EntityRows::Numbers numbers{};
    for (std::size_t i = 0; i < row.cells.size(); ++i) numbers[i] = row.cells[i].number;
    std::string text;
    Line(row).append(text, row.number, numbers);
    return text;
}

// A line in every step is written for every entity, so it is put together without a row.
void append_table_text(std::string& text, const Solid& solid, const SolidPlace& place)
{
    const EntityRows rows(solid, place);
    for (std::size_t k = 0; k < n_table_kinds; ++k) {
        const auto kind = static_cast<TableKind>(k);
        if (rows.size(kind) == 0) continue;
        const Line line(rows(kind, 0));
        for (std::size_t row = 0; row < rows.size(kind); ++row) {
            line.append(text, rows.number(kind, row), rows.numbers(kind, row));
            text += '\n';
        }
    }
}

std::string table_text(const Solid& solid, const SolidPlace& place)
{
    std::string lines;
    append_table_text(lines, solid, place);
    return lines;
}

} // namespace topology
