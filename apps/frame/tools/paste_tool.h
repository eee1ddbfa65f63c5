#pragma once

#include <memory>

#include "apps/frame/document/clipping.h"
#include "apps/frame/tools/tool.h"

namespace frame {

/// Carries what was copied, shown as it will be joined to what it meets, and puts it where the hand clicks, or where a
/// place is typed; `@3,2` counts from where it was copied. Then it is done.
class PasteTool : public Tool {
public:
    PasteTool(std::shared_ptr<const Clipping> clipping, const femoop::Units& units);

    std::optional<Change> press(const Work& work, const Aim& at) override;
    std::optional<Change> move(const Work& work, const Aim& to) override;
    std::optional<Change> type(const Work& work, const Eigen::Vector2d& place) override;
    std::optional<Change> type_in_space(const Work& work, const Eigen::Vector3d& place) override;
    bool draws() const override { return true; }
    bool is_done() const override { return is_done_; }
    std::optional<Eigen::Vector2d> from() const override { return Eigen::Vector2d(grip_.head<2>()); }
    std::optional<Eigen::Vector3d> from_in_space() const override { return grip_; }
    Preview preview() const override;

private:
    /// Where the hand holds it, and whether it is cut there.
    struct Hold {
        Eigen::Vector3d place;
        femoop::Crossings crossings;
        friend bool operator==(const Hold&, const Hold&) = default;
    };
    Change put(const Work& work, const Hold& hold) const;
    void foresee(const Work& work, const Hold& hold);

    std::shared_ptr<const Clipping> clipping_;
    Eigen::Vector3d grip_;
    std::optional<Hold> foreseen_for_;
    std::vector<Preview::Carried> foreseen_;
    bool is_done_ = false;
};

} // namespace frame
