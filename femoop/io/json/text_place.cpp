#include "femoop/io/json/text_place.h"

#include <algorithm>
#include <array>

#include "femoop/io/json/json_word.h"

namespace femoop {

namespace {

bool is_continuation(char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; }
bool is_decimal_digit(char c) { return c >= '0' && c <= '9'; }
bool is_json_blank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }
bool is_word(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '.' ||
           c == '+' || c == '-' || (static_cast<unsigned char>(c) & 0x80U) != 0;
}

/// Length of the UTF-8 character that begins at `offset`, 0 if none does (RFC 3629: no surrogates, nothing overlong).
std::size_t character_length(std::string_view text, std::size_t offset)
{
    const auto byte = [&](std::size_t i) {
        return offset + i < text.size() ? static_cast<unsigned char>(text[offset + i]) : 0U;
    };
    const auto is_tail = [&](std::size_t i) { return (byte(i) & 0xC0U) == 0x80U; };
    const unsigned lead = byte(0), second = byte(1);
    if (lead < 0x80U) return 1;
    if (lead >= 0xC2U && lead <= 0xDFU) return is_tail(1) ? 2 : 0;
    if (lead >= 0xE0U && lead <= 0xEFU) {
        const bool is_overlong = lead == 0xE0U && second < 0xA0U;
        const bool is_surrogate = lead == 0xEDU && second >= 0xA0U;
        return is_tail(1) && is_tail(2) && !is_overlong && !is_surrogate ? 3 : 0;
    }
    if (lead >= 0xF0U && lead <= 0xF4U) {
        const bool is_overlong = lead == 0xF0U && second < 0x90U;
        const bool is_beyond = lead == 0xF4U && second >= 0x90U;
        return is_tail(1) && is_tail(2) && is_tail(3) && !is_overlong && !is_beyond ? 4 : 0;
    }
    return 0;
}

std::string hexadecimal(char c)
{
    static constexpr std::string_view digits = "0123456789ABCDEF";
    const auto code = static_cast<unsigned char>(c);
    return {'0', 'x', digits[code / 16U], digits[code % 16U]};
}

Fault fault_at_offset(FaultKind kind, std::string_view text, std::size_t offset, std::string found)
{
    const TextPlace place = place_of(text, offset);
    return {kind, {std::to_string(place.line), std::to_string(place.column), std::move(found)}};
}

/// What stands at `offset`, cut short, for a message.
std::string excerpt(std::string_view text, std::size_t offset)
{
    constexpr std::size_t longest = 24;
    std::size_t end = offset + 1;
    if (text[offset] == '"') end = std::min(text.find_first_of("\"\n", end), text.size() - 1) + 1;
    else if (is_word(text[offset]))
        while (end < text.size() && is_word(text[end])) ++end;
    end = std::min(end, offset + longest);
    while (end < text.size() && is_continuation(text[end])) ++end;
    return std::string(text.substr(offset, end - offset));
}

/// The quotation mark that opens the string which `offset` is in, if it is in one. Strings end with their line.
std::optional<std::size_t> opening_quote(std::string_view text, std::size_t offset)
{
    std::optional<std::size_t> quote;
    const std::size_t line_begin = offset == 0 ? 0 : text.rfind('\n', offset - 1) + 1; // npos + 1 is 0
    for (std::size_t i = line_begin; i < offset; ++i) {
        if (text[i] == '\\' && quote) ++i;
        else if (text[i] == '"') quote = quote ? std::nullopt : std::optional(i);
    }
    return quote;
}

std::string_view word_before(std::string_view text, std::size_t end)
{
    std::size_t begin = end;
    while (begin > 0 && is_word(text[begin - 1])) --begin;
    return text.substr(begin, end - begin);
}

bool is_json(std::string_view word) { return word.empty() || json_spelling(word) == word; }

/// Where the token that the parser could not use begins; `last` is its last character or the first wrong one.
std::size_t token_begin(std::string_view text, std::size_t last)
{
    if (text[last] == '"') return opening_quote(text, last).value_or(last);
    std::size_t begin = last;
    if (begin > 0 && !is_word(text[begin]) && !is_json(word_before(text, begin))) --begin; // 1. or tru before a bracket
    while (begin > 0 && is_word(text[begin]) && is_word(text[begin - 1])) --begin;
    return begin;
}

/// The last character before `offset` that is not blank, or a blank if there is none.
char before(std::string_view text, std::size_t offset)
{
    while (offset > 0 && is_json_blank(text[offset - 1])) --offset;
    return offset > 0 ? text[offset - 1] : ' ';
}

bool ends_value(char c) { return c == '"' || c == '}' || c == ']' || is_word(c); }
bool begins_value(char c) { return c == '"' || c == '{' || c == '[' || is_word(c); }

bool is_not_finite(std::string_view word)
{
    static constexpr std::array<std::string_view, 6> names{"NaN", "nan", "Infinity", "inf", "Inf", "∞"};
    if (!word.empty() && (word.front() == '-' || word.front() == '+')) word.remove_prefix(1);
    return std::find(names.begin(), names.end(), word) != names.end();
}

/// A number with a decimal comma, of which `begin` is the part behind the comma: 1,5.
std::optional<std::string> with_comma(std::string_view text, std::size_t begin)
{
    if (begin < 2 || text[begin - 1] != ',' || !is_decimal_digit(text[begin])) return std::nullopt;
    const std::string_view whole = word_before(text, begin - 1);
    if (whole.empty() || !is_json(whole)) return std::nullopt;
    return std::string(whole) + ',' + excerpt(text, begin);
}

/// A word that is none of JSON's: what it was meant to be.
Fault word_fault(std::string_view text, std::size_t begin)
{
    const std::string word = excerpt(text, begin);
    if (is_not_finite(word)) return fault_at_offset(FaultKind::JsonNotFinite, text, begin, word);
    if (auto number = with_comma(text, begin)) {
        Fault fault = fault_at_offset(FaultKind::JsonDecimalComma, text, begin - (number->size() - word.size()),
                                      *number);
        number->replace(number->find(','), 1, ".");
        fault.arguments.push_back(*number);
        return fault;
    }
    if (const auto spelling = json_spelling(word); spelling && spelling != word) {
        Fault fault = fault_at_offset(FaultKind::JsonSpelling, text, begin, word);
        fault.arguments.push_back(*spelling);
        return fault;
    }
    if (is_bare_quantity(word)) return fault_at_offset(FaultKind::JsonBareQuantity, text, begin, word);
    const bool is_numeric = is_decimal_digit(word.front()) ||
                            std::string_view("+-.").find(word.front()) != std::string::npos;
    return fault_at_offset(is_numeric ? FaultKind::JsonNoNumber : FaultKind::JsonBareText, text, begin, word);
}

/// A number, a blank and a unit: 5 kN. The place is that of the number.
std::optional<Fault> spaced_quantity(std::string_view text, std::size_t begin)
{
    if (begin < 2 || text[begin - 1] != ' ') return std::nullopt;
    const std::string number(word_before(text, begin - 1));
    const std::string words = number + ' ' + excerpt(text, begin);
    if (!is_bare_quantity(words)) return std::nullopt;
    return fault_at_offset(FaultKind::JsonBareQuantity, text, begin - 1 - number.size(), words);
}

Fault token_fault(std::string_view text, std::size_t begin, SyntaxError error)
{
    const auto fault = [&](FaultKind kind) { return fault_at_offset(kind, text, begin, excerpt(text, begin)); };
    if (error == SyntaxError::NumberOverflow) return fault(FaultKind::JsonNumberTooLarge);
    if (error == SyntaxError::AfterEnd) return fault(FaultKind::JsonAfterEnd);
    const char c = text[begin], previous = before(text, begin);
    if (c == '/' || c == '#') return fault(FaultKind::JsonComment);
    if (c == '\'') return fault(FaultKind::JsonSingleQuotes);
    if ((c == '}' || c == ']') && previous == ',') return fault(FaultKind::JsonTrailingComma);
    if (auto quantity = spaced_quantity(text, begin)) return *quantity;
    if (begins_value(c) && ends_value(previous) && begin > 0) return fault(FaultKind::JsonMissingComma);
    return is_word(c) ? word_fault(text, begin) : fault(FaultKind::JsonUnexpected);
}

} // namespace

TextPlace place_of(std::string_view text, std::size_t offset)
{
    const std::string_view passed = text.substr(0, offset);
    const std::size_t line_begin = passed.rfind('\n') + 1; // npos + 1 is 0
    TextPlace place;
    place.line += static_cast<std::size_t>(std::count(passed.begin(), passed.end(), '\n'));
    for (const char c : passed.substr(line_begin))
        if (!is_continuation(c)) ++place.column;
    return place;
}

std::optional<Fault> text_fault(std::string_view text)
{
    if (std::all_of(text.begin(), text.end(), is_json_blank)) return Fault{FaultKind::FileEmpty, {}};
    for (std::size_t i = 0; i < text.size();) {
        const auto code = static_cast<unsigned char>(text[i]);
        const std::size_t length = code < 0x80U ? 1 : character_length(text, i);
        if (length == 0) return fault_at_offset(FaultKind::FileNotUtf8, text, i, hexadecimal(text[i]));
        if ((code < 0x20U && !is_json_blank(text[i])) || code == 0x7FU)
            return fault_at_offset(FaultKind::FileWithControlCharacter, text, i, hexadecimal(text[i]));
        i += length;
    }
    return std::nullopt;
}

Fault depth_fault(std::string_view text, int deepest)
{
    int depth = 0;
    bool is_inside = false;
    std::size_t i = 0;
    for (; i < text.size(); ++i) {
        if (text[i] == '\\' && is_inside) ++i;
        else if (text[i] == '"') is_inside = !is_inside;
        else if (!is_inside && (text[i] == '{' || text[i] == '[')) ++depth;
        else if (!is_inside && (text[i] == '}' || text[i] == ']')) --depth;
        if (depth > deepest) break;
    }
    return fault_at_offset(FaultKind::JsonTooDeep, text, i, std::to_string(deepest));
}

Fault syntax_fault(std::string_view text, std::size_t position, SyntaxError error)
{
    if (position > text.size())
        return fault_at_offset(FaultKind::JsonCutOff, text, text.find_last_not_of(" \t\r\n") + 1, "");
    const std::size_t last = position == 0 ? 0 : position - 1;
    const bool is_in_text = opening_quote(text, last).has_value();
    if (is_in_text && (text[last] == '\n' || text[last] == '\r'))
        return fault_at_offset(FaultKind::JsonOpenText, text, last, "");
    if (is_in_text && text[last] == '\t')
        return fault_at_offset(FaultKind::FileWithControlCharacter, text, last, hexadecimal(text[last]));
    const std::size_t begin = token_begin(text, last);
    return token_fault(text, begin, error);
}

} // namespace femoop
