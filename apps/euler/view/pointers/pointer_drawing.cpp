#include "apps/euler/view/pointers/pointer_drawing.h"

#include "apps/euler/view/draw/arrow_head.h"
#include "apps/euler/view/shapes/entity_name.h"
#include "ui/paint/label_placement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <string_view>
#include <utility>

namespace euler {

using topology::Entity;
using topology::EntityKind;

namespace {

using std::numbers::pi;
constexpr double padding = 9.0;              // [px] of a name in its box
constexpr double pointer_head_length = 10.0; // [px]
constexpr double bow = 0.14;                 // of an arrow's length, aside, where another runs back
constexpr double least_ring = 0.36;          // of the sheet: where the neighbours stand

/// Where a half-edge's neighbour is looked for, by the link that leads to it [rad, counter-clockwise from the right].
std::optional<double> usual_angle(std::string_view label)
{
    static const std::map<std::string_view, double> angles = {
        {"next", 0.0}, {"prev", pi}, {"loop", 0.5 * pi}, {"mate", -0.5 * pi}, {"start", 0.8 * pi}, {"edge", -0.2 * pi}};
    const auto found = angles.find(label);
    return found == angles.end() ? std::nullopt : std::optional(found->second);
}

/// How many links each node is away from the first.
std::vector<std::size_t> levels(const topology::PointerGraph& graph)
{
    std::map<Entity, std::size_t> level{{graph.nodes.front(), 0}};
    for (std::size_t round = 0; round < graph.nodes.size(); ++round)
        for (const topology::Pointer& pointer : graph.pointers)
            if (level.contains(pointer.from)) level.try_emplace(pointer.to, level[pointer.from] + 1);
    std::vector<std::size_t> result;
    for (const Entity node : graph.nodes) result.push_back(level[node]);
    return result;
}

/// Where a straight line from a box's middle leaves the box.
ui::Point border(const ui::Box& box, ui::Point toward)
{
    const ui::Point middle = box.center(), d = toward - middle;
    const double x = d.x != 0.0 ? 0.5 * box.width() / std::abs(d.x) : 1e9;
    const double y = d.y != 0.0 ? 0.5 * box.height() / std::abs(d.y) : 1e9;
    return middle + std::min({x, y, 1.0}) * d;
}

} // namespace

std::string link_name(std::string_view label, const ui::Catalogue& tr)
{
    using ui::translatable;
    static constexpr std::array names{translatable("start"), translatable("loop"),      translatable("next"),
                                      translatable("prev"),  translatable("mate"),      translatable("edge"),
                                      translatable("outer"), translatable("ring"),      translatable("plus"),
                                      translatable("minus"), translatable("half-edge"), translatable("face")};
    const auto* const found = std::ranges::find(names, label);
    return found == names.end() ? std::string(label) : tr(*found);
}

PointerDrawing::PointerDrawing(const topology::PointerGraph& graph, const Subject& subject, const Look& look,
                               ui::Size sheet, const ui::Fonts& fonts)
    : theme_(look.full_theme())
{
    const std::vector<std::size_t> level = levels(graph);
    const double pad = padding * theme_.symbol_scale();
    for (std::size_t i = 0; i < graph.nodes.size(); ++i) {
        const std::string name = entity_name(subject, graph.nodes[i]);
        const ui::TextExtent extent = fonts.measure(name, theme_.type().normal, ui::Weight::Bold);
        const ui::Size size{extent.width + 2.0 * pad, extent.height() + pad};
        nodes_.push_back({graph.nodes[i], name, ui::box_at({}, size), level[i]});
    }
    place_nodes(graph, sheet);
    add_arrows(graph, look.tr);
}

/// Neighbours on an ellipse; those of neighbours on one farther out.
void PointerDrawing::place_nodes(const topology::PointerGraph& graph, ui::Size sheet)
{
    std::map<Entity, double> angles;
    for (const topology::Pointer& pointer : graph.pointers)
        if (const auto usual = usual_angle(pointer.label);
            usual && pointer.from == graph.nodes.front() && pointer.from.kind == EntityKind::HalfEdge)
            angles.try_emplace(pointer.to, *usual);
    std::size_t farthest = 1;
    std::map<std::size_t, std::size_t> n_of_level, n_placed;
    for (const Node& node : nodes_) {
        farthest = std::max(farthest, node.level);
        if (!angles.contains(node.entity)) ++n_of_level[node.level];
    }
    for (Node& node : nodes_) {
        const auto usual = angles.find(node.entity);
        const double turn = 2.0 * pi / static_cast<double>(std::max<std::size_t>(1, n_of_level[node.level]));
        const bool is_usual = usual != angles.end();
        const double angle = is_usual ? usual->second
                                      : turn * static_cast<double>(n_placed[node.level]++) +
                                            0.3 * static_cast<double>(node.level - 1);
        const double share = least_ring * static_cast<double>(node.level) / static_cast<double>(farthest);
        const ui::Point middle{sheet.width * (0.5 + share * std::cos(angle)),
                               sheet.height * (0.5 - share * std::sin(angle))};
        node.box = ui::box_at(middle - 0.5 * ui::Point{node.box.width(), node.box.height()}, node.box.size());
    }
}

void PointerDrawing::add_arrows(const topology::PointerGraph& graph, const ui::Catalogue& tr)
{
    std::map<std::pair<Entity, Entity>, std::string> labels;
    for (const topology::Pointer& pointer : graph.pointers) {
        std::string& label = labels[{pointer.from, pointer.to}];
        if (!label.empty()) label += ", ";
        label += link_name(pointer.label, tr);
    }
    const auto node = [&](Entity entity) -> const Node& {
        return *std::find_if(nodes_.begin(), nodes_.end(), [&](const Node& n) { return n.entity == entity; });
    };
    for (const auto& [ends, label] : labels) {
        const bool has_return = labels.contains({ends.second, ends.first});
        Arrow drawn = ends.first == ends.second ? around(node(ends.first))
                                                : arrow(node(ends.first), node(ends.second), has_return);
        drawn.label = label;
        drawn.is_pale = !(ends.first == graph.nodes.front());
        arrows_.push_back(std::move(drawn));
    }
}

/// Bowed to the left where another runs the other way.
PointerDrawing::Arrow PointerDrawing::arrow(const Node& from, const Node& to, bool has_return) const
{
    constexpr int n = 16;
    const ui::Point a = from.box.center(), b = to.box.center();
    const ui::Point aside = (has_return ? bow : 0.0) * ui::left_normal(b - a);
    const ui::Point control = 0.5 * (a + b) + 2.0 * aside;
    const ui::Point start = border(from.box, control), end = border(to.box, control);
    if (!has_return) return {{start, end}, {}, false};
    Arrow result;
    for (int i = 0; i <= n; ++i) {
        const double t = double{1.0} * i / n;
        result.line.push_back((1.0 - t) * (1.0 - t) * start + 2.0 * (1.0 - t) * t * control + t * t * end);
    }
    return result;
}

/// From the left side of the box back to its foot, where no neighbour of a half-edge stands.
PointerDrawing::Arrow PointerDrawing::around(const Node& node) const
{
    constexpr int n = 24;
    const double radius = 1.1 * node.box.height();
    const ui::Point middle{node.box.min.x, node.box.max.y};
    Arrow result;
    for (int i = 0; i <= n; ++i) {
        const double angle = pi * (0.5 + 1.5 * i / n);
        result.line.push_back(middle + radius * ui::Point{std::cos(angle), -std::sin(angle)});
    }
    result.line.front().y = std::max(result.line.front().y, node.box.min.y);
    return result;
}

ui::Stroke PointerDrawing::stroke(const Node& node) const
{
    ui::Stroke stroke = theme_.series(static_cast<std::size_t>(node.entity.kind)).stroke;
    stroke.width = (node.level == 0 ? 3.0 : 1.6) * theme_.symbol_scale();
    return stroke;
}

void PointerDrawing::draw(ui::Painter& painter) const
{
    for (const Arrow& arrow : arrows_) {
        const ui::Stroke line = theme_.stroke(arrow.is_pale ? ui::Role::HiddenEdge : ui::Role::Edge);
        painter.polyline(arrow.line, line);
        draw_head(painter, arrow.line, pointer_head_length * theme_.symbol_scale(), line.color);
    }
    painter.set_layer(ui::Layer::Symbols);
    for (const Node& node : nodes_) {
        const std::array corners{node.box.min, ui::Point{node.box.max.x, node.box.min.y}, node.box.max,
                                 ui::Point{node.box.min.x, node.box.max.y}};
        painter.polygon(corners, theme_.background());
        painter.polygon(corners, theme_.series(static_cast<std::size_t>(node.entity.kind)).fill);
        painter.polyline(corners, stroke(node), ui::PathEnds::Closed);
    }
    painter.set_layer(ui::Layer::Labels);
    for (const Node& node : nodes_) {
        ui::TextStyle style = theme_.text(ui::Role::Label);
        style.weight = ui::Weight::Bold;
        painter.text(node.box.center(), node.name, style);
    }
    write_labels(painter);
}

void PointerDrawing::write_labels(ui::Painter& painter) const
{
    ui::LabelPlacer placer({.room = painter.sheet()});
    for (const Node& node : nodes_) placer.obstacles().add_box(node.box);
    std::vector<ui::Label> labels;
    std::vector<ui::TextStyle> styles;
    for (const Arrow& arrow : arrows_) {
        placer.obstacles().add_polyline(arrow.line, 2.0, ui::Firmness::Soft);
        styles.push_back(theme_.text(arrow.is_pale ? ui::Role::FaintLabel : ui::Role::Label));
        styles.back().size = arrow.is_pale ? theme_.type().small : theme_.type().normal;
        const ui::Point middle = 0.5 * (arrow.line[(arrow.line.size() - 1) / 2] + arrow.line[arrow.line.size() / 2]);
        labels.push_back({.target = middle,
                          .size = ui::label_size(painter.fonts(), arrow.label, styles.back()),
                          .wishes = {middle},
                          .priority = arrow.is_pale ? 1.0 : 2.0,
                          .clearance = 2.0,
                          .reach = 24.0 * theme_.symbol_scale()});
    }
    const ui::LabelPlacement placement = placer.place(labels);
    for (std::size_t i = 0; i < labels.size(); ++i) {
        if (!placement.labels[i]) continue;
        if (placement.labels[i]->is_over_soft) styles[i].plate = theme_.background();
        ui::draw_label(painter, *placement.labels[i], arrows_[i].label, styles[i]);
    }
}

std::optional<Entity> PointerDrawing::pick(ui::Point at) const
{
    for (const Node& node : nodes_)
        if (node.box.contains(at)) return node.entity;
    return std::nullopt;
}

} // namespace euler
