#include "femoop/tabular/plain_text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <vector>

#include "femoop/tabular/halves.h"

namespace tabular {

namespace {

/// How the numbers of one column are written.
struct NumberFormat {
    bool is_scientific = false;
    int decimals = 0;
    char mark = '.';
};

constexpr int digits = 6; // significant ones of the largest number

/// Of the power of ten, once the number is rounded to the digits that are written.
int exponent_of(double number)
{
    std::array<char, 32> text{};
    const int n = std::snprintf(text.data(), text.size(), "%.*e", digits - 1, number);
    const std::string_view written(text.data(), static_cast<std::size_t>(n));
    return std::atoi(written.data() + written.find('e') + 1);
}

NumberFormat format_for(double largest)
{
    if (largest == 0.0) return {};
    const int exponent = exponent_of(largest);
    if (exponent < -4 || exponent > 8) return {true, digits - 1};
    return {false, std::max(0, digits - 1 - exponent)};
}

bool is_zero_text(std::string_view text) { return text.find_first_of("123456789") == std::string_view::npos; }

std::string number(double value, NumberFormat format)
{
    if (value == 0.0) return "0";
    value = off_half(value);
    std::array<char, 512> buffer{};
    const int n = format.is_scientific ? std::snprintf(buffer.data(), buffer.size(), "%.*e", format.decimals, value)
                                       : std::snprintf(buffer.data(), buffer.size(), "%.*f", format.decimals, value);
    std::string text(buffer.data(), static_cast<std::size_t>(n));
    std::replace(text.begin(), text.end(), '.', format.mark);
    return is_zero_text(text) ? "0" : text;
}

/// From the decimal mark on.
std::size_t tail_width(std::string_view number, char mark)
{
    const std::size_t at = number.find(mark);
    return at == std::string_view::npos ? 0 : number.size() - at;
}

std::size_t width_of(const std::vector<std::string>& lines)
{
    std::size_t width = 0;
    for (const std::string& line : lines) width = std::max(width, shown_width(line));
    return width;
}

/// One column, written: every cell as wide as the others, numbers on their decimal marks.
class ColumnText {
public:
    ColumnText(const Table& table, std::size_t column, char decimal_mark)
        : table_(table), column_(column), mark_(decimal_mark)
    {
        for (const Row& row : table.rows) {
            const Cell& cell = row.cells[column];
            is_numeric_ = is_numeric_ || cell.is_number();
            if (!cell.number || !cell.shown.empty()) continue;
            double& largest = largest_[row.kind];
            largest = std::max(largest, std::abs(*cell.number));
        }
    }

    std::vector<std::string> lines() const
    {
        std::vector<std::string> lines;
        for (const Row& row : table_.rows) lines.push_back(text(row));
        if (is_numeric_) put_on_marks(lines);
        lines.insert(lines.begin(), table_.columns[column_].label());
        const bool is_right = alignment(table_, column_) == Alignment::Right;
        const std::size_t width = width_of(lines);
        for (std::string& line : lines) line.insert(is_right ? 0 : line.size(), width - shown_width(line), ' ');
        return lines;
    }

private:
    std::string text(const Row& row) const
    {
        const Cell& cell = row.cells[column_];
        if (!cell.number || !cell.shown.empty()) return cell.shown;
        NumberFormat format = format_for(largest_.at(row.kind));
        format.mark = mark_;
        return number(*cell.number, format);
    }

    void put_on_marks(std::vector<std::string>& lines) const
    {
        std::size_t tail = 0;
        for (const std::string& line : lines) tail = std::max(tail, tail_width(line, mark_));
        for (std::string& line : lines)
            if (!line.empty()) line.append(tail - tail_width(line, mark_), ' ');
    }

    const Table& table_;
    std::size_t column_;
    char mark_;
    bool is_numeric_ = false;
    std::map<std::size_t, double> largest_; ///< of each kind
};

} // namespace

std::size_t shown_width(std::string_view utf8)
{
    return static_cast<std::size_t>(std::count_if(
        utf8.begin(), utf8.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

std::string plain_text(const Table& table, const PlainTextLook& look)
{
    std::vector<std::string> lines(table.rows.size() + 1, std::string(look.indent, ' '));
    for (std::size_t c = 0; c < table.columns.size(); ++c) {
        const std::vector<std::string> cells = ColumnText(table, c, look.decimal_mark).lines();
        for (std::size_t i = 0; i < lines.size(); ++i) lines[i] += (c == 0 ? "" : "  ") + cells[i];
    }
    std::string text;
    for (std::string& line : lines) {
        line.erase(line.find_last_not_of(' ') + 1);
        text += line + '\n';
    }
    return text;
}

} // namespace tabular
