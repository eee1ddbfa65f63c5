#pragma once

#include "apps/drawing/dimension.h"
#include "apps/frame/document/drawing_names.h"
#include "apps/frame/tools/tool.h"

namespace frame {

/// Draws dimension lines: a node, another, and a place that the line runs through; the side on which that lies decides
/// whether it is aligned with the two nodes, horizontal or vertical. Each node that is clicked then continues the line,
/// until Esc, a click beside the nodes, or one on a node that it has.
class DimensionTool : public Tool {
public:
    std::optional<Change> press(const Work& work, const Aim& at) override;
    std::optional<Change> move(const Work& work, const Aim& to) override;
    std::optional<ui::Message> why_not_type(const Work& work, const Eigen::Vector2d& place) const override;
    std::optional<Change> type(const Work& work, const Eigen::Vector2d& place) override;
    bool escape() override;
    bool draws() const override { return true; }
    bool snaps() const override { return !is_placing(); }
    std::optional<Eigen::Vector2d> from() const override { return from_; }
    Preview preview() const override;

private:
    bool is_placing() const { return draft_.nodes.size() == 2 && !is_drawn_; }
    void point_at(const Work& work, const Eigen::Vector2d& place);
    void add_node(const Work& work, const std::optional<femoop::NodeId>& node);
    std::optional<Change> place_line();
    std::optional<Change> go_on(const Work& work, const std::optional<femoop::NodeId>& node);

    DimensionLine draft_;                 ///< as far as it is drawn
    bool is_drawn_ = false;               ///< it is in the document: each further node continues it
    std::optional<std::string> next_;     ///< the node under the pointer
    std::optional<Eigen::Vector2d> from_; ///< where typed places count from
};

/// The offset at which a hand means a line to lie: a round one, unless nothing is to be rounded.
double offset_meant(double offset, const Aim& at);

} // namespace frame
