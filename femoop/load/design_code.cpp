#include "femoop/load/design_code.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <set>
#include <utility>

#include "femoop/model/quantity/number_text.h"

namespace femoop {

namespace {

constexpr ActionKind permanent(std::string_view id, std::string_view label, std::string_view table, double unfavourable,
                               double favourable)
{
    return {.id = id,
            .label = label,
            .table = table,
            .is_permanent = true,
            .unfavourable = unfavourable,
            .favourable = favourable};
}

struct Psi {
    double psi0, psi1, psi2;
};

constexpr ActionKind variable(std::string_view id, std::string_view label, std::string_view table, double gamma,
                              Psi psi, Several several = Several::Together, std::string_view action = {})
{
    return {.id = id,
            .label = label,
            .table = table,
            .unfavourable = gamma,
            .psi0 = psi.psi0,
            .psi1 = psi.psi1,
            .psi2 = psi.psi2,
            .several = several,
            .action = action};
}

// Building of type 2 (imposed loads up to 5 kN/m^2): permanent actions grouped 1.4, variable ones grouped 1.4. Of
// variable actions taken one by one (table 4) the wind has 1.4 and temperature 1.2.
constexpr std::array nbr_actions{
    permanent("permanent", "Permanent, grouped", "table 2", 1.4, 1.0),
    variable("live", "Imposed load, no fixed equipment or crowds", "tables 5, 6", 1.4, {0.5, 0.4, 0.3}),
    variable("crowded", "Imposed load, fixed equipment or crowds", "tables 5, 6", 1.4, {0.7, 0.6, 0.4}),
    variable("storage", "Libraries, archives, workshops, garages", "tables 5, 6", 1.4, {0.8, 0.7, 0.6}),
    variable("wind", "Wind", "tables 4, 6", 1.4, {0.6, 0.3, 0.0}, Several::OneAtATime),
    variable("temperature", "Temperature", "tables 4, 6", 1.2, {0.6, 0.5, 0.3}, Several::OneAtATime),
};

constexpr std::string_view a1 = "tables A1.1, A1.2(B)";
constexpr std::array en_actions{
    permanent("permanent", "Permanent", "table A1.2(B)", 1.35, 1.0),
    variable("domestic", "Imposed load A, domestic", a1, 1.5, {0.7, 0.5, 0.3}),
    variable("offices", "Imposed load B, offices", a1, 1.5, {0.7, 0.5, 0.3}),
    variable("congregation", "Imposed load C, congregation", a1, 1.5, {0.7, 0.7, 0.6}),
    variable("shopping", "Imposed load D, shopping", a1, 1.5, {0.7, 0.7, 0.6}),
    variable("storage", "Imposed load E, storage", a1, 1.5, {1.0, 0.9, 0.8}),
    variable("light-traffic", "Traffic F, up to 30 kN", a1, 1.5, {0.7, 0.7, 0.6}),
    variable("heavy-traffic", "Traffic G, 30 to 160 kN", a1, 1.5, {0.7, 0.5, 0.3}),
    variable("roof", "Imposed load H, roof", a1, 1.5, {0.0, 0.0, 0.0}),
    variable("snow", "Snow, up to 1000 m", a1, 1.5, {0.5, 0.2, 0.0}, Several::OneAtATime, "snow"),
    variable("snow-high", "Snow, above 1000 m", a1, 1.5, {0.7, 0.5, 0.2}, Several::OneAtATime, "snow"),
    variable("wind", "Wind", a1, 1.5, {0.6, 0.2, 0.0}, Several::OneAtATime),
    variable("temperature", "Temperature", a1, 1.5, {0.6, 0.5, 0.0}, Several::OneAtATime),
};

// The factors of ASCE 7 belong to its combinations, below.
constexpr std::string_view s2 = "sections 2.3.1, 2.4.1";
constexpr std::array asce_actions{
    permanent("permanent", "Dead load D", s2, 1.4, 0.9),
    variable("live", "Live load L", s2, 1.6, {}),
    variable("roof", "Roof live load Lr", s2, 1.6, {}),
    variable("snow", "Snow load S", s2, 1.6, {}, Several::OneAtATime),
    variable("wind", "Wind load W", s2, 1.0, {}, Several::OneAtATime),
};

struct Code {
    std::string_view id, name;
    std::span<const ActionKind> actions;
};
constexpr std::array codes{DesignCode::NBR8681, DesignCode::EN1990, DesignCode::ASCE7};
const std::array<Code, codes.size()> descriptions{Code{"NBR8681", "ABNT NBR 8681:2003", nbr_actions},
                                                  Code{"EN1990", "EN 1990:2002 + A1:2005", en_actions},
                                                  Code{"ASCE7", "ASCE/SEI 7-16", asce_actions}};
const Code& describe(DesignCode code) { return descriptions[static_cast<std::size_t>(code)]; }

constexpr std::array all_states{LimitState::Ultimate, LimitState::Rare, LimitState::Frequent,
                                LimitState::QuasiPermanent};
constexpr std::array<std::string_view, all_states.size()> state_ids{"ultimate", "rare", "frequent", "quasi-permanent"};

constexpr std::array<std::string_view, all_states.size()> short_names{"ULS", "SLS rare", "SLS frequent",
                                                                      "SLS quasi-permanent"};

using Cases = std::vector<CaseId>;

/// Load cases that act as one: all of a kind, or one of its alternatives.
struct Action {
    const ActionKind* kind = nullptr;
    Cases cases;
};

using Choice = std::vector<Action>; ///< variable actions that act together

/// The actions of one kind, each alone: one that has all its cases, or one for each.
std::vector<Choice> alternatives(const ActionKind& kind, std::span<const CaseAction> cases)
{
    std::vector<Choice> all;
    for (const CaseAction& one : cases) {
        if (one.kind != &kind) continue;
        if (all.empty() || kind.several == Several::OneAtATime) all.push_back({{&kind, {}}});
        all.back().front().cases.push_back(one.load_case);
    }
    return all;
}

/// Each choice with each of the options behind it.
std::vector<Choice> extended(const std::vector<Choice>& choices, const std::vector<Choice>& options)
{
    std::vector<Choice> all;
    for (const Choice& choice : choices)
        for (const Choice& option : options) {
            all.push_back(choice);
            all.back().insert(all.back().end(), option.begin(), option.end());
        }
    return all;
}

/// Of each variable action that has a load case its alternatives; those of kinds that are variants of one action are
/// one list.
std::vector<std::vector<Choice>> alternatives_of_actions(std::span<const ActionKind> kinds,
                                                         std::span<const CaseAction> cases)
{
    std::vector<std::vector<Choice>> all;
    std::vector<std::string_view> actions;
    for (const ActionKind& kind : kinds) {
        std::vector<Choice> of_kind = alternatives(kind, cases);
        if (kind.is_permanent || of_kind.empty()) continue;
        const std::string_view action = kind.action.empty() ? kind.id : kind.action;
        const auto known = std::ranges::find(actions, action);
        const auto place = static_cast<std::size_t>(known - actions.begin());
        if (known == actions.end()) {
            actions.push_back(action);
            all.emplace_back();
        }
        std::ranges::move(of_kind, std::back_inserter(all[place]));
    }
    return all;
}

/// Every choice of one alternative of each variable action.
std::vector<Choice> full_choices(std::span<const ActionKind> kinds, std::span<const CaseAction> cases)
{
    std::vector<Choice> all{{}};
    for (const std::vector<Choice>& of_action : alternatives_of_actions(kinds, cases)) all = extended(all, of_action);
    return all;
}

/// A choice with any of its actions left out: the whole first, none of them last.
std::vector<Choice> parts_of(const Choice& whole)
{
    std::vector<Choice> all{{}};
    for (const Action& one : whole) all = extended(all, {{one}, {}});
    return all;
}

class Builder {
public:
    Builder(LimitState state, std::string_view clause) : made_{.state = state, .terms = {}, .clause = clause} {}

    Builder& add(std::span<const CaseAction> cases, bool is_permanent, double factor)
    {
        for (const CaseAction& one : cases)
            if (one.kind != nullptr && one.kind->is_permanent == is_permanent) put(one.load_case, factor);
        return *this;
    }
    Builder& add(const Action& action, double factor)
    {
        for (const CaseId one : action.cases) put(one, factor);
        return *this;
    }
    Builder& lead(const Action& action)
    {
        made_.leading = action.cases.front();
        return *this;
    }
    DesignCombination done()
    {
        std::ranges::sort(made_.terms, {}, [](const Combination::Term& term) { return term.of.index; });
        return std::move(made_);
    }

private:
    void put(CaseId load_case, double factor)
    {
        // A product such as 1.4 times 0.6 has digits that no table means.
        if (factor != 0.0) made_.terms.push_back({load_case, std::round(factor * 1e9) / 1e9});
    }

    DesignCombination made_;
};

/// Puts in what has terms and is not there yet.
class Collection {
public:
    void put(DesignCombination one)
    {
        std::vector<std::pair<std::uint32_t, double>> terms;
        for (const Combination::Term& term : one.terms) terms.emplace_back(term.of.index, term.factor);
        if (!terms.empty() && known_.emplace(one.state, std::move(terms)).second) all_.push_back(std::move(one));
    }
    std::vector<DesignCombination> all() { return std::move(all_); }

private:
    std::vector<DesignCombination> all_;
    std::set<std::pair<LimitState, std::vector<std::pair<std::uint32_t, double>>>> known_;
};

/// On a roof the imposed load acts neither with snow nor with wind.
///
/// Source   EN 1991-1-1:2002, 3.3.2(1)
bool may_act_together(const Action& leading, Choice others)
{
    others.push_back(leading);
    const auto has = [&](auto... ids) {
        return std::ranges::any_of(others, [&](const Action& one) { return ((one.kind->id == ids) || ...); });
    };
    return !has("roof") || !has("snow", "snow-high", "wind");
}

/// Combinations with a leading variable action: NBR 8681 and EN 1990.
class LeadingActions {
public:
    LeadingActions(DesignCode code, std::span<const CaseAction> cases)
        : code_(code), cases_(cases), choices_(full_choices(action_kinds(code), cases))
    {
        for (const CaseAction& one : cases)
            if (one.kind != nullptr && one.kind->is_permanent) permanent_ = one.kind;
    }

    void make(LimitState state, Collection& collection) const
    {
        const bool is_ultimate = state == LimitState::Ultimate;
        const double most = is_ultimate && permanent_ != nullptr ? permanent_->unfavourable : 1.0;
        const double least = is_ultimate && permanent_ != nullptr ? permanent_->favourable : 1.0;
        if (is_ultimate || choices_.front().empty()) collection.put(begin(state, most).done());
        for (const Choice& choice : choices_)
            for (const double dead : {most, least}) {
                if (state == LimitState::QuasiPermanent) put_quasi_permanent(choice, dead, collection);
                else put_with_leading(state, choice, dead, collection);
            }
    }

private:
    std::string_view clause(LimitState state) const
    {
        const bool is_european = code_ == DesignCode::EN1990;
        switch (state) {
        case LimitState::Ultimate: return is_european ? "(6.10)" : "5.1.3.1";
        case LimitState::Rare: return is_european ? "(6.14b)" : "5.1.5";
        case LimitState::Frequent: return is_european ? "(6.15b)" : "5.1.5";
        case LimitState::QuasiPermanent: break;
        }
        return is_european ? "(6.16b)" : "5.1.5";
    }
    Builder begin(LimitState state, double dead) const
    {
        Builder builder(state, clause(state));
        builder.add(cases_, true, dead);
        return builder;
    }
    double leads(LimitState state, const ActionKind& kind) const
    {
        if (state == LimitState::Ultimate) return kind.unfavourable;
        return state == LimitState::Rare ? 1.0 : kind.psi1;
    }
    double accompanies(LimitState state, const ActionKind& kind) const
    {
        if (state == LimitState::Ultimate) return kind.unfavourable * kind.psi0;
        if (state == LimitState::Frequent) return kind.psi2;
        return code_ == DesignCode::EN1990 ? kind.psi0 : kind.psi1;
    }
    void put_with_leading(LimitState state, const Choice& choice, double dead, Collection& collection) const
    {
        for (const Action& leading : choice) {
            Choice others;
            std::ranges::copy_if(choice, std::back_inserter(others),
                                 [&](const Action& other) { return &other != &leading; });
            for (const Choice& part : parts_of(others)) {
                if (code_ == DesignCode::EN1990 && !may_act_together(leading, part)) continue;
                Builder builder = begin(state, dead);
                builder.lead(leading).add(leading, leads(state, *leading.kind));
                for (const Action& other : part) builder.add(other, accompanies(state, *other.kind));
                collection.put(builder.done());
            }
        }
    }
    void put_quasi_permanent(const Choice& choice, double dead, Collection& collection) const
    {
        Choice lasting;
        std::ranges::copy_if(choice, std::back_inserter(lasting),
                             [](const Action& one) { return one.kind->psi2 > 0.0; });
        for (const Choice& part : parts_of(lasting)) {
            if (part.empty() && !lasting.empty()) continue;
            Builder builder = begin(LimitState::QuasiPermanent, dead);
            for (const Action& one : part) builder.add(one, one.kind->psi2);
            collection.put(builder.done());
        }
    }

    DesignCode code_;
    std::span<const CaseAction> cases_;
    std::vector<Choice> choices_;
    const ActionKind* permanent_ = nullptr;
};

/// A basic combination of ASCE 7: of Lr and S one at a time. Without its principal action it says nothing of its own.
struct BasicCombination {
    LimitState state;
    std::string_view clause;
    std::string_view principal; ///< "roof": Lr or S
    double D, L, roof, W;
};
constexpr std::array basic_combinations{
    BasicCombination{LimitState::Ultimate, "2.3.1 (1)", "", 1.4, 0.0, 0.0, 0.0},
    BasicCombination{LimitState::Ultimate, "2.3.1 (2)", "live", 1.2, 1.6, 0.5, 0.0},
    BasicCombination{LimitState::Ultimate, "2.3.1 (3)", "roof", 1.2, 1.0, 1.6, 0.0},
    BasicCombination{LimitState::Ultimate, "2.3.1 (3)", "roof", 1.2, 0.0, 1.6, 0.5},
    BasicCombination{LimitState::Ultimate, "2.3.1 (4)", "wind", 1.2, 1.0, 0.5, 1.0},
    BasicCombination{LimitState::Ultimate, "2.3.1 (5)", "wind", 0.9, 0.0, 0.0, 1.0},
    BasicCombination{LimitState::Rare, "2.4.1 (1)", "", 1.0, 0.0, 0.0, 0.0},
    BasicCombination{LimitState::Rare, "2.4.1 (2)", "live", 1.0, 1.0, 0.0, 0.0},
    BasicCombination{LimitState::Rare, "2.4.1 (3)", "roof", 1.0, 0.0, 1.0, 0.0},
    BasicCombination{LimitState::Rare, "2.4.1 (4)", "roof", 1.0, 0.75, 0.75, 0.0},
    BasicCombination{LimitState::Rare, "2.4.1 (5)", "wind", 1.0, 0.0, 0.0, 0.6},
    BasicCombination{LimitState::Rare, "2.4.1 (6)", "wind", 1.0, 0.75, 0.75, 0.45},
    BasicCombination{LimitState::Rare, "2.4.1 (7)", "wind", 0.6, 0.0, 0.0, 0.6},
};

/// Without the action of the roof that is not chosen.
Choice under_one_roof(const Choice& choice, std::string_view left_out)
{
    Choice all;
    for (const Action& one : choice)
        if (one.kind->id != left_out) all.push_back(one);
    return all;
}

std::string_view role(std::string_view kind) { return kind == "snow" ? "roof" : kind; }

bool has_principal(const BasicCombination& basic, const Choice& actions)
{
    return basic.principal.empty() ||
           std::ranges::any_of(actions, [&](const Action& one) { return role(one.kind->id) == basic.principal; });
}

double factor_of(const BasicCombination& basic, std::string_view kind)
{
    if (kind == "live") return basic.L;
    return kind == "wind" ? basic.W : basic.roof;
}

void make_american(std::span<const CaseAction> cases, LimitState state, Collection& collection)
{
    for (const BasicCombination& basic : basic_combinations) {
        if (basic.state != state) continue;
        for (const Choice& choice : full_choices(asce_actions, cases))
            for (const std::string_view left_out : {"snow", "roof"}) {
                const Choice actions = under_one_roof(choice, left_out);
                if (!has_principal(basic, actions)) continue;
                Builder builder(state, basic.clause);
                builder.add(cases, true, basic.D);
                for (const Action& one : actions) builder.add(one, factor_of(basic, one.kind->id));
                collection.put(builder.done());
            }
    }
}

} // namespace

std::span<const DesignCode> design_codes() { return codes; }
std::string_view id(DesignCode code) { return describe(code).id; }
std::string_view name(DesignCode code) { return describe(code).name; }

std::optional<DesignCode> design_code(std::string_view wanted)
{
    const auto* const found = std::ranges::find_if(codes, [&](DesignCode code) { return id(code) == wanted; });
    return found != codes.end() ? std::optional(*found) : std::nullopt;
}

std::span<const ActionKind> action_kinds(DesignCode code) { return describe(code).actions; }

const ActionKind* find_action(DesignCode code, std::string_view wanted)
{
    const std::span<const ActionKind> kinds = action_kinds(code);
    const auto found = std::ranges::find(kinds, wanted, &ActionKind::id);
    return found != kinds.end() ? &*found : nullptr;
}

std::string_view id(LimitState state) { return state_ids[static_cast<std::size_t>(state)]; }

std::string_view short_name(DesignCode code, LimitState state)
{
    const bool is_ultimate = state == LimitState::Ultimate;
    if (code == DesignCode::ASCE7) return is_ultimate ? "LRFD" : "ASD";
    if (code == DesignCode::EN1990 && state == LimitState::Rare) return "SLS characteristic";
    return short_names[static_cast<std::size_t>(state)];
}

std::span<const LimitState> limit_states(DesignCode code)
{
    const std::span<const LimitState> all = all_states;
    return code == DesignCode::ASCE7 ? all.first(2) : all;
}

// Each choice of alternatives, with each of its actions as the leading one, with or without each of the others.
bool are_too_many_combinations(DesignCode code, std::span<const CaseAction> actions, std::span<const LimitState> states)
{
    double n_choices = 1.0, n_kinds = 0.0;
    for (const std::vector<Choice>& of_action : alternatives_of_actions(action_kinds(code), actions)) {
        n_choices *= static_cast<double>(of_action.size());
        n_kinds += 1.0;
    }
    const double most = n_choices * std::max(1.0, n_kinds) * std::exp2(n_kinds) * static_cast<double>(states.size());
    return most > static_cast<double>(most_design_combinations);
}

std::vector<DesignCombination> design_combinations(DesignCode code, std::span<const CaseAction> actions,
                                                   std::span<const LimitState> states)
{
    Collection collection;
    for (const LimitState state : states)
        if (code == DesignCode::ASCE7) make_american(actions, state, collection);
        else LeadingActions(code, actions).make(state, collection);
    return collection.all();
}

std::string formula(const Model& model, const DesignCombination& combination, const Translator& tr)
{
    std::string text;
    for (const Combination::Term& term : combination.terms) {
        if (!text.empty()) text += " + ";
        if (term.factor != 1.0) text += localized(number_text(term.factor), tr) + ' ';
        text += model.case_name(term.of);
    }
    return text;
}

std::string combination_name(DesignCode code, const Model& model, const DesignCombination& combination,
                             const Translator& tr)
{
    return tr(short_name(code, combination.state)) + ' ' + formula(model, combination, tr);
}

std::size_t add_combinations(DesignCode code, Model& model, std::span<const DesignCombination> combinations,
                             const Translator& tr)
{
    std::size_t n = 0;
    for (const DesignCombination& one : combinations) {
        const std::string name = combination_name(code, model, one, tr);
        if (model.find_case(name)) continue;
        model.combinations.push_back({name, one.terms});
        ++n;
    }
    return n;
}

} // namespace femoop
