#include "apps/drawing/place_typed.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "apps/drawing/quantity_typed.h"

namespace drawing {

using Eigen::Vector2d;

namespace {

std::optional<double> number_of_place(std::string_view text, ui::Measure measure, const DrawingHand& hand)
{
    const auto typed = quantity_typed(text, measure, hand.file, hand.shown);
    const auto* const quantity = std::get_if<femoop::Quantity>(&typed);
    return quantity != nullptr ? std::optional(quantity->value()) : std::nullopt;
}

std::optional<Vector2d> two_lengths(std::string_view text, const DrawingHand& hand)
{
    const std::size_t semicolon = text.find(';');
    const std::size_t mark = semicolon != std::string_view::npos ? semicolon : text.find(',');
    if (mark == std::string_view::npos) return std::nullopt;
    if (text[mark] == ',' && text.find(',', mark + 1) != std::string_view::npos) return std::nullopt;
    const auto x = length_typed(text.substr(0, mark), hand), y = length_typed(text.substr(mark + 1), hand);
    return x && y ? std::optional(Vector2d(*x, *y)) : std::nullopt;
}

std::optional<Vector2d> length_and_angle(std::string_view text, const DrawingHand& hand)
{
    const std::size_t mark = text.find('<');
    const auto length = length_typed(text.substr(0, mark), hand);
    const auto angle = number_of_place(text.substr(mark + 1), ui::Measure::Angle, hand);
    if (!length || !angle) return std::nullopt;
    // Whole quarters are exact: 4<90 lies straight above.
    const double quarter = std::remainder(*angle, 360.0) / 90.0;
    if (quarter == std::round(quarter)) {
        const double sine = std::sin(0.5 * std::numbers::pi * quarter),
                     cosine = std::cos(0.5 * std::numbers::pi * quarter);
        return *length * Vector2d(std::round(cosine), std::round(sine));
    }
    const double radians = *angle * std::numbers::pi / 180.0;
    return *length * Vector2d(std::cos(radians), std::sin(radians));
}

std::optional<Vector2d> from_start(const std::optional<Vector2d>& arm, const DrawingHand& hand)
{
    return arm && hand.from ? std::optional<Vector2d>(*hand.from + *arm) : std::nullopt;
}

/// A length towards the pointer.
std::optional<Vector2d> towards_pointer(std::string_view text, const DrawingHand& hand)
{
    const auto length = length_typed(text, hand);
    if (!length || !hand.from) return std::nullopt;
    const Vector2d arm = hand.pointer - *hand.from;
    if (arm.norm() == 0.0) return std::nullopt;
    return *hand.from + *length * arm.normalized();
}

} // namespace

std::optional<double> length_typed(std::string_view text, const DrawingHand& hand)
{
    return number_of_place(text, ui::Measure::Length, hand);
}

bool is_one_number(std::string_view text, bool has_begun, const ui::DisplayUnits& shown)
{
    if (text.find_first_of("@<;") != std::string_view::npos) return false;
    const std::size_t comma = text.find(',');
    if (comma == std::string_view::npos) return true;
    const bool is_alone = text.find(',', comma + 1) == std::string_view::npos;
    const bool is_decimal = comma + 1 == text.size() || text[comma + 1] != ' '; // "1, 5" is a place
    return is_alone && is_decimal && has_begun && shown.format().mark == ui::DecimalMark::Comma;
}

std::optional<Vector2d> place_typed(std::string_view text, const DrawingHand& hand)
{
    if (text.starts_with('@')) return from_start(two_lengths(text.substr(1), hand), hand);
    if (text.find('<') != std::string_view::npos) return from_start(length_and_angle(text, hand), hand);
    return is_one_number(text, hand.from.has_value(), hand.shown) ? towards_pointer(text, hand)
                                                                  : two_lengths(text, hand);
}

} // namespace drawing
