#include "apps/frame/tools/typed_place.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "apps/frame/document/number.h"

namespace frame {

using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

std::optional<double> number(std::string_view text, ui::Measure measure, const DrawingHand& hand)
{
    const auto typed = quantity_typed(text, measure, hand.file, hand.shown);
    const auto* const quantity = std::get_if<femoop::Quantity>(&typed);
    return quantity != nullptr ? std::optional(quantity->value()) : std::nullopt;
}

std::optional<double> length_typed(std::string_view text, const DrawingHand& hand)
{
    return number(text, ui::Measure::Length, hand);
}

std::optional<Vector2d> pair(std::string_view text, const DrawingHand& hand)
{
    const std::size_t semicolon = text.find(';');
    const std::size_t mark = semicolon != std::string_view::npos ? semicolon : text.find(',');
    if (mark == std::string_view::npos) return std::nullopt;
    if (text[mark] == ',' && text.find(',', mark + 1) != std::string_view::npos) return std::nullopt;
    const auto x = length_typed(text.substr(0, mark), hand), y = length_typed(text.substr(mark + 1), hand);
    return x && y ? std::optional(Vector2d(*x, *y)) : std::nullopt;
}

std::optional<Vector2d> polar(std::string_view text, const DrawingHand& hand)
{
    const std::size_t mark = text.find('<');
    const auto length = length_typed(text.substr(0, mark), hand);
    const auto angle = number(text.substr(mark + 1), ui::Measure::Angle, hand);
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

/// Whether the text is one number, where a comma may be the decimal mark and a line has begun.
bool is_one_number(std::string_view text, bool has_begun, const ui::DisplayUnits& shown)
{
    if (text.find_first_of("@<;") != std::string_view::npos) return false;
    const auto n_commas = std::ranges::count(text, ',');
    const bool has_decimal_comma = n_commas == 1 && has_begun && shown.format().mark == ui::DecimalMark::Comma &&
                                   text.find(' ') == std::string_view::npos;
    return n_commas == 0 || has_decimal_comma;
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

// Three numbers, with semicolons between them or commas.
std::optional<Vector3d> triple(std::string_view text, const DrawingHand& hand)
{
    const char mark = text.find(';') != std::string_view::npos ? ';' : ',';
    if (std::ranges::count(text, mark) != 2) return std::nullopt;
    const std::size_t first = text.find(mark), last = text.rfind(mark);
    const auto x = length_typed(text.substr(0, first), hand),
               y = length_typed(text.substr(first + 1, last - first - 1), hand),
               z = length_typed(text.substr(last + 1), hand);
    return x && y && z ? std::optional(Vector3d(*x, *y, *z)) : std::nullopt;
}

std::optional<Vector3d> towards_pointer_in_space(double length, const SpaceHand& hand)
{
    if (!hand.from || !hand.pointer || *hand.from == *hand.pointer) return std::nullopt;
    return *hand.from + length * (*hand.pointer - *hand.from).normalized();
}

} // namespace

std::optional<Vector3d> place_typed_in_space(std::string_view text, const SpaceHand& hand)
{
    DrawingHand in_plane{.from = std::nullopt, .file = hand.file, .shown = hand.shown};
    if (hand.from) in_plane.from = hand.plane.in_plane(*hand.from);
    const bool is_relative = text.starts_with('@');
    if (const auto numbers = triple(text.substr(is_relative ? 1 : 0), in_plane)) {
        if (!is_relative) return numbers;
        return hand.from ? std::optional<Vector3d>(*hand.from + *numbers) : std::nullopt;
    }
    const bool is_length = is_one_number(text, hand.from.has_value(), hand.shown);
    const auto length = is_length ? length_typed(text, in_plane) : std::nullopt;
    if (is_length) return length ? towards_pointer_in_space(*length, hand) : std::nullopt;
    const auto place = place_typed(text, in_plane);
    if (!place) return std::nullopt;
    const bool counts_from_there = is_relative || text.find('<') != std::string_view::npos;
    return counts_from_there ? hand.plane.in_space(*place, hand.from->dot(hand.plane.normal_axis()))
                             : hand.plane.in_space(*place);
}

std::optional<Vector2d> place_typed(std::string_view text, const DrawingHand& hand)
{
    if (text.starts_with('@')) return from_start(pair(text.substr(1), hand), hand);
    if (text.find('<') != std::string_view::npos) return from_start(polar(text, hand), hand);
    return is_one_number(text, hand.from.has_value(), hand.shown) ? towards_pointer(text, hand) : pair(text, hand);
}

} // namespace frame
