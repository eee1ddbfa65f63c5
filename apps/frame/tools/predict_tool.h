#pragma once

#include <optional>
#include <span>
#include <vector>

#include "apps/drawing/moment_side.h"
#include "apps/frame/document/drawing_names.h"
#include "apps/frame/predict/prediction.h"
#include "apps/frame/tools/settings.h"
#include "apps/frame/tools/tool.h"

namespace frame {

/// Sketches bending moments, or the influence line that is asked for: press beside a member, draw, release. The whole
/// stroke belongs to the member that it keeps nearest to, for a line of those of its path.
class PredictTool : public Tool {
public:
    explicit PredictTool(const ToolSettings& settings) : settings_(settings) {}
    std::optional<Change> press(const Work& work, const Aim& at) override;
    std::optional<Change> move(const Work& work, const Aim& to) override;
    std::optional<Change> release(const Work& work, const Aim& at) override;
    bool escape() override;
    Preview preview() const override { return {.lines = {}, .stroke = path_, .member = member_}; }

private:
    const ToolSettings& settings_;
    std::vector<Eigen::Vector2d> path_; ///< while the button is held
    Aim press_;                         ///< the last one
    bool is_drawing_ = false;           ///< the hand has gone so far since then that it is no click
    std::optional<femoop::MemberId> member_;
};

/// The members of the model, or where a line is sketched those of its path.
std::vector<femoop::MemberId> sketched_members(const Work& work);

/// The member that a stroke keeps nearest to, of those that it comes near to at all.
/// \param among  that it can belong to
std::optional<femoop::MemberId> member_beside(const femoop::Model& model, std::span<const femoop::MemberId> among,
                                              std::span<const Eigen::Vector2d> stroke);

/// The side of a member on which positive moments are drawn.
Eigen::Vector3d moment_side(const femoop::MemberGeometry& member, MomentSide side);

/// A path in the plane of the model as ordinates along a member, positive in the direction of `side`, a unit vector that
/// need not be square to it. \pre the member has a length
std::vector<StrokePoint> stroke_along(const femoop::MemberGeometry& member, const Eigen::Vector3d& side,
                                      std::span<const Eigen::Vector2d> path);

} // namespace frame
