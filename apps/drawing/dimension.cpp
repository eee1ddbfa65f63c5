#include "apps/drawing/dimension.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace drawing {

using Eigen::Vector2d;
using femoop::Model;

namespace {

constexpr double same = 1e-9; // of two lengths: nearer than that they are one

std::optional<std::vector<Vector2d>> places_of(const Model& model, const DimensionLine& dimension)
{
    std::vector<Vector2d> places;
    for (const std::string& name : dimension.nodes) {
        const auto node = model.find_node(name);
        if (!node) return std::nullopt;
        places.emplace_back(model[*node].at[0], model[*node].at[1]);
    }
    return places.size() < 2 ? std::nullopt : std::optional(std::move(places));
}

std::optional<Vector2d> along_of(DimensionDirection direction, const std::vector<Vector2d>& places)
{
    if (direction == DimensionDirection::Horizontal) return Vector2d::UnitX();
    if (direction == DimensionDirection::Vertical) return Vector2d::UnitY();
    const Vector2d chord = places[1] - places[0];
    if (!(chord.norm() > 0.0)) return std::nullopt;
    return chord.normalized();
}

Vector2d left_of(const Vector2d& along) { return {-along.y(), along.x()}; }

} // namespace

std::optional<DimensionLayout> layout_of(const Model& model, const DimensionLine& dimension)
{
    const auto places = places_of(model, dimension);
    const auto along = places ? along_of(dimension.direction, *places) : std::nullopt;
    if (!along) return std::nullopt;
    DimensionLayout line{.along = *along, .marks = {}};
    const double across = places->front().dot(line.left()) + dimension.offset;
    for (const Vector2d& node : *places) {
        const double level = node.dot(line.along);
        line.marks.push_back({node, level * line.along + across * line.left(), level});
    }
    std::ranges::stable_sort(line.marks, {}, &DimensionLayout::Mark::level);
    return line;
}

std::optional<double> offset_through(const Model& model, const DimensionLine& dimension, const Vector2d& place)
{
    const auto places = places_of(model, dimension);
    const auto along = places ? along_of(dimension.direction, *places) : std::nullopt;
    if (!along) return std::nullopt;
    return (place - places->front()).dot(left_of(*along));
}

DimensionDirection direction_meant(const Model& model, const DimensionLine& between, const Vector2d& place)
{
    const auto places = places_of(model, between);
    if (!places) return DimensionDirection::Aligned;
    const Vector2d chord = places->at(1) - places->at(0);
    const double level = same * chord.norm();
    if (std::abs(chord.y()) <= level) return DimensionDirection::Horizontal;
    if (std::abs(chord.x()) <= level) return DimensionDirection::Vertical;
    const Vector2d arm = place - 0.5 * (places->at(0) + places->at(1));
    const double aligned = std::abs(arm.dot(left_of(chord.normalized())));
    if (aligned >= std::max(std::abs(arm.x()), std::abs(arm.y()))) return DimensionDirection::Aligned;
    return std::abs(arm.y()) >= std::abs(arm.x()) ? DimensionDirection::Horizontal : DimensionDirection::Vertical;
}

DimensionLine placed(const DimensionLine& dimension, const Model& before, const femoop::Placement& placement)
{
    const auto places = places_of(before, dimension);
    const auto along = places ? along_of(dimension.direction, *places) : std::nullopt;
    if (!along) return dimension;
    const Eigen::Matrix2d turn = placement.linear().topLeftCorner<2, 2>();
    const Vector2d turned_along = turn * *along, turned_offset = turn * (dimension.offset * left_of(*along));
    const auto is_along = [&](const Vector2d& axis) {
        return std::abs(turned_along.dot(left_of(axis))) <= same * turned_along.norm();
    };
    DimensionLine result = dimension;
    if (dimension.direction == DimensionDirection::Aligned) {
        result.offset = turned_offset.dot(left_of(turned_along.normalized()));
        return result;
    }
    using enum DimensionDirection;
    for (const auto& [axis, direction] :
         {std::pair(Vector2d(1.0, 0.0), Horizontal), std::pair(Vector2d(0.0, 1.0), Vertical)}) {
        if (!is_along(axis)) continue;
        result.direction = direction;
        result.offset = turned_offset.dot(left_of(axis));
    }
    return result;
}

} // namespace drawing
