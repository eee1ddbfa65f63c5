#include "apps/frame/tools/typed_place.h"

#include <algorithm>

namespace frame {

using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

// Three numbers, with semicolons between them or commas.
std::optional<Vector3d> triple(std::string_view text, const DrawingHand& hand)
{
    const char mark = text.find(';') != std::string_view::npos ? ';' : ',';
    if (std::ranges::count(text, mark) != 2) return std::nullopt;
    const std::size_t first = text.find(mark), last = text.rfind(mark);
    const auto x = drawing::length_typed(text.substr(0, first), hand),
               y = drawing::length_typed(text.substr(first + 1, last - first - 1), hand),
               z = drawing::length_typed(text.substr(last + 1), hand);
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
    const bool is_length = drawing::is_one_number(text, hand.from.has_value(), hand.shown);
    const auto length = is_length ? drawing::length_typed(text, in_plane) : std::nullopt;
    if (is_length) return length ? towards_pointer_in_space(*length, hand) : std::nullopt;
    const auto place = place_typed(text, in_plane);
    if (!place) return std::nullopt;
    const bool counts_from_there = is_relative || text.find('<') != std::string_view::npos;
    return counts_from_there ? hand.plane.in_space(*place, hand.from->dot(hand.plane.normal_axis()))
                             : hand.plane.in_space(*place);
}

} // namespace frame
