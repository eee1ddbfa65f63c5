#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "apps/euler/document/palette/operator_form.h"
#include "apps/euler/document/stepper.h"
#include "topology/geometry/point.h"

namespace euler {

/// What was chosen for one argument: an entity that was pointed at, a place or direction, or a name.
using Choice = std::variant<topology::Entity, topology::Point, std::string>;

/// An operator whose arguments are chosen one by one, each checked when it is chosen.
///
/// The solid is asked first, so that every entity after it is one of that solid's. A draft fits the runner that its
/// entities were chosen from, until another step is done or undone.
class PendingOperator {
public:
    explicit PendingOperator(Verb verb) : form_(&euler::form(verb)) {}

    const OperatorForm& form() const { return *form_; }
    const std::vector<Choice>& chosen() const { return chosen_; }
    bool is_complete() const { return chosen_.size() == form_->n_arguments; }
    const Argument& next() const { return form_->arguments()[chosen_.size()]; } ///< \pre not complete

    /// The place among runner.solids() of the solid that was chosen; none before that, and none of a new one.
    std::optional<std::size_t> solid(const topology::ScriptRunner& runner) const;

    /// Why this cannot be the next argument; none if it can. \pre not complete
    std::optional<ui::Message> why_not(const topology::ScriptRunner& runner, const Choice& choice) const;
    /// Takes it as the next argument unless there is a reason against it, which is returned.
    std::optional<ui::Message> choose(const topology::ScriptRunner& runner, const Choice& choice);
    void drop_last() { chosen_.pop_back(); } ///< the last choice. \pre there is one

    /// Every entity that could be the next argument, in the order of making; none where it is typed.
    std::vector<topology::Entity> legal_picks(const topology::ScriptRunner& runner) const;
    /// What is likely chosen next: the only solid, a free name.
    std::optional<Choice> suggestion(const topology::ScriptRunner& runner) const;

    std::string line(const topology::ScriptRunner& runner) const; ///< of the script. \pre complete

private:
    std::vector<topology::Entity> picked() const;

    const OperatorForm* form_;
    std::vector<Choice> chosen_;
};

/// The lesson with the draft's step done; none if it is refused after all. \pre the draft is complete
std::optional<Stepper> preview(const Stepper& lesson, const PendingOperator& draft);

/// What was typed for the draft's next argument: names as a script has them, "v1>v2" or "%7" of a half-edge, "f1 v1" of
/// a corner, "1 0 0" of a place. It is not yet checked as why_not does. \returns the choice, or why it is none
std::variant<Choice, ui::Message> typed(const topology::ScriptRunner& runner, const PendingOperator& draft,
                                        std::string_view text);

} // namespace euler
