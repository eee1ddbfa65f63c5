#pragma once

#include "apps/frame/tools/tool.h"

namespace frame {

/// Draws members: click and click, where the line goes on from the last place until Esc or a second click there; or
/// press, drag and release, which draws one member alone.
class MemberTool : public Tool {
public:
    std::optional<Change> press(const Work&, const Aim& at) override;
    std::optional<Change> move(const Work&, const Aim& to) override;
    std::optional<Change> release(const Work&, const Aim& at) override;
    std::optional<Change> type(const Work& work, const Eigen::Vector2d& place) override;
    std::optional<Change> type_in_space(const Work&, const Eigen::Vector3d& place) override;
    bool escape() override;
    bool draws() const override { return true; }
    std::optional<Eigen::Vector2d> from() const override;
    std::optional<Eigen::Vector3d> from_in_space() const override { return start_; }
    Preview preview() const override;

private:
    bool ends_at(const Aim& at) const;
    bool is_clicked_again(const Aim& at) const;
    std::optional<Change> draw_to(const Eigen::Vector3d& place, femoop::Crossings crossings);

    std::optional<Eigen::Vector3d> start_;
    Eigen::Vector3d pointer_ = Eigen::Vector3d::Zero();
    std::optional<Aim> press_; ///< that began the line and is still held
    std::optional<Aim> click_; ///< that the line goes on from, where its place was not typed
};

} // namespace frame
