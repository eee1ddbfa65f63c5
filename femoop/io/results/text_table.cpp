#include "femoop/io/results/text_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <stdexcept>

namespace femoop {

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

/// One column, written: every cell as wide as the others, numbers on their decimal marks.
class Column {
public:
    Column(std::string header, char decimal_mark) : header_(std::move(header)), mark_(decimal_mark) {}

    void add(const TextTable::Cell& cell, std::size_t kind)
    {
        cells_.push_back({cell, kind});
        has_counts_ = has_counts_ || std::holds_alternative<std::size_t>(cell);
        const double* const value = std::get_if<double>(&cell);
        if (value == nullptr) return;
        double& largest = largest_[kind];
        largest = std::max(largest, std::abs(*value));
    }

    std::vector<std::string> lines() const
    {
        const bool is_numeric = has_counts_ || !largest_.empty();
        std::vector<std::string> lines = is_numeric ? numbers() : words();
        std::size_t width = shown_width(header_);
        for (const std::string& line : lines) width = std::max(width, shown_width(line));
        lines.insert(lines.begin(), header_);
        for (std::string& line : lines) line.insert(is_numeric ? 0 : line.size(), width - shown_width(line), ' ');
        return lines;
    }

private:
    struct Entry {
        TextTable::Cell cell;
        std::size_t kind;
    };

    std::vector<std::string> words() const
    {
        std::vector<std::string> lines;
        for (const Entry& entry : cells_) lines.push_back(std::get<std::string>(entry.cell));
        return lines;
    }

    std::vector<std::string> numbers() const
    {
        std::vector<std::string> lines;
        std::size_t tail = 0;
        for (const Entry& entry : cells_) {
            lines.push_back(text(entry));
            tail = std::max(tail, tail_width(lines.back(), mark_));
        }
        for (std::string& line : lines)
            if (!line.empty()) line.append(tail - tail_width(line, mark_), ' ');
        return lines;
    }

    std::string text(const Entry& entry) const
    {
        if (const auto* const count = std::get_if<std::size_t>(&entry.cell)) return std::to_string(*count);
        const double* const value = std::get_if<double>(&entry.cell);
        if (value == nullptr) return std::get<std::string>(entry.cell);
        NumberFormat format = format_for(largest_.at(entry.kind));
        format.mark = mark_;
        return number(*value, format);
    }

    std::string header_;
    char mark_;
    std::vector<Entry> cells_;
    std::map<std::size_t, double> largest_; ///< of each kind
    bool has_counts_ = false;
};

} // namespace

std::size_t shown_width(std::string_view utf8)
{
    return static_cast<std::size_t>(std::count_if(
        utf8.begin(), utf8.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

void TextTable::add_row(std::vector<Cell> cells, std::size_t kind)
{
    if (cells.size() != headers_.size()) throw std::invalid_argument("TextTable: a row needs as many cells as headers");
    rows_.push_back({std::move(cells), kind});
}

void TextTable::silence_round_off(const std::vector<std::size_t>& columns)
{
    constexpr double round_off = 1.0e-12;
    double largest = 0.0;
    const auto each_number = [&](auto&& visit) {
        for (Row& row : rows_)
            for (const std::size_t column : columns)
                if (double* const value = std::get_if<double>(&row.cells[column])) visit(*value);
    };
    each_number([&](double value) { largest = std::max(largest, std::abs(value)); });
    each_number([&](double& value) {
        if (std::abs(value) < round_off * largest) value = 0.0;
    });
}

std::string TextTable::text(std::size_t indent, char decimal_mark) const
{
    std::vector<std::string> lines(rows_.size() + 1, std::string(indent, ' '));
    for (std::size_t c = 0; c < headers_.size(); ++c) {
        Column column(headers_[c], decimal_mark);
        for (const Row& row : rows_) column.add(row.cells[c], row.kind);
        const std::vector<std::string> cells = column.lines();
        for (std::size_t i = 0; i < lines.size(); ++i) lines[i] += (c == 0 ? "" : "  ") + cells[i];
    }
    std::string text;
    for (std::string& line : lines) {
        line.erase(line.find_last_not_of(' ') + 1);
        text += line + '\n';
    }
    return text;
}

} // namespace femoop
