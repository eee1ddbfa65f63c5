#pragma once

#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "apps/drawing/moment_side.h"
#include "apps/frame/document/drawing_names.h"
#include "apps/frame/predict/prediction.h"
#include "apps/frame/tools/settings.h"
#include "apps/frame/tools/tool.h"

namespace frame {

/// How places under a pencil belong to the model: those of its plane, or of a model in space places of the sheet, on
/// which ordinates are drawn as they are seen.
class PencilView {
public:
    PencilView() = default; ///< of the plane
    explicit PencilView(Projection seen) : seen_(std::move(seen)) {}
    static PencilView of(const Aim& at) { return at.may_drag() ? PencilView() : PencilView(at.projection); }

    Eigen::Vector2d pointer(const Aim& at) const;
    Eigen::Vector2d place(const Eigen::Vector3d& in_space) const;
    Eigen::Vector2d direction(const Eigen::Vector3d& unit) const; ///< the image of a unit of length
    double scale() const { return seen_ ? seen_->scale() : 1.0; } ///< of lengths that are seen from the front
    bool is_flat() const { return !seen_; }

private:
    std::optional<Projection> seen_;
};

/// Sketches bending moments, or the influence line that is asked for: press beside a member, draw, release. The whole
/// stroke belongs to the member that it keeps nearest to, for a line of those of its path. In space a stroke that begins
/// beside the path is drawn; elsewhere, and with Shift, the hand turns the model.
class PredictTool : public Tool {
public:
    explicit PredictTool(const ToolSettings& settings) : settings_(settings) {}
    std::optional<Change> press(const Work& work, const Aim& at) override;
    std::optional<Change> move(const Work& work, const Aim& to) override;
    std::optional<Change> release(const Work& work, const Aim& at) override;
    bool takes_hold(const Work& work, const Aim& at) const override;
    bool escape() override;
    Preview preview() const override
    {
        return {.lines = {}, .stroke = path_, .is_stroke_on_sheet = !view_.is_flat(), .member = member_};
    }

private:
    const ToolSettings& settings_;
    PencilView view_;                   ///< of the last press
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
                                              std::span<const Eigen::Vector2d> stroke, const PencilView& view = {});

/// Some member of the path of a line is seen from where its ordinates are.
bool shows_ordinates(const femoop::Model& model, const drawing::InfluencePicture& line, const PencilView& view);

/// The side of a member on which positive moments are drawn.
Eigen::Vector3d moment_side(const femoop::MemberGeometry& member, MomentSide side);

/// The path of a pencil as ordinates along a member, positive in the direction of `side`, a unit vector that need not be
/// square to it. Nothing where the member, or the side, is seen end-on. \pre the member has a length
std::vector<StrokePoint> stroke_along(const femoop::MemberGeometry& member, const Eigen::Vector3d& side,
                                      std::span<const Eigen::Vector2d> path, const PencilView& view = {});

} // namespace frame
