#include "apps/frame/tools/dimension_tool.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "apps/frame/document/dimensioning.h"
#include "apps/frame/tools/snap.h"
#include "femoop/edit/member_line.h"
#include "ui/text/catalogue.h"

namespace frame {

using Eigen::Vector2d;
using femoop::Model;
using femoop::NodeId;

namespace {

std::optional<NodeId> node_at(const Model& model, const Vector2d& place)
{
    const double near = femoop::nearness_of(model);
    for (std::size_t i = 0; i < model.nodes.size(); ++i)
        if ((place_of(model, NodeId(i)) - place).norm() <= near) return NodeId(i);
    return std::nullopt;
}

/// The foot of a place on the line through the first node that has no offset.
std::optional<Vector2d> foot_of(const Model& model, const DimensionLine& line, const Vector2d& place)
{
    const auto offset = offset_through(model, line, place);
    const auto layout = layout_of(model, line);
    if (!offset || !layout) return std::nullopt;
    return place - *offset * layout->left();
}

} // namespace

double offset_meant(double offset, const Aim& at)
{
    constexpr double spacing = 8.0; // [px] of the round ones
    if (at.is_exact) return offset;
    const double step = round_grid(spacing * at.pixel);
    return step * std::round(offset / step);
}

std::optional<Change> DimensionTool::press(const Work& work, const Aim& at)
{
    if (is_drawn_) return go_on(work, at.node);
    if (is_placing()) {
        move(work, at);
        return place_line();
    }
    add_node(work, at.node);
    return std::nullopt;
}

std::optional<Change> DimensionTool::move(const Work& work, const Aim& to)
{
    next_ = to.node ? std::optional(work.document.model[*to.node].id) : std::nullopt;
    if (!is_placing()) return std::nullopt;
    point_at(work, to.pointer);
    draft_.offset = offset_meant(draft_.offset, to);
    return std::nullopt;
}

std::optional<ui::Message> DimensionTool::why_not_type(const Work& work, const Vector2d& place) const
{
    if (is_placing() || node_at(work.document.model, place)) return std::nullopt;
    return ui::translatable("no node is at that place, and a dimension line stands between nodes");
}

std::optional<Change> DimensionTool::type(const Work& work, const Vector2d& place)
{
    const Model& model = work.document.model;
    if (is_drawn_) return go_on(work, node_at(model, place));
    if (is_placing()) {
        point_at(work, place);
        return place_line();
    }
    add_node(work, node_at(model, place));
    return std::nullopt;
}

// A node that went meanwhile, as by an undo, ends what was begun.
void DimensionTool::point_at(const Work& work, const Vector2d& place)
{
    const Model& model = work.document.model;
    draft_.direction = direction_meant(model, draft_, place);
    const auto offset = offset_through(model, draft_, place);
    if (!offset) return void(escape());
    draft_.offset = *offset;
    from_ = foot_of(model, draft_, place);
}

void DimensionTool::add_node(const Work& work, const std::optional<NodeId>& node)
{
    if (!node) return;
    const std::string& name = work.document.model[*node].id;
    if (!draft_.nodes.empty() && draft_.nodes.front() == name) return;
    draft_.nodes.push_back(name);
    from_ = place_of(work.document.model, *node);
}

std::optional<Change> DimensionTool::place_line()
{
    if (draft_.nodes.size() != 2) return std::nullopt;
    is_drawn_ = true;
    return Change{ui::translatable("Draw a dimension line"),
                  [line = draft_](Document& document) { add_dimension(document, line); }};
}

std::optional<Change> DimensionTool::go_on(const Work& work, const std::optional<NodeId>& node)
{
    const auto& lines = work.document.companion.dimensions;
    const auto found = std::ranges::find(lines, draft_);
    const bool is_there = node && found != lines.end();
    const std::string name = is_there ? work.document.model[*node].id : "";
    if (!is_there || std::ranges::find(draft_.nodes, name) != draft_.nodes.end()) {
        escape();
        if (node && found == lines.end()) add_node(work, node); // it was undone: this begins another
        return std::nullopt;
    }
    draft_.nodes.push_back(name);
    from_ = place_of(work.document.model, *node);
    const DimensionPlace place{static_cast<std::size_t>(found - lines.begin())};
    return Change{ui::translatable("Continue the dimension line"),
                  [place, name](Document& document) { continue_dimension(document, place, name); }};
}

bool DimensionTool::escape()
{
    const bool had_begun = !draft_.nodes.empty();
    draft_ = {};
    is_drawn_ = false;
    from_.reset();
    return had_begun;
}

Preview DimensionTool::preview() const
{
    DimensionLine line = draft_;
    const bool is_new = next_ && std::ranges::find(line.nodes, *next_) == line.nodes.end();
    if (is_new && is_drawn_) line.nodes.push_back(*next_);
    if (line.nodes.size() < 2 || (is_drawn_ && !is_new)) return {};
    return {.lines = {}, .dimension = std::move(line)};
}

} // namespace frame
