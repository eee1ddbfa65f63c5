#pragma once

#include "apps/frame/tools/tool.h"

namespace frame {

/// A node at each click; one on a member cuts it.
class NodeTool : public Tool {
public:
    std::optional<Change> press(const Work& work, const Aim& at) override { return type(work, at.snap.place); }
    std::optional<Change> type(const Work&, const Eigen::Vector2d& place) override;
    bool draws() const override { return true; }
};

} // namespace frame
