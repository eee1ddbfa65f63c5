#pragma once

#include "apps/frame/tools/tool.h"

namespace frame {

/// A node at each click; one on a member cuts it.
class NodeTool : public Tool {
public:
    std::optional<Change> press(const Work& work, const Aim& at) override;
    std::optional<Change> type(const Work& work, const Eigen::Vector2d& place) override;
    std::optional<Change> type_in_space(const Work&, const Eigen::Vector3d& place) override;
    bool draws() const override { return true; }
};

} // namespace frame
