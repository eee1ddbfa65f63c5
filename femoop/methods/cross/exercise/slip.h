#pragma once

#include <cstdint>
#include <vector>

#include "femoop/methods/cross/exercise/formulas.h"

namespace femoop::cross {

/// Mistakes that are often made.
enum class Slip : std::uint8_t {
    TooCoarse, ///< right for the digits that were written, which are too few
    OppositeSign,
    // stiffness
    PinnedAsFixed, ///< 4EI/L for 3EI/L, qL2/12 for qL2/8, PL/8 for 3PL/16
    FixedAsPinned, ///< the other way about
    FreeEndStiff,  ///< an overhang resists nothing
    NoLength,      ///< it is not divided by the length
    OtherEI,       ///< another member's EI
    BareStiffness, ///< EI/L, or 2EI/L: not what turns an end
    // factors
    ExchangedFactor,  ///< of another member at the joint
    InvertedFactor,   ///< shared by EI/L turned over
    RatioOfTwo,       ///< of two stiffnesses of the joint, not of its sum
    SharedWithOthers, ///< by the stiffnesses of other joints too
    EqualShares,
    UnmodifiedFactor, ///< of stiffnesses that know no pins
    Percent,
    FactorsNotOne, ///< the joint's factors do not add up to 1
    // fixed-end moments
    OtherEnd,          ///< Pab2/L2 for Pa2b/L2
    PinnedEndHolds,    ///< a pinned end holds no moment
    OverhangForgotten, ///< its moment passes the support and half of it goes on
    LoadForgotten,     ///< of several
    // balances
    BalanceNotReversed,
    OtherFactor,         ///< of another member at the joint
    NotShared,           ///< no factor
    CarryOverNotCounted, ///< that the joint has received
    MomentNotCounted,    ///< a fixed-end moment of the joint
    JointLoadForgotten,  ///< or taken with the wrong sign
    CountedAgain,        ///< what was balanced before
    // carry-overs
    CarryOverForgotten,
    CarriedWhole,
    CarriedWithOtherSign,
    CarriedToPinnedEnd,
    CarriedFromOther, ///< from another member
    // sums
    LineForgotten,
    // sways
    MemberForgotten, ///< the shear of a member
    LoadsForgotten,  ///< the loads themselves
    MultiplierInverted,
    SwayForgotten,
    SwaySubtracted,
    SwayNotScaled
};

/// A mistake, and what it gives.
struct SlipFigure {
    Slip slip;
    Figure figure;
};

/// What mistakes would write into a cell, worked out of the figures before it. Some of them may give the same number,
/// or the right one.
std::vector<SlipFigure> slips_of(const Form& form, const std::vector<Figure>& figures, BlankId id);

} // namespace femoop::cross
