#include "apps/cross/document/pupil.h"

#include <algorithm>
#include <cmath>

#include "ui/text/number_format.h"
#include "ui/text/trimmed.h"

namespace cross {

namespace {

constexpr double largest_typed = 1e12;

/// Of a number without calculation: 0.01 for "0.43", 1 for "36"; nothing for a calculation.
std::optional<double> last_digit(std::string_view text)
{
    text = ui::trimmed(text);
    if (!text.empty() && (text.front() == '-' || text.front() == '+')) text.remove_prefix(1);
    if (text.find_first_not_of("0123456789.,") != std::string_view::npos) return std::nullopt;
    const auto mark = text.find_first_of(".,");
    if (mark == std::string_view::npos) return 1.0;
    return std::pow(10.0, -static_cast<double>(text.size() - mark - 1));
}

} // namespace

std::optional<femoop::cross::Entry> entry_typed(std::string_view text)
{
    constexpr std::size_t longest = 60;
    if (text.size() > longest) return std::nullopt;
    const std::optional<double> value = ui::number_typed(text);
    if (!value || std::abs(*value) > largest_typed) return std::nullopt;
    if (const auto digit = last_digit(text)) return femoop::cross::Entry{*value, *digit};
    const bool has_decimals = text.find_first_of(".,eE") != std::string_view::npos;
    return femoop::cross::Entry{*value, has_decimals ? 1e-3 * std::abs(*value) : 0.0};
}

} // namespace cross
