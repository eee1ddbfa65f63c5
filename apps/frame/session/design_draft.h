#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "apps/frame/session/session.h"
#include "femoop/load/design_code.h"

namespace frame {

/// The combinations of a code while it is said which load case is which action. `accept` adds them to the document as
/// ordinary ones, in one step.
class DesignDraft {
public:
    bool is_open() const { return is_open_; }
    /// With the actions that the names of the load cases suggest: G, D and self-weight are permanent, W and V wind ...
    void open(Session& session);
    void accept(Session& session);
    void cancel() { is_open_ = false; }

    femoop::DesignCode code() const { return code_; }
    /// From now on it is offered first; before, the one of the country whose language is spoken.
    void choose_code(const Session& session, femoop::DesignCode code);
    const std::vector<femoop::CaseAction>& actions() const { return actions_; } ///< of every load case
    void set_action(std::size_t load_case, const femoop::ActionKind* kind);
    bool has(femoop::LimitState state) const { return has_[static_cast<std::size_t>(state)]; }
    void set(femoop::LimitState state, bool is_on);
    /// None are made of so many alternatives.
    bool has_too_many() const { return has_too_many_; }
    const std::vector<femoop::DesignCombination>& combinations() const { return combinations_; }

    /// What a scenario says: "code EN1990", "action Q=offices", "state frequent", "accept", "cancel". \returns the
    /// complaint
    std::optional<std::string> run_command(Session& session, std::string_view verb, std::string_view argument);

private:
    void set_code(const Session& session, femoop::DesignCode code);
    void combine();
    std::optional<std::string> set_named_action(const Session& session, std::string_view argument);
    std::optional<std::string> toggle_state(std::string_view argument);

    bool is_open_ = false;
    femoop::DesignCode code_ = femoop::DesignCode::EN1990;
    bool is_chosen_ = false; ///< that code
    std::vector<femoop::CaseAction> actions_;
    std::vector<bool> has_{true, true, true, true}; ///< of each limit state
    bool has_too_many_ = false;
    std::vector<femoop::DesignCombination> combinations_;
};

} // namespace frame
