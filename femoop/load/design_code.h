#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "femoop/model/fault/translator.h"
#include "femoop/model/model.h"

namespace femoop {

/// A code whose combinations of actions are made.
enum class DesignCode : std::uint8_t { NBR8681, EN1990, ASCE7 };

/// What a code combines: where the structure may not fail, and how it is used, from the rarest to the usual.
enum class LimitState : std::uint8_t { Ultimate, Rare, Frequent, QuasiPermanent };

/// How several load cases of one kind of action act.
enum class Several : std::uint8_t {
    Together,   ///< as one action: floors, storeys
    OneAtATime, ///< as alternatives: wind from either side
};

/// A kind of action of a code, with its factors.
struct ActionKind {
    std::string_view id;    ///< "offices"
    std::string_view label; ///< English: "Imposed load, offices"
    std::string_view table; ///< where the factors stand: "table A1.1"
    bool is_permanent = false;
    double unfavourable = 1.0; ///< gamma of ultimate limit states
    double favourable = 0.0;   ///< gamma where a permanent action relieves; a variable one is left out
    double psi0 = 0.0, psi1 = 0.0, psi2 = 0.0;
    Several several = Several::Together;
    /// Kinds that are variants of one action, of which a place has one: snow below and above 1000 m. Empty: its own.
    std::string_view action = {};
};

std::span<const DesignCode> design_codes();
std::string_view id(DesignCode code);   ///< "NBR8681", as the command line has it
std::string_view name(DesignCode code); ///< with its edition: "ABNT NBR 8681:2003"
std::optional<DesignCode> design_code(std::string_view id);
std::span<const ActionKind> action_kinds(DesignCode code);
const ActionKind* find_action(DesignCode code, std::string_view id);
std::string_view id(LimitState state); ///< "ultimate", "rare", "frequent", "quasi-permanent"
std::span<const LimitState> limit_states(DesignCode code);
/// As the names of its combinations begin, English: "ULS", "SLS rare"; of ASCE 7 "LRFD", "ASD".
std::string_view short_name(DesignCode code, LimitState state);

/// A load case as an action; without a kind it is left out.
struct CaseAction {
    CaseId load_case;
    const ActionKind* kind = nullptr;
};

/// A combination with what it stands for.
struct DesignCombination {
    LimitState state = LimitState::Ultimate;
    std::vector<Combination::Term> terms; ///< in the order of the load cases
    std::optional<CaseId> leading{};      ///< the variable action that leads; of a code that names none, absent
    std::string_view clause;              ///< "expression (6.10)"
};

/// More are not made: nobody would look through them. Alternatives multiply.
inline constexpr std::size_t most_design_combinations = 20'000;
/// Whether there may be more, those counted that come twice; told at once, however many cases there are.
bool are_too_many_combinations(DesignCode code, std::span<const CaseAction> actions,
                               std::span<const LimitState> states);

/// The combinations of a code, none twice.
///
/// NBR 8681 and EN 1990, with G all permanent and Q1 the leading variable action, each in its turn:
///
///     ultimate          sum gG G + gQ (Q1 + sum psi0 Q)        gG unfavourable for all G, or favourable for all
///     rare              sum G + Q1 + sum psi1 Q (NBR 8681), psi0 (EN 1990, characteristic)
///     frequent          sum G + psi1 Q1 + sum psi2 Q
///     quasi-permanent   sum G + sum psi2 Q
///
/// A variable action that relieves is away: every choice of those that act is made. ASCE 7: the basic combinations of
/// strength design, and of allowable stress design under service loads (`Rare`), each as the standard lists it.
///
/// \pre     they are not too many
/// Assumes  loads do not depend on each other's direction; alternate spans are load cases of their own, which act
///          together here: what is loaded in part is made by hand
/// Source   [NBR8681] tables 2, 4, 5 and 6; [EN1990] expressions (6.10), (6.14b), (6.15b), (6.16b), tables A1.1 and
///          A1.2(B); [ASCE7] sections 2.3.1 and 2.4.1
std::vector<DesignCombination> design_combinations(DesignCode code, std::span<const CaseAction> actions,
                                                   std::span<const LimitState> states);

/// "1.35 G + 1.5 Q + 0.9 W", with the reader's decimal mark. \pre the cases are load cases of the model
std::string formula(const Model& model, const DesignCombination& combination, const Translator& tr);

/// "ULS 1.35 G + 1.5 Q", in Portuguese "ELU 1,35 G + 1,5 Q".
std::string combination_name(DesignCode code, const Model& model, const DesignCombination& combination,
                             const Translator& tr);

/// Behind the others, each under its name; where the model has a case of that name it stays out.
/// \returns how many came
std::size_t add_combinations(DesignCode code, Model& model, std::span<const DesignCombination> combinations,
                             const Translator& tr);

} // namespace femoop
