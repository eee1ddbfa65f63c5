#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <tuple>
#include <vector>

#include "femoop/methods/cross/distribution.h"
#include "femoop/methods/cross/turns.h"

namespace femoop::cross {

/// What a pupil fills in, in the order of the hand method.
enum class Asked : std::uint8_t {
    Stiffness,  ///< of a member end, in the form's EI over length
    Factor,     ///< of distribution
    FixedEnd,   ///< moment
    Balance,    ///< what the turned joint gives to one of its ends
    CarryOver,  ///< what arrives at the far end
    Sum,        ///< of a column
    Holding,    ///< force of a sway's prop in one sheet
    Multiplier, ///< how many times a sway's sheet is added
    Final       ///< moment of all sheets together
};

using BlankId = Id<struct CrossBlankTag>; ///< index of Form::blanks

/// One cell to fill.
struct Blank {
    Asked asked = Asked::Stiffness;
    std::size_t sheet = 0;       ///< 0: the loads with every prop in place, then the sways
    std::size_t step = 0;        ///< of Balance and CarryOver; the first turn is 0
    EndId end;                   ///< of all but Holding and Multiplier
    std::size_t sway = 0;        ///< of Holding: whose prop; of Multiplier: whose sheet
    bool may_stay_empty = false; ///< a carry-over to an end that takes none: an empty cell says the same as 0
};

/// The fixed-end moments that one forgotten load would leave.
struct WithoutLoad {
    MemberId member;
    std::vector<double> fixed_end;
};

/// A calculation sheet with its cells empty: what is asked of a structure, in the order of the hand method, and what
/// judging needs to know of it.
struct Form {
    Problem problem;
    double EI = 1.0;                      ///< the unit of stiffness: the least of the members'
    MemberId slenderest;                  ///< the first that has it
    std::vector<std::vector<Turn>> turns; ///< of every sheet
    std::vector<Blank> blanks;            ///< what a cell is worked out of stands before it
    std::vector<double> right;            ///< what belongs in each of them

    std::vector<double> plain_stiffness;              ///< of every end with no member's stiffness modified for a pin
    std::vector<std::vector<double>> plain_fixed_end; ///< likewise, of every sheet
    std::vector<WithoutLoad> without;                 ///< of members with several loads
    /// Of every sheet and prop: the force that is held without end moments, then what each end moment adds to it.
    std::vector<std::vector<double>> bare_holding;
    std::vector<std::vector<std::vector<double>>> holding_per_moment;

    const Blank& operator[](BlankId id) const { return blanks[id.index]; }
    std::size_t n_sheets() const { return turns.size(); }
    const Loading& loading(std::size_t sheet) const
    {
        return sheet == 0 ? problem.loading : problem.sways[sheet - 1].loading;
    }
    /// \param which  an end; of Holding and Multiplier the sway
    std::optional<BlankId> find(Asked asked, std::size_t sheet, std::size_t step, std::size_t which) const;

    using Place = std::tuple<Asked, std::size_t, std::size_t, std::size_t>;
    std::map<Place, BlankId> places;
};

/// How a form is made out of a structure.
struct FormOptions {
    Procedure procedure{};         ///< its order, and its tolerance: where absent, a coarse one that a hand would take
    std::size_t most_turns = 12;   ///< of one sheet
    std::size_t most_blanks = 600; ///< more than a pupil would fill
};

/// False on elastic foundations: their stiffness factors and shears are no work for a hand.
bool is_for_hand(const Problem& problem);

/// Nothing where that is false, or where there would be more cells than the options allow.
/// \throws ModelError as `problem_of`
std::optional<Form> form_of(const Model& model, CaseId load_case, FarEnds far_ends = FarEnds::Modified,
                            const FormOptions& options = {});

} // namespace femoop::cross
