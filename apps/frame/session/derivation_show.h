#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <tuple>
#include <vector>

#include "apps/frame/document/named_effect.h"
#include "apps/frame/session/pointed_number.h"
#include "apps/frame/session/session.h"
#include "femoop/analysis/mechanism.h"
#include "femoop/methods/derivation/derivation.h"
#include "femoop/methods/force_method/force_method.h"
#include "ui/text/message.h"

namespace frame {

/// The number that is explained: which one, and at which step of the way from the data to it; or the force method, step
/// by step. It follows the document and the load case that is shown; a step that is no more there becomes the last one.
class DerivationShow {
public:
    /// From its first step. Of no case: of that which is shown, of an envelope of the one that governs.
    /// \pre the effect is one of the session's model
    void ask(const Session& session, const PointedNumber& number);
    /// Of the effect that the influence line is of, as it is under what stands on the line; it follows that load.
    /// \pre something stands on the session's line
    void ask_standing(const Session& session);
    /// Another number of the same place, asked as this one was.
    PointedNumber beside(const femoop::Model& model, const femoop::MovingEffect& effect) const;
    /// The force method with these redundants, from its first step; none: those that the program chooses.
    /// \pre they are forces of the session's model
    void ask_force_method(const Session& session, std::span<const femoop::MovingEffect> redundants);
    void clear();

    /// Derives it anew where the session's document, or what is shown of it, is another than before.
    void follow(const Session& session);

    /// Whether it has followed the session to where it is now.
    bool is_at(const Session& session) const { return made_for_ == state_of(session); }

    /// Null where nothing is explained: `why_none` says why.
    const femoop::derivation::Derivation* derivation() const { return derivation_ ? &*derivation_ : nullptr; }
    /// What it was derived of: the session's model, that with what stands on the influence line as its one load case, or
    /// that of the results that were kept; counted in the units of the picture.
    const femoop::Model& model(const Session& session) const { return derived_of_ ? *derived_of_ : session.model(); }
    /// Its nodes and members are not those of the session's model, but have names of theirs.
    bool is_of_kept_model() const { return is_of_kept_model_; }
    /// With its states, in those units; null where a number is explained, or nothing.
    const femoop::force_method::ForceMethod* force_method() const { return force_method_.get(); }
    /// Of the session's model; none where a number is explained, or nothing.
    std::vector<femoop::MovingEffect> redundants() const;
    const std::optional<ui::Message>& why_none() const { return why_none_; }
    /// Its node, its member or its support is gone from the document that it was asked of.
    bool is_lost() const { return is_lost_; }
    ui::Message lost() const; ///< what is to be said then

    /// Nothing where none is asked for, or its part is gone.
    std::optional<femoop::MovingEffect> asked(const femoop::Model& model) const
    {
        return asked_ ? effect_in(model, *asked_) : std::nullopt;
    }
    /// Every number of the same place, in the order in which they are walked through; none where nothing is explained.
    const std::vector<femoop::MovingEffect>& choices() const { return choices_; }
    void choose_next();
    void choose_previous();

    std::size_t n_steps() const { return derivation_ ? derivation_->steps.size() : 0; }
    std::size_t step() const { return step_; }
    const femoop::derivation::Step* shown_step() const { return n_steps() > 0 ? &derivation_->steps[step_] : nullptr; }
    void go_to(std::size_t step); ///< the last one where it is beyond
    void go_on() { go_to(step_ + 1); }
    void go_back() { go_to(step_ == 0 ? 0 : step_ - 1); }

private:
    /// What stands on a line: its name, the place of its leading axle, whether it runs backwards.
    using Standing = std::tuple<std::string, std::optional<double>, bool>;
    /// What it is counted in.
    using ChosenUnits = std::tuple<std::optional<ui::UnitSystem>, ui::UnitChoices>;
    /// What it was derived from: session, generation, case, envelope, whether results are hidden, what stands on the
    /// line, units, what was kept.
    using MadeFor = std::tuple<std::uint64_t, std::uint64_t, std::size_t, bool, bool, std::optional<Standing>,
                               ChosenUnits, std::shared_ptr<const drawing::ReferenceResults>>;

    MadeFor state_of(const Session& session) const;
    void begin(const Session& session); ///< with what is asked, at its first step
    bool is_asked() const { return asked_ || redundants_; }
    std::optional<ui::Message> why_not_derive(const Session& session);
    /// Counts the model in the units of the picture, where these are others. \returns it, or the one that is given
    const femoop::Model& counted(const Session& session, const femoop::Model& model, ui::Measure result);
    /// What the session's numbers come from, counted so.
    struct Solved {
        femoop::Model model;
        femoop::Results results;
    };
    Solved solved_of(const Session& session, ui::Measure result);
    void derive_number(const Session& session);
    void derive_standing(const Session& session, const femoop::MovingEffect& effect);
    void derive_of_cases(const Session& session, const femoop::MovingEffect& effect);
    void derive_compared(const Session& session, const femoop::MovingEffect& effect);
    /// Of the model that results were kept of. \pre it has such a number
    femoop::derivation::Derivation derived_of_kept(const Session& session, const femoop::MovingEffect& effect);
    std::optional<femoop::CaseId> asked_case(const femoop::Model& model) const; ///< if one was named
    void derive_force_method(const Session& session);
    void choose(std::size_t forward);

    std::optional<NamedEffect> asked_;
    Compared compared_ = Compared::Now;                  ///< with the session's reference
    bool is_of_kept_model_ = false;                      ///< of another state, or another model, than the session's
    bool is_of_standing_ = false;                        ///< of the load on the influence line, not of a case
    std::optional<femoop::Model> derived_of_;            ///< where that is not the session's model
    double length_factor_ = 1.0;                         ///< of lengths of the session's model, to those of that one
    std::optional<std::string> asked_case_;              ///< its name
    std::optional<std::vector<NamedEffect>> redundants_; ///< of the force method; empty: the program chooses
    std::optional<NamedEffect> gone_;                    ///< the redundant whose part is lost
    std::shared_ptr<const femoop::force_method::ForceMethod> force_method_;
    std::uint64_t session_ = 0; ///< that it was asked of
    std::optional<MadeFor> made_for_;
    std::optional<femoop::derivation::Derivation> derivation_;
    std::optional<ui::Message> why_none_;
    std::vector<femoop::MovingEffect> choices_;
    bool is_lost_ = false;
    std::size_t step_ = 0;
};

/// Redundants that no force method has: what cannot be released, or how the structure moves without them.
struct RefusedRelease {
    ui::Message reason;
    femoop::Model primary{};                   ///< without them; its nodes have those of cuts too
    std::vector<femoop::Mechanism> motions{};  ///< of it; none where something else is wrong
    std::uint64_t session = 0, generation = 0; ///< that it was asked of

    /// It can be drawn: the structure moves, and is what it was.
    bool moves(const Session& of) const
    {
        return !motions.empty() && session == of.number() && generation == of.generation();
    }
};
/// Nothing where they can be released.
std::optional<RefusedRelease> refused_release(const Session& session, std::span<const femoop::MovingEffect> redundants);

/// Every number of the results at the same place as one of them: of a member's section its section forces and
/// displacements, of a whole member its extremes, of a node its reactions and displacements.
std::vector<femoop::MovingEffect> numbers_beside(const femoop::Model& model, const femoop::MovingEffect& effect);

} // namespace frame
