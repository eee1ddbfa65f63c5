#include "apps/plane/outline/svg_scanner.h"

#include <algorithm>
#include <string>

#include "apps/plane/outline/gathering.h"
#include "femoop/model/fault/translator.h"
#include "topology/text/line_error.h"

namespace outline {

using femoop::translatable;
using topology::LineError;

namespace {

constexpr std::string_view blanks = " \t\r\n,";
constexpr std::string_view digits = "0123456789";

/// The length of the number that a text begins with; 0 where it does not begin with one.
std::size_t number_length(std::string_view text)
{
    const auto skip = [&](std::size_t at, std::string_view set) {
        const std::size_t end = text.find_first_not_of(set, at);
        return end == std::string_view::npos ? text.size() : end;
    };
    const auto is = [&](std::size_t at, std::string_view set) {
        return at < text.size() && set.find(text[at]) != std::string_view::npos;
    };
    const std::size_t begin = is(0, "+-") ? 1 : 0;
    std::size_t end = skip(begin, digits);
    std::size_t n_digits = end - begin;
    if (is(end, ".")) {
        const std::size_t behind = skip(end + 1, digits);
        n_digits += behind - end - 1;
        end = behind;
    }
    if (n_digits == 0) return 0;
    const std::size_t exponent = end + (is(end + 1, "+-") ? 2 : 1);
    return is(end, "eE") && is(exponent, digits) ? skip(exponent, digits) : end;
}

} // namespace

void SvgScanner::skip_blanks() { rest_.remove_prefix(std::min(rest_.find_first_not_of(blanks), rest_.size())); }

bool SvgScanner::is_at_end()
{
    skip_blanks();
    return rest_.empty();
}

bool SvgScanner::is_at_number() { return !is_at_end() && number_length(rest_) > 0; }

char SvgScanner::letter()
{
    skip_blanks();
    const char next = rest_.front();
    rest_.remove_prefix(1);
    return next;
}

double SvgScanner::number()
{
    const std::size_t length = is_at_end() ? 0 : number_length(rest_);
    if (length == 0)
        throw LineError(translatable("a number is missing; found \"{0}\""), {std::string(rest_.substr(0, 20))});
    const double value = outline::number(rest_.substr(0, length));
    rest_.remove_prefix(length);
    return value;
}

bool SvgScanner::flag()
{
    if (is_at_end() || (rest_.front() != '0' && rest_.front() != '1'))
        throw LineError(translatable("a flag of an arc, 0 or 1, is missing; found \"{0}\""),
                        {std::string(rest_.substr(0, 20))});
    return letter() == '1';
}

std::string_view SvgScanner::word(std::string_view ends)
{
    skip_blanks();
    const std::string_view found = rest_.substr(0, rest_.find_first_of(ends));
    rest_.remove_prefix(found.size());
    return found;
}

} // namespace outline
