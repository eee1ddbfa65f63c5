#include "apps/cross/view/pupil_words.h"

#include <cmath>

#include "ui/text/catalogue.h"

namespace cross {

namespace fc = femoop::cross;
using fc::Asked;
using ui::Message;
using ui::translatable;

namespace {

std::string_view sense_of(const Eigen::Vector2d& direction)
{
    if (std::abs(direction.x()) > 0.99)
        return direction.x() > 0.0 ? translatable("positive to the right") : translatable("positive to the left");
    if (std::abs(direction.y()) > 0.99)
        return direction.y() > 0.0 ? translatable("positive upwards") : translatable("positive downwards");
    return translatable("positive along the axis of its support");
}

std::string_view way_of(const Eigen::Vector2d& direction)
{
    if (std::abs(direction.x()) > 0.99)
        return direction.x() > 0.0 ? translatable("to the right") : translatable("to the left");
    if (std::abs(direction.y()) > 0.99)
        return direction.y() > 0.0 ? translatable("upwards") : translatable("downwards");
    return translatable("along its support");
}

Message of_fixed_end(const Worksheet& worksheet, const femoop::Model& model, const fc::Blank& blank)
{
    const std::string& end = worksheet.form.problem[blank.end].label;
    if (blank.sheet == 0) return {translatable("fixed-end moment at {end}"), {{"end", end}}};
    const fc::Sway& sway = worksheet.form.problem.sways[blank.sheet - 1];
    return {translatable("fixed-end moment at {end} where {node} moves {way}; the largest of all is taken as 100"),
            {{"end", end}, {"node", model[sway.prop].id}, {"way", Message(way_of(sway.direction))}}};
}

Message of_holding(const Worksheet& worksheet, const femoop::Model& model, const fc::Blank& blank)
{
    const fc::Sway& sway = worksheet.form.problem.sways[blank.sway];
    const Message sense = sense_of(sway.direction);
    const std::string& node = model[sway.prop].id;
    if (blank.sheet == 0)
        return {translatable("force of the prop at {node} in the sheet of the loads, {sense}"),
                {{"node", node}, {"sense", sense}}};
    const std::string& moved = model[worksheet.form.problem.sways[blank.sheet - 1].prop].id;
    return {translatable("force of the prop at {node} in the sheet of the sway at {moved}, {sense}"),
            {{"node", node}, {"moved", moved}, {"sense", sense}}};
}

Message of_turn(const Worksheet& worksheet, const femoop::Model& model, const fc::Blank& blank, std::string_view words)
{
    const fc::Turn& turn = worksheet.form.turns[blank.sheet][blank.step];
    const Message who = turn ? Message(translatable("joint {joint}"),
                                       {{"joint", model[worksheet.form.problem[*turn].node].id}})
                             : Message(translatable("all joints"));
    return {words,
            {{"n", std::to_string(blank.step + 1)}, {"who", who}, {"end", worksheet.form.problem[blank.end].label}}};
}

} // namespace

Message words_of(fc::Difficulty difficulty)
{
    switch (difficulty) {
    case fc::Difficulty::FixedEnds: return translatable("two spans, fixed ends");
    case fc::Difficulty::PinnedEnd: return translatable("two spans, pinned end");
    case fc::Difficulty::Overhang: return translatable("overhang, several EI");
    case fc::Difficulty::SeveralSpans: return translatable("three or four spans");
    case fc::Difficulty::Frame: return translatable("frame without sway");
    case fc::Difficulty::SwayFrame: return translatable("frame with sway");
    }
    return {};
}

Message question(const Worksheet& worksheet, const femoop::Model& model, fc::BlankId id)
{
    const fc::Blank& blank = worksheet.form[id];
    const std::string end = worksheet.form.problem.ends.empty() ? "" : worksheet.form.problem[blank.end].label;
    switch (blank.asked) {
    case Asked::Stiffness:
        return {translatable("stiffness of {end}, in EI of {member}"),
                {{"end", end}, {"member", model[worksheet.form.slenderest].id}}};
    case Asked::Factor: return {translatable("distribution factor of {end}"), {{"end", end}}};
    case Asked::FixedEnd: return of_fixed_end(worksheet, model, blank);
    case Asked::Balance: return of_turn(worksheet, model, blank, translatable("turn {n}, {who}: balance of {end}"));
    case Asked::CarryOver:
        return of_turn(worksheet, model, blank, translatable("turn {n}, {who}: what is carried over to {end}"));
    case Asked::Sum: return {translatable("sum of the column {end}"), {{"end", end}}};
    case Asked::Holding: return of_holding(worksheet, model, blank);
    case Asked::Multiplier:
        return {translatable("how many times the sheet of the sway at {node} is added"),
                {{"node", model[worksheet.form.problem.sways[blank.sway].prop].id}}};
    case Asked::Final: return {translatable("final moment at {end}"), {{"end", end}}};
    }
    return {};
}

Message words_of(fc::Slip slip)
{
    using enum fc::Slip;
    switch (slip) {
    case TooCoarse: return translatable("too few digits: write one more");
    case OppositeSign:
        return translatable("the sign is turned: counter-clockwise on the end of the member is positive");
    case PinnedAsFixed:
        return translatable("this is for a far end that is held: the far end is pinned (3EI/L, qL²/8, 3PL/16)");
    case FixedAsPinned:
        return translatable("this is for a pinned far end: the far end is held here (4EI/L, qL²/12, PL/8)");
    case FreeEndStiff: return translatable("an overhang does not resist the rotation of its joint");
    case NoLength: return translatable("it is not divided by the length");
    case OtherEI: return translatable("this is with the EI of another member");
    case BareStiffness: return translatable("4EI/L or 3EI/L turns an end, not EI/L or 2EI/L");
    case ExchangedFactor: return translatable("this is the factor of another member at the joint");
    case InvertedFactor: return translatable("the ratio is turned over: the stiffer member takes more");
    case RatioOfTwo: return translatable("this is a ratio of two stiffnesses: divide by the sum of the joint");
    case SharedWithOthers: return translatable("stiffnesses of other joints are in the sum");
    case EqualShares: return translatable("equal shares: they go by stiffness");
    case UnmodifiedFactor: return translatable("a pinned far end is not considered: there 3EI/L counts");
    case Percent: return translatable("this is in percent: write the part of 1");
    case FactorsNotOne: return translatable("the factors of the joint do not add up to 1");
    case OtherEnd: return translatable("this is for the other end of the member (Pab²/L² and Pa²b/L²)");
    case PinnedEndHolds: return translatable("a pinned end holds no moment");
    case OverhangForgotten:
        return translatable("the moment of the overhang is forgotten: half of it goes on to the other end");
    case LoadForgotten: return translatable("a load of the member is forgotten");
    case BalanceNotReversed: return translatable("the balance has the sign of the unbalance: it must undo it");
    case OtherFactor: return translatable("this is with the factor of another member at the joint");
    case NotShared: return translatable("the whole unbalance: it is shared by the factors");
    case CarryOverNotCounted: return translatable("something that was carried over to the joint is not counted");
    case MomentNotCounted: return translatable("a fixed-end moment of the joint is not counted");
    case JointLoadForgotten:
        return translatable("the moment that loads the joint from outside is forgotten, or its sign is turned");
    case CountedAgain: return translatable("what was balanced before is counted again");
    case CarryOverForgotten: return translatable("the carry-over is forgotten");
    case CarriedWhole: return translatable("all of the balance is carried over: half of it arrives");
    case CarriedWithOtherSign: return translatable("the sign is turned: a carry-over keeps that of the balance");
    case CarriedToPinnedEnd: return translatable("nothing is carried over to a pinned or free end");
    case CarriedFromOther: return translatable("this comes from the balance of another member");
    case LineForgotten: return translatable("a line of the column is not added");
    case MemberForgotten: return translatable("the shear of a member is forgotten");
    case LoadsForgotten: return translatable("the part of the loads is forgotten");
    case MultiplierInverted: return translatable("the ratio is turned over");
    case SwayForgotten: return translatable("the sway is not added");
    case SwaySubtracted: return translatable("the sway is subtracted: it is added with its sign");
    case SwayNotScaled: return translatable("the sheet of the sway is added once: it is added so many times");
    }
    return {};
}

Message words_of(fc::Hint hint)
{
    using enum fc::Hint;
    switch (hint) {
    case LookAtFarEnd: return translatable("look at the far end of the member: is it held, pinned or free?");
    case FarEndHeld: return translatable("a far end that is fixed or locked: 4EI/L");
    case FarEndPinned: return translatable("a far end that is pinned: 3EI/L");
    case FreeEnd: return translatable("an overhang turns with its joint and resists nothing");
    case SpringOfSupport: return translatable("the spring of the support resists with its own stiffness");
    case GeneralStiffness: return translatable("the moment that turns this end by 1, of the member as it is joined");
    case OwnEIAndLength: return translatable("take EI and L of this member, in the unit that is asked");
    case ShareOfJoint: return translatable("which members resist the rotation of this joint?");
    case StiffnessOverSum: return translatable("divide the stiffness of this end by the sum of the joint");
    case FactorsAddUp: return translatable("the factors of a joint add up to 1");
    case LockedEnds: return translatable("all joints are locked: which loads act on this member?");
    case FormulaBothHeld: return translatable("held at both ends: qL²/12, PL/8, Pab²/L²; loads add up");
    case FormulaPinned: return translatable("pinned at the other end: qL²/8, 3PL/16; loads add up");
    case Cantilever: return translatable("cut the overhang at its support: equilibrium gives the moment");
    case PassOverhang: return translatable("the moments at the support add to nothing: what does the overhang leave?");
    case PinnedEnd: return translatable("how much moment can a pinned end hold?");
    case SenseOfMoment: return translatable("which way must the end be turned back? Counter-clockwise is positive");
    case SwayMoments:
        return translatable("6EI/L² or 3EI/L² of each member that the sway turns; the largest is taken as 100");
    case MomentsAtJoint: return translatable("which moments act on the joint now?");
    case MustAddToNothing: return translatable("the moments at the joint must add to nothing, or to its load");
    case TimesFactor: return translatable("turn the sign of their sum about and take the share of this end");
    case WhatFarEndReceives: return translatable("what arrives at the far end when this end of the member is turned?");
    case HalfWithSameSign: return translatable("half of the balance, with its sign");
    case NothingToPin: return translatable("a pinned or free end cannot hold a moment: nothing arrives");
    case TimesCarryOverFactor: return translatable("the balance times the carry-over factor of this member");
    case AddColumn: return translatable("add everything in the column");
    case LinesOfColumn: return translatable("fixed-end moment, balances and carry-overs, with their signs");
    case SumsBalance: return translatable("check: the sums at a joint add to nothing, or to its load");
    case CutFree: return translatable("cut the members that the sway turns at their ends");
    case ShearsOfMembers: return translatable("the shear of each follows from its end moments and its loads");
    case ForceOnProp: return translatable("the prop holds what is left along its direction");
    case PropsMustBeFree: return translatable("the structure has no prop: all its forces together are nothing");
    case SolveForMultiplier: return translatable("force in the loads' sheet + times · force in the sway's sheet = 0");
    case LoadsPlusSways: return translatable("sum in the loads' sheet + times · sum in the sway's sheet");
    }
    return {};
}

Message verdict_text(const fc::Judgement& judgement)
{
    switch (judgement.verdict) {
    case fc::Verdict::Open: return {};
    case fc::Verdict::Right: return translatable("right");
    case fc::Verdict::FollowsRight: return translatable("right for the numbers that you had");
    case fc::Verdict::Wrong: return translatable("not so");
    case fc::Verdict::Slipped: break;
    }
    const Message first = words_of(judgement.slips.front());
    if (judgement.slips.size() < 2) return first;
    return {translatable("{this}; or {that}"), {{"this", first}, {"that", words_of(judgement.slips[1])}}};
}

} // namespace cross
