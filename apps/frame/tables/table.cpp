#include "apps/frame/tables/table.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace frame {

CellBlock whole(const Table& table)
{
    CellBlock block{std::vector<std::size_t>(table.rows.size()), 0, table.headings.size() - 1};
    std::iota(block.rows.begin(), block.rows.end(), std::size_t{0});
    return block;
}

namespace {

// Names that end in numbers are put in the order of the numbers: N2 before N10.
bool is_before(std::string_view a, std::string_view b)
{
    const auto digits_at = [](std::string_view s, std::size_t i) {
        return std::min(s.find_first_not_of("0123456789", i), s.size()) - i;
    };
    for (std::size_t i = 0, j = 0; i < a.size() && j < b.size();) {
        const std::size_t n = digits_at(a, i), m = digits_at(b, j);
        if (n > 0 && m > 0) {
            const auto order = std::pair(n, a.substr(i, n)) <=> std::pair(m, b.substr(j, m));
            if (order != 0) return order < 0;
            i += n;
            j += m;
        } else {
            if (a[i] != b[j]) return a[i] < b[j];
            ++i;
            ++j;
        }
    }
    return a.size() < b.size();
}

bool is_before(const Cell& a, const Cell& b)
{
    if (a.number && b.number) return *a.number < *b.number;
    if (a.number || b.number) return a.number.has_value();
    if (a.plain.empty() || b.plain.empty()) return !a.plain.empty() && b.plain.empty();
    return is_before(a.plain, b.plain);
}

// A text that would be taken for several is put between quotes.
std::string quoted(const std::string& text, char separator)
{
    if (text.find_first_of(std::string("\"\r\n") + separator) == std::string::npos) return text;
    std::string result = "\"";
    for (const char c : text) result += c == '"' ? std::string("\"\"") : std::string(1, c);
    return result + '"';
}

struct Signs {
    char separator;
    std::string_view line_end;
};

std::string separated(const Table& table, const CellBlock& block, const Signs& signs)
{
    std::string text;
    const auto write = [&](std::size_t column, const std::string& cell) {
        if (column > block.first_column) text += signs.separator;
        text += quoted(cell, signs.separator);
        if (column == block.last_column) text += signs.line_end;
    };
    for (std::size_t j = block.first_column; j <= block.last_column; ++j) write(j, table.headings[j].label);
    for (const std::size_t row : block.rows) {
        for (std::size_t j = block.first_column; j <= block.last_column; ++j) write(j, table.rows[row].cells[j].plain);
    }
    return text;
}

/// Takes a text apart into fields and lines.
class TsvReader {
public:
    explicit TsvReader(std::string_view text) : rest_(text) {}

    TextBlock read()
    {
        while (!rest_.empty()) {
            if (rest_.front() == '"' && field_.empty()) take_quoted();
            else take_one();
        }
        if (!field_.empty() || !line_.empty()) end_line();
        return std::move(block_);
    }

private:
    void take_quoted()
    {
        const std::size_t end = closing_quote();
        if (end == std::string_view::npos) { // a lone quote is a letter
            take_one();
            return;
        }
        for (std::size_t i = 1; i < end; ++i) {
            field_ += rest_[i];
            if (rest_[i] == '"') ++i;
        }
        rest_.remove_prefix(end + 1);
    }

    std::size_t closing_quote() const
    {
        for (std::size_t i = 1; i < rest_.size(); ++i) {
            if (rest_[i] != '"') continue;
            if (i + 1 == rest_.size() || rest_[i + 1] != '"') return i;
            ++i;
        }
        return std::string_view::npos;
    }

    void take_one()
    {
        const char c = rest_.front();
        rest_.remove_prefix(1);
        if (c == '\t') line_.push_back(std::exchange(field_, {}));
        else if (c == '\n') end_line();
        else if (c != '\r') field_ += c;
    }

    void end_line()
    {
        line_.push_back(std::exchange(field_, {}));
        block_.push_back(std::exchange(line_, {}));
    }

    std::string_view rest_;
    std::string field_;
    std::vector<std::string> line_;
    TextBlock block_;
};

} // namespace

std::vector<std::size_t> sorted_rows(const Table& table, std::size_t column)
{
    std::vector<std::size_t> rows = whole(table).rows;
    std::ranges::stable_sort(rows, [&](std::size_t a, std::size_t b) {
        return is_before(table.rows[a].cells[column], table.rows[b].cells[column]);
    });
    return rows;
}

std::string tsv(const Table& table, const CellBlock& block) { return separated(table, block, {'\t', "\n"}); }

std::string csv(const Table& table, ui::DecimalMark mark)
{
    return separated(table, whole(table), {mark == ui::DecimalMark::Comma ? ';' : ',', "\r\n"});
}

TextBlock read_tsv(std::string_view text) { return TsvReader(text).read(); }

} // namespace frame
