#include "apps/plane/outline/outline.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <unordered_map>
#include <utility>

#include "femoop/model/quantity/quantity_parser.h"

namespace outline {

using femoop::NodeId;
using femoop::Quantity;
using femoop::plane::DrawnKind;
using femoop::plane::DrawnPlace;
using femoop::plane::DrawnShape;
using femoop::plane::PlaneModel;

namespace {

std::string ending_of(const std::filesystem::path& path)
{
    std::string ending = path.extension().string();
    std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return ending;
}

template <class Visitor> void for_each_place(DrawnShape& shape, const Visitor& visit)
{
    for (DrawnPlace& place : shape.places) visit(place);
    if (shape.center) visit(*shape.center);
}

/// A length in the base units of a model.
using Scale = std::function<double(double)>;

DrawnShape scaled(DrawnShape shape, const Scale& scale)
{
    for_each_place(shape, [&](DrawnPlace& place) { place.at = {scale(place.at[0]), scale(place.at[1])}; });
    if (shape.radius) shape.radius = scale(*shape.radius);
    for (Quantity& axis : shape.axes) axis = scale(axis);
    return shape;
}

/// The points of a model by where they are: those nearer than a tolerance are one.
class Points {
public:
    Points(PlaneModel& model, double near) : model_(model), near_(near) {}

    NodeId at(const std::array<Quantity, 2>& place)
    {
        const Cell home = cell_of(place);
        for (std::int64_t i = -1; i <= 1; ++i)
            for (std::int64_t j = -1; j <= 1; ++j)
                if (const auto point = in_cell({home[0] + i, home[1] + j}, place)) return *point;
        const NodeId point(model_.points.size());
        model_.points.push_back({.id = "P" + std::to_string(point.index + 1), .at = place, .support = {}, .size = {}});
        cells_[home].push_back(point);
        return point;
    }

private:
    using Cell = std::array<std::int64_t, 2>;
    struct Hash {
        std::size_t operator()(const Cell& cell) const
        {
            constexpr auto mixing = static_cast<std::size_t>(0x9E3779B97F4A7C15ULL);
            return static_cast<std::size_t>(cell[0]) * mixing ^ static_cast<std::size_t>(cell[1]);
        }
    };

    Cell cell_of(const std::array<Quantity, 2>& place) const
    {
        return {std::llround(place[0] / near_), std::llround(place[1] / near_)};
    }
    std::optional<NodeId> in_cell(const Cell& cell, const std::array<Quantity, 2>& place) const
    {
        const auto found = cells_.find(cell);
        if (found == cells_.end()) return std::nullopt;
        const auto is_near = [&](NodeId id) {
            const auto& at = model_.points[id.index].at;
            return std::hypot(at[0] - place[0], at[1] - place[1]) <= near_;
        };
        const auto point = std::ranges::find_if(found->second, is_near);
        return point == found->second.end() ? std::nullopt : std::optional(*point);
    }

    PlaneModel& model_;
    double near_;
    std::unordered_map<Cell, std::vector<NodeId>, Hash> cells_;
};

double distance(const PlaneModel& model, const DrawnPlace& a, const DrawnPlace& b)
{
    const auto &p = model[*a.point].at, &q = model[*b.point].at;
    return std::hypot(p[0] - q[0], p[1] - q[1]);
}

bool is_one_place(const DrawnShape& shape)
{
    return std::ranges::all_of(shape.places,
                               [&](const DrawnPlace& place) { return place.point == shape.places[0].point; });
}

void join_repeats(DrawnShape& shape)
{
    shape.places.erase(std::unique(shape.places.begin(), shape.places.end()), shape.places.end());
    if (shape.is_closed && shape.places.front() == shape.places.back()) shape.places.pop_back();
    if (shape.places.size() < 3) shape.is_closed = false;
    if (shape.places.size() < 3) shape.kind = DrawnKind::Line;
}

/// The place half way along an arc about its centre. \pre its places are still its own x and y
std::array<Quantity, 2> middle_of_arc(const DrawnShape& arc)
{
    const double x = arc.center->at[0], y = arc.center->at[1];
    const double x0 = arc.places[0].at[0] - x, y0 = arc.places[0].at[1] - y;
    const double x1 = arc.places[1].at[0] - x, y1 = arc.places[1].at[1] - y;
    double turn = std::atan2(x0 * y1 - y0 * x1, x0 * x1 + y0 * y1);
    const bool is_clockwise = arc.is_clockwise.value_or(false);
    if (is_clockwise && turn > 0.0) turn -= 2.0 * std::numbers::pi;
    if (!is_clockwise && turn < 0.0) turn += 2.0 * std::numbers::pi;
    const double c = std::cos(0.5 * turn), s = std::sin(0.5 * turn);
    return {Quantity(x + c * x0 - s * y0), Quantity(y + s * x0 + c * y0)};
}

/// An arc whose ends have moved onto others' is one by three places where its radii do not agree any more.
void keep_on_circle(const PlaneModel& model, DrawnShape& arc, const std::array<Quantity, 2>& middle, Points& points)
{
    const double from = distance(model, *arc.center, arc.places[0]), to = distance(model, *arc.center, arc.places[1]);
    if (std::abs(from - to) <= 1e-9 * from) return;
    arc.places.insert(arc.places.begin() + 1, DrawnPlace{points.at(middle), {}});
    arc.center.reset();
    arc.is_clockwise.reset();
}

/// By points of the model. \returns whether anything is left of it
bool put_on_points(const PlaneModel& model, DrawnShape& shape, Points& points)
{
    const bool is_arc = shape.kind == DrawnKind::Arc;
    const std::array<Quantity, 2> middle = is_arc ? middle_of_arc(shape) : std::array<Quantity, 2>{};
    for_each_place(shape, [&](DrawnPlace& place) { place = {points.at(place.at), {}}; });
    if (!shape.places.empty() && is_one_place(shape)) return false;
    if (shape.kind == DrawnKind::Line || shape.kind == DrawnKind::Spline) join_repeats(shape);
    if (is_arc) keep_on_circle(model, shape, middle, points);
    return true;
}

} // namespace

namespace {

/// About the places that curves are drawn by, and about circles.
Eigen::AlignedBox2d box_of(const std::vector<DrawnShape>& curves)
{
    Eigen::AlignedBox2d box;
    for (const DrawnShape& shape : curves) {
        const double reach = shape.radius ? shape.radius->value() : 0.0;
        const auto extend = [&](const DrawnPlace& place) {
            const Eigen::Vector2d at(place.at[0], place.at[1]);
            box.extend(at - Eigen::Vector2d::Constant(reach));
            box.extend(at + Eigen::Vector2d::Constant(reach));
        };
        std::ranges::for_each(shape.places, extend);
        if (shape.center) extend(*shape.center);
    }
    return box;
}

/// Places nearer than this are one; far from the origin a file's digits may hold no less.
double rounding_of(const std::vector<DrawnShape>& curves)
{
    const Eigen::AlignedBox2d box = box_of(curves);
    if (box.isEmpty()) return 1.0;
    const double largest = std::max(box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff());
    return std::max({1e-6 * box.diagonal().norm(), 1e-12 * largest, 1e-300});
}

} // namespace

std::string left_out_text(const Outline& outline)
{
    std::string text;
    for (const auto& [kind, n] : outline.left_out) text += (text.empty() ? "" : ", ") + std::to_string(n) + " " + kind;
    return text;
}

bool is_outline_file(const std::filesystem::path& path)
{
    const std::string ending = ending_of(path);
    return ending == ".dxf" || ending == ".svg";
}

Outline read_outline(const std::filesystem::path& path, std::string_view text)
{
    return ending_of(path) == ".svg" ? read_svg(text) : read_dxf(text);
}

PlaneModel drawing_of(const Outline& outline, const femoop::Units& units)
{
    const femoop::Units of_file{outline.unit.value_or(units.length), units.force};
    const Scale scale = [&](double length) {
        return femoop::converted(length, femoop::dimension::length, of_file, units);
    };
    PlaneModel model;
    model.is_drawn = true;
    model.units = units;
    Points points(model, scale(rounding_of(outline.curves)));
    for (const DrawnShape& drawn : outline.curves) {
        DrawnShape shape = scaled(drawn, scale);
        if (!put_on_points(model, shape, points)) continue;
        model.curves.push_back({.id = "C" + std::to_string(model.curves.size() + 1),
                                .points = {},
                                .shape = std::move(shape),
                                .support = {},
                                .tie = {}});
    }
    return model;
}

} // namespace outline
