#include "femoop/methods/cross/exercise/hint.h"

namespace femoop::cross {

namespace {

using enum Hint;

std::vector<Hint> of_stiffness(const Form& form, EndId id)
{
    if (!form.problem[id].member) return {SpringOfSupport};
    const std::string_view text = formula(form.problem, id);
    if (text == "0") return {LookAtFarEnd, FreeEnd};
    if (text == "3EI/L") return {LookAtFarEnd, FarEndPinned, OwnEIAndLength};
    if (text == "4EI/L") return {LookAtFarEnd, FarEndHeld, OwnEIAndLength};
    return {LookAtFarEnd, GeneralStiffness};
}

std::vector<Hint> of_fixed_end(const Form& form, const Blank& blank)
{
    const End& end = form.problem[blank.end];
    if (blank.sheet > 0) return {LookAtFarEnd, SwayMoments, SenseOfMoment};
    if (end.is_overhang) return {LockedEnds, Cantilever, SenseOfMoment};
    const bool has_moment = form.problem.loading.fixed_end[blank.end.index] != 0.0;
    if (end.is_hinged) return {PinnedEnd, has_moment ? PassOverhang : LookAtFarEnd};
    const bool is_far_pinned = end.far && form.problem[*end.far].is_hinged;
    return {LockedEnds, is_far_pinned ? FormulaPinned : FormulaBothHeld, SenseOfMoment};
}

std::vector<Hint> of_carry_over(const Form& form, const Blank& blank)
{
    if (blank.may_stay_empty) return {WhatFarEndReceives, NothingToPin};
    const double share = form.problem[*form.problem[blank.end].far].carry_over;
    return {WhatFarEndReceives, share == 0.5 ? HalfWithSameSign : TimesCarryOverFactor};
}

} // namespace

std::vector<Hint> hints_for(const Form& form, BlankId id)
{
    const Blank& blank = form[id];
    switch (blank.asked) {
    case Asked::Stiffness: return of_stiffness(form, blank.end);
    case Asked::Factor: return {ShareOfJoint, StiffnessOverSum, FactorsAddUp};
    case Asked::FixedEnd: return of_fixed_end(form, blank);
    case Asked::Balance: return {MomentsAtJoint, MustAddToNothing, TimesFactor};
    case Asked::CarryOver: return of_carry_over(form, blank);
    case Asked::Sum: return {AddColumn, LinesOfColumn, SumsBalance};
    case Asked::Holding: return {CutFree, ShearsOfMembers, ForceOnProp};
    case Asked::Multiplier: return {PropsMustBeFree, SolveForMultiplier};
    case Asked::Final: return {LoadsPlusSways};
    }
    return {};
}

} // namespace femoop::cross
