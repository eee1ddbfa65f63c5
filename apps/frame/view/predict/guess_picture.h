#pragma once

#include <functional>
#include <optional>

#include "apps/drawing/sheet/diagram_overlay.h"
#include "apps/frame/document/drawing_names.h"
#include "apps/frame/predict/prediction.h"

namespace frame {

/// How the influence line is shown that a guess is held against.
struct GuessedLine {
    bool is_stale = false;  ///< the guess is of another state of the model, or another line
    bool is_traced = false; ///< a load is drawing the line beside the guess, which is not judged yet
};

/// Draws a prediction over the moments or the influence line: dashed lines over light areas, on the side where
/// ordinates of that sign are drawn; with an assessment the share of each member that counts, and what is wrong in words.
///
/// Scale  alone as it was drawn; beside the true diagram the largest guess is as high as the largest ordinate of the
///        members that it was made on, beside a line as that of the line
class GuessPicture final : public DiagramOverlay {
public:
    /// \param prediction  outlives the picture
    /// \param assessment  where the true diagram is seen
    /// \param line        of the influence line that is looked at; nothing: moments are
    explicit GuessPicture(const Prediction& prediction, std::optional<Assessment> assessment = std::nullopt,
                          std::optional<GuessedLine> line = std::nullopt)
        : prediction_(prediction), assessment_(std::move(assessment)), line_(std::move(line))
    {}

    /// Nothing was drawn, or something else: a guess of moments is not drawn on a line, nor the other way.
    bool is_empty() const override { return prediction_.is_empty() || prediction_.is_of_line() != line_.has_value(); }
    void draw_on_line(const Scene& scene, const InfluencePicture& line, const InfluenceScale& scale) const override;
    void draw_alone(const Scene& scene) const override;
    void draw_beside(const Scene& scene, const SolvedCase& solved, const Diagram& moments) const override;
    PanelHead head(const Scene& scene) const override;
    std::vector<std::string> foot(const TextContext& context) const override;

private:
    double scale_beside(const Scene& scene, const SolvedCase& solved, const Diagram& moments) const;
    /// x along the member from its first end, y to where positive ordinates are drawn.
    using FrameOf = std::function<SymbolFrame(const MemberShape& member)>;
    void draw(const Scene& scene, const FrameOf& frame_of, double scale) const;
    void draw_moments(const Scene& scene, double scale) const;
    bool is_stale(const Scene& scene) const;
    const MemberMark* mark_of(femoop::MemberId member) const;

    const Prediction& prediction_;
    std::optional<Assessment> assessment_;
    std::optional<GuessedLine> line_;
};

} // namespace frame
