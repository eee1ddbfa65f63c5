#include "apps/frame/session/design_draft.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace frame {

using femoop::ActionKind;
using femoop::DesignCode;
using femoop::LimitState;
using femoop::LoadCase;
using ui::translatable;

namespace {

/// What the name of a load case suggests, in English and in Portuguese.
struct Suggestion {
    std::string_view letters; ///< that the name begins with one of
    std::string_view kind;
};
constexpr std::array suggestions{Suggestion{"GDP", "permanent"}, Suggestion{"WV", "wind"},
                                 Suggestion{"T", "temperature"}, Suggestion{"S", "snow"},
                                 Suggestion{"QLA", "offices"},   Suggestion{"QLA", "live"}};

const ActionKind* suggested(const LoadCase& load_case, DesignCode code)
{
    if (load_case.self_weight != 0.0) return find_action(code, "permanent");
    const int letter = std::toupper(static_cast<unsigned char>(load_case.id.empty() ? ' ' : load_case.id.front()));
    for (const Suggestion& one : suggestions)
        if (one.letters.find(static_cast<char>(letter)) != std::string_view::npos)
            if (const ActionKind* const kind = find_action(code, one.kind)) return kind;
    return nullptr;
}

} // namespace

void DesignDraft::open(Session& session)
{
    if (is_open_) return;
    session.settle();
    is_open_ = true;
    const bool is_portuguese = session.view.tr.language() == ui::Language::Portuguese;
    if (is_chosen_) set_code(session, code_);
    else set_code(session, is_portuguese ? DesignCode::NBR8681 : DesignCode::EN1990);
}

void DesignDraft::choose_code(const Session& session, DesignCode code)
{
    is_chosen_ = true;
    set_code(session, code);
}

void DesignDraft::set_code(const Session& session, DesignCode code)
{
    code_ = code;
    actions_.clear();
    const std::vector<LoadCase>& cases = session.model().load_cases;
    for (std::size_t i = 0; i < cases.size(); ++i) actions_.push_back({femoop::CaseId(i), suggested(cases[i], code)});
    combine();
}

void DesignDraft::set_action(std::size_t load_case, const ActionKind* kind)
{
    actions_[load_case].kind = kind;
    combine();
}

void DesignDraft::set(LimitState state, bool is_on)
{
    has_[static_cast<std::size_t>(state)] = is_on;
    combine();
}

void DesignDraft::combine()
{
    std::vector<LimitState> states;
    for (const LimitState state : limit_states(code_))
        if (has(state)) states.push_back(state);
    combinations_.clear();
    has_too_many_ = are_too_many_combinations(code_, actions_, states);
    if (!has_too_many_) combinations_ = design_combinations(code_, actions_, states);
}

void DesignDraft::accept(Session& session)
{
    is_open_ = false;
    session.change(
        {{translatable("Combinations of {code}"), {{"code", std::string(name(code_))}}},
         [&](Document& document) { add_combinations(code_, document.model, combinations(), session.view.tr); }});
}

std::optional<std::string> DesignDraft::run_command(Session& session, std::string_view verb, std::string_view argument)
{
    if (!is_open_) return "no combinations are being made; begin with case.code";
    if (verb == "code") {
        const auto code = femoop::design_code(argument);
        if (!code) return "no code \"" + std::string(argument) + "\"";
        choose_code(session, *code);
    } else if (verb == "action") {
        return set_named_action(session, argument);
    } else if (verb == "state") {
        return toggle_state(argument);
    } else if (verb == "accept") {
        accept(session);
    } else if (verb == "cancel") {
        cancel();
    } else {
        return "cannot \"" + std::string(verb) + "\" it; known are code, action, state, accept, cancel";
    }
    return std::nullopt;
}

std::optional<std::string> DesignDraft::set_named_action(const Session& session, std::string_view argument)
{
    const std::size_t equals = std::min(argument.rfind('='), argument.size());
    const auto load_case = session.model().find_case(argument.substr(0, equals));
    if (!load_case || load_case->index >= actions_.size())
        return "no load case \"" + std::string(argument.substr(0, equals)) + "\"";
    const std::string_view kind = argument.substr(std::min(equals + 1, argument.size()));
    if (!kind.empty() && find_action(code_, kind) == nullptr) return "no action \"" + std::string(kind) + "\"";
    set_action(load_case->index, find_action(code_, kind));
    return std::nullopt;
}

std::optional<std::string> DesignDraft::toggle_state(std::string_view argument)
{
    for (const LimitState state : limit_states(code_))
        if (id(state) == argument) {
            set(state, !has(state));
            return std::nullopt;
        }
    return "no limit state \"" + std::string(argument) + "\"";
}

} // namespace frame
