#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "apps/drawing/draw_options.h"
#include "apps/drawing/results/free_body_picture.h"
#include "femoop/model/model.h"
#include "femoop/result/results.h"
#include "ui/paint/theme.h"

namespace frame {

/// The part of the structure that is lifted out. It is no part of the document: it is not saved, nor undone, and belongs
/// to the tab that it was asked in. Parts are known by their names, and a cut by its line, so that it goes on while the
/// model changes.
class AskedBody {
public:
    /// A line across members as they are seen from a side, which cuts all that it crosses there, near or far; what lies to
    /// the left of its direction is lifted.
    struct CutLine {
        Eigen::Vector3d from, to; ///< square to the way to the eye
        Eigen::Vector3d toward_eye = Eigen::Vector3d::UnitZ();
    };

    bool is_on(const femoop::Model& model) const { return !body(model).is_empty(); }
    void clear();
    /// Grows whenever another body is lifted.
    std::size_t number() const { return number_; }

    void lift(const femoop::Model& model, femoop::NodeId node);
    void lift(const femoop::Model& model, femoop::MemberId member, bool adds); ///< to the members that are lifted
    void lift(const femoop::Model& model, const std::vector<femoop::MemberId>& members);
    /// Where it crosses no member, or does not part the structure, nothing is lifted that was not before.
    void cut(const femoop::Model& model, const CutLine& line);
    /// The members by which the structure hangs together, where the last line crossed others; none the next time.
    std::vector<femoop::MemberId> take_across() { return std::exchange(across_, {}); }
    bool has_cut() const { return line_.has_value(); }
    void turn_cut(); ///< the other side is lifted. \pre there is one

    void put_moment_point(const Eigen::Vector3d& about);
    bool has_ritter_points() const { return picture_ && !picture_->lifted.ritter_points.empty(); }
    void to_next_ritter_point(); ///< moments are taken about it. \pre the last picture has some

    /// Null where nothing is lifted, or where the case that is shown has no results.
    /// \param generation  grows whenever the model changes
    const drawing::FreeBodyPicture* picture(const femoop::Model& model, const femoop::Results& results,
                                            std::uint64_t generation, const drawing::DrawOptions& options) const;
    /// The last one; null where there was none.
    const drawing::FreeBodyPicture* last() const { return picture_ ? &*picture_ : nullptr; }

private:
    femoop::free_body::Body body(const femoop::Model& model) const;
    Eigen::Vector3d aside(const femoop::Model& model, const femoop::free_body::Body& body, ui::ThemeName theme) const;

    std::size_t number_ = 0;
    std::string node_;
    std::vector<std::string> members_;
    std::optional<CutLine> line_;
    std::vector<femoop::MemberId> across_; ///< of a line that does not part the structure
    std::optional<Eigen::Vector3d> about_; ///< nothing: the usual one
    /// What the last picture is of.
    struct Subject {
        std::uint64_t generation;
        femoop::CaseId load_case;
        ui::Language language;
        femoop::Units units; ///< of its equations
        ui::ThemeName theme; ///< of the sheet that the body stands aside on

        friend bool operator==(const Subject&, const Subject&) = default;
    };
    mutable std::optional<Subject> subject_; ///< nothing after a change
    mutable std::optional<drawing::FreeBodyPicture> picture_;
};

} // namespace frame
