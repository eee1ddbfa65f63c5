#include "apps/plane/outline/gathering.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "femoop/model/fault/translator.h"
#include "topology/text/line_error.h"
#include "topology/text/words.h"

namespace outline {

using femoop::translatable;
using topology::LineError;

namespace {

void require_finite(const femoop::plane::DrawnShape& shape)
{
    const auto is_possible = [](double x) { return std::abs(x) <= largest_coordinate; };
    const auto is_place = [&](const femoop::plane::DrawnPlace& place) {
        return is_possible(place.at[0]) && is_possible(place.at[1]);
    };
    if (std::ranges::all_of(shape.places, is_place) && (!shape.center || is_place(*shape.center)) &&
        (!shape.radius || is_possible(*shape.radius)) && std::ranges::all_of(shape.axes, is_possible))
        return;
    throw LineError(translatable("a curve leads farther off than {0}"), {topology::written(largest_coordinate)});
}

std::size_t pieces_of(const femoop::plane::DrawnShape& shape)
{
    using femoop::plane::DrawnKind;
    if (shape.kind == DrawnKind::Bezier) return shape.places.size() / 3;
    return shape.kind == DrawnKind::Line || shape.kind == DrawnKind::Spline ? shape.places.size() : 1;
}

} // namespace

void Gathering::add(const Curve& curve, const Affine& map)
{
    for (femoop::plane::DrawnShape& shape : shapes_of(mapped(curve, map))) {
        n_pieces_ += pieces_of(shape);
        if (n_pieces_ > most_pieces)
            throw LineError(translatable("the drawing has more than {0} pieces of curves; take out what is no outline"),
                            {std::to_string(most_pieces)});
        require_finite(shape);
        outline_.curves.push_back(std::move(shape));
    }
}

double number(std::string_view word)
{
    const std::string_view without_plus = word.starts_with('+') ? word.substr(1) : word;
    const auto value = topology::finite_number(without_plus);
    if (!value || std::abs(*value) > largest_coordinate)
        throw LineError(translatable("\"{0}\" is no number that a drawing can have"), {std::string(word)});
    return *value;
}

} // namespace outline
