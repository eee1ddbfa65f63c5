#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "apps/drawing/cut.h"
#include "apps/drawing/results/influence_picture.h"
#include "femoop/methods/influence/influence_line.h"
#include "femoop/model/model.h"

namespace frame {

/// The influence line that is looked at. It is no part of the document: it is not saved, nor undone, and belongs to the
/// tab that it was asked in. Parts are known by their names, so that it goes on while the model changes.
///
/// The load is a unit force down; its path is the one that is meant where none is named (femoop `usual_path`).
class AskedLine {
public:
    bool is_on(const femoop::Model& model) const { return effect(model).has_value(); }
    void clear() { asked_.reset(); }

    /// Of a section: of the component that was asked for last, else of the bending moment, in a truss of N.
    void ask(const femoop::Model& model, const drawing::Cut& cut);
    /// Of a support its foremost reaction, upright where it can be; of a node without one its displacement down.
    void ask(const femoop::Model& model, femoop::NodeId node);
    /// Of the same place. \pre one of `choices`
    void choose(const femoop::MovingEffect& effect);

    /// What is asked for; nothing where its part is gone.
    std::optional<femoop::MovingEffect> effect(const femoop::Model& model) const;
    /// Everything that can be asked for at the same place.
    std::vector<femoop::MovingEffect> choices(const femoop::Model& model) const;

    /// The line of the model as it is; null where nothing is asked, or the model has no such line.
    /// \param generation  grows whenever the model changes
    const drawing::InfluencePicture* picture(const femoop::Model& model, std::uint64_t generation,
                                             const ui::Catalogue& tr) const;

private:
    struct Asked {
        std::string member, node; ///< one of them
        double x = 0.0;           ///< along the member
        femoop::ExpectedQuantity quantity = femoop::ExpectedQuantity::SectionForce;
        std::optional<femoop::MemberComponent> component;
        std::optional<femoop::Dof> dof;
    };
    struct Found {
        std::uint64_t generation = 0;
        ui::Language language = ui::Language::English;
        std::shared_ptr<femoop::influence::InfluenceAnalysis> analysis; ///< null: the model has no lines
        std::optional<femoop::MovingEffect> effect;
        std::shared_ptr<const drawing::InfluencePicture> picture;
    };
    void find(const femoop::Model& model, const femoop::MovingEffect& effect, const ui::Catalogue& tr) const;

    std::optional<Asked> asked_;
    femoop::MemberComponent last_component_ = femoop::MemberComponent::Mz;
    mutable Found found_;
};

} // namespace frame
