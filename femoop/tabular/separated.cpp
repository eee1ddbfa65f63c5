#include "femoop/tabular/separated.h"

#include <utility>

namespace tabular {

namespace {

/// After the apostrophes that may stand before it: does a spreadsheet calculate it?
bool is_formula(std::string_view text)
{
    constexpr std::string_view signs = "=+-@\t\r";
    const std::size_t at = text.find_first_not_of('\'');
    return at != std::string_view::npos && signs.find(text[at]) != std::string_view::npos;
}

std::string protected_words(std::string_view text) { return (is_formula(text) ? "'" : "") + std::string(text); }

std::string words_of(std::string cell)
{
    if (cell.starts_with('\'') && is_formula(cell)) cell.erase(0, 1);
    return cell;
}

/// Takes a text apart into cells and rows.
class Reader {
public:
    Reader(std::string_view text, char separator) : rest_(text), separator_(separator) {}

    TextBlock read()
    {
        while (!rest_.empty()) {
            if (rest_.front() == '"' && cell_.empty()) read_quoted();
            else read_letter();
        }
        if (!cell_.empty() || !row_.empty()) end_row();
        return std::move(block_);
    }

private:
    void read_quoted()
    {
        const std::size_t end = closing_quote();
        if (end == std::string_view::npos) { // a lone quotation mark is a letter
            read_letter();
            return;
        }
        for (std::size_t i = 1; i < end; ++i) {
            cell_ += rest_[i];
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

    void read_letter()
    {
        const char c = rest_.front();
        rest_.remove_prefix(1);
        if (c == separator_) end_cell();
        else if (c == '\n') end_row();
        else if (c != '\r') cell_ += c;
    }

    void end_cell() { row_.push_back(words_of(std::exchange(cell_, {}))); }
    void end_row()
    {
        end_cell();
        block_.push_back(std::exchange(row_, {}));
    }

    std::string_view rest_;
    char separator_;
    std::string cell_;
    std::vector<std::string> row_;
    TextBlock block_;
};

} // namespace

SeparatedText& SeparatedText::operator<<(const Cell& cell)
{
    if (!cell.is_number()) return *this << std::string_view(exact_text(cell));
    add(exact_text(cell));
    return *this;
}

SeparatedText& SeparatedText::operator<<(std::string_view words)
{
    add(protected_words(words));
    return *this;
}

SeparatedText& SeparatedText::operator<<(double number)
{
    add(shortest(number));
    return *this;
}

void SeparatedText::add(std::string_view cell)
{
    if (!std::exchange(is_row_begin_, false)) text_ += separators_.cell;
    const bool is_plain = cell.find_first_of("\"\r\n") == std::string_view::npos &&
                          cell.find(separators_.cell) == std::string_view::npos;
    if (is_plain) {
        text_ += cell;
        return;
    }
    text_ += '"';
    for (const char c : cell) text_.append(c == '"' ? 2 : 1, c);
    text_ += '"';
}

void SeparatedText::end_row()
{
    text_ += separators_.line_end;
    is_row_begin_ = true;
}

std::string separated(const Table& table, Separators separators)
{
    SeparatedText text(separators);
    for (const Column& column : table.columns) text << column.label();
    text.end_row();
    for (const Row& row : table.rows) {
        for (const Cell& cell : row.cells) text << cell;
        text.end_row();
    }
    return text.take();
}

TextBlock read_separated(std::string_view text, char separator) { return Reader(text, separator).read(); }

} // namespace tabular
