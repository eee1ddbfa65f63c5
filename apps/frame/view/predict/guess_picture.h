#pragma once

#include <optional>

#include "apps/drawing/sheet/moment_overlay.h"
#include "apps/frame/document/drawing_names.h"
#include "apps/frame/predict/prediction.h"

namespace frame {

/// Draws a prediction over the moments: dashed lines over light areas, on the side where the moments of that sign are
/// drawn; with an assessment the share of each member that counts, and what is wrong in words.
///
/// Scale  alone as it was drawn; beside the true diagram the largest guess is as high as the largest moment of the
///        members that it was made on
class GuessPicture final : public MomentOverlay {
public:
    /// \param prediction  outlives the picture
    /// \param assessment  where the true moments are seen
    explicit GuessPicture(const Prediction& prediction, std::optional<Assessment> assessment = std::nullopt)
        : prediction_(prediction), assessment_(std::move(assessment))
    {}

    bool is_empty() const override { return prediction_.is_empty(); }
    void draw_alone(const Scene& scene) const override;
    void draw_beside(const Scene& scene, const SolvedCase& solved, const Diagram& moments) const override;
    PanelHead head(const Scene& scene) const override;
    std::vector<std::string> foot(const TextContext& context) const override;

private:
    double scale_beside(const Scene& scene, const SolvedCase& solved, const Diagram& moments) const;
    void draw(const Scene& scene, double scale) const;
    const MemberMark* mark_of(femoop::MemberId member) const;

    const Prediction& prediction_;
    std::optional<Assessment> assessment_;
};

} // namespace frame
