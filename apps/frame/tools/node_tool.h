#pragma once

#include "apps/frame/tools/tool.h"

namespace frame {

/// A node at each click; one on a member cuts it.
class NodeTool : public Tool {
public:
    std::optional<Change> press(const Snap& at) override { return type(at.place); }
    void move(const Snap&) override {}
    std::optional<Change> release(const Snap&) override { return std::nullopt; }
    std::optional<Change> type(const Eigen::Vector2d& place) override;
    bool escape() override { return false; }
};

} // namespace frame
