#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "apps/drawing/cut.h"
#include "apps/drawing/draw_options.h"
#include "apps/drawing/results/work_picture.h"
#include "apps/frame/document/named_effect.h"
#include "apps/frame/document/solution.h"
#include "femoop/model/model.h"

namespace frame {

/// The displacement that is looked at as virtual work. It is no part of the document: it is not saved, nor undone, and
/// belongs to the tab that it was asked in. It follows the model and the load case that is shown: its node or member is
/// known by its name.
class AskedWork {
public:
    bool is_on(const femoop::Model& model) const { return displacement(model).has_value(); }
    void clear();
    /// Grows whenever another one is asked for: its picture needs another room.
    std::size_t number() const { return number_; }

    /// Of a section along the axis that was asked for last, else across the member.
    void ask(const femoop::Model& model, const drawing::Cut& cut);
    /// Of a node along the axis that was asked for last, else upright.
    void ask(const femoop::Model& model, femoop::NodeId node);
    /// Of the same place. \pre one of `choices`
    void choose(const femoop::MovingEffect& displacement);

    /// What is asked for; nothing where its part is gone.
    std::optional<femoop::MovingEffect> displacement(const femoop::Model& model) const;
    /// Every displacement and rotation of the same place.
    std::vector<femoop::MovingEffect> choices(const femoop::Model& model) const;

    /// Null where none is looked at, or where `why_none` says why.
    /// \param generation  grows whenever the model changes \pre the solution is the model's and has results
    const drawing::WorkPicture* picture(const femoop::Model& model, const Solution& solution, std::uint64_t generation,
                                        const drawing::DrawOptions& options) const;
    /// Of the last picture that was asked for; empty where there was one.
    const std::string& why_none() const { return why_none_; }

private:
    /// What the last picture is of.
    struct Subject {
        std::uint64_t generation;
        femoop::CaseId load_case;
        ui::Language language;

        friend bool operator==(const Subject&, const Subject&) = default;
    };
    void ask(const femoop::Model& model, const femoop::MovingEffect& displacement);
    void find(const femoop::Model& model, const Solution& solution, const drawing::DrawOptions& options) const;

    std::size_t number_ = 0;
    std::optional<NamedEffect> asked_;
    std::optional<femoop::MemberComponent> last_component_;
    std::optional<femoop::Dof> last_dof_;
    mutable std::optional<Subject> subject_; ///< nothing after another was asked for
    mutable std::optional<drawing::WorkPicture> picture_;
    mutable std::string why_none_;
};

} // namespace frame
