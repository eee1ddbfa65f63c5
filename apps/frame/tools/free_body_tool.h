#pragma once

#include <optional>

#include "apps/frame/tools/tool.h"

namespace frame {

/// Lifts parts out of the structure: a click on a node or a member, with Shift more members; a line drawn across members
/// cuts them and lifts what lies to its left. The point of moments is dragged, to places of forces where it is near.
class FreeBodyTool : public Tool {
public:
    std::optional<Change> press(const Work& work, const Aim& at) override;
    std::optional<Change> move(const Work& work, const Aim& to) override;
    std::optional<Change> release(const Work& work, const Aim& at) override;
    bool escape() override;
    bool snaps() const override { return false; }
    Preview preview() const override;

private:
    static bool is_at_moment_point(const AskedBody& body, const Aim& at);
    static Eigen::Vector3d moment_point(const AskedBody& body, const Aim& at);
    static void lift(const Work& work, const Aim& at);

    std::optional<Aim> press_;
    Eigen::Vector2d now_ = Eigen::Vector2d::Zero();
    bool holds_moment_point_ = false;
    bool is_cutting_ = false;
};

} // namespace frame
