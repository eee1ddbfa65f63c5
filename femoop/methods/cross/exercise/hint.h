#pragma once

#include <cstdint>
#include <vector>

#include "femoop/methods/cross/exercise/form.h"

namespace femoop::cross {

/// What one can be told about a cell: an operation, never its number.
enum class Hint : std::uint8_t {
    LookAtFarEnd,         ///< what holds the far end?
    FarEndHeld,           ///< then it is 4EI/L
    FarEndPinned,         ///< then it is 3EI/L
    FreeEnd,              ///< an overhang resists nothing
    SpringOfSupport,      ///< its own stiffness
    GeneralStiffness,     ///< the moment for a unit rotation of an end that is not rigid
    OwnEIAndLength,       ///< take EI and L of this member
    ShareOfJoint,         ///< which members resist this joint's rotation?
    StiffnessOverSum,     ///< divide by the sum over the joint
    FactorsAddUp,         ///< to 1
    LockedEnds,           ///< which loads act on the locked member?
    FormulaBothHeld,      ///< of a member held at both ends
    FormulaPinned,        ///< of a member pinned at its far end
    Cantilever,           ///< equilibrium of the overhang
    PassOverhang,         ///< the overhang's moment, turned about, at its support
    PinnedEnd,            ///< holds no moment
    SenseOfMoment,        ///< counter-clockwise on the end is positive
    SwayMoments,          ///< 6EI/L2 or 3EI/L2 by the chord's rotation, the largest taken as 100
    MomentsAtJoint,       ///< which moments act on the joint now?
    MustAddToNothing,     ///< the balance turns their sum about
    TimesFactor,          ///< shared by the factors
    WhatFarEndReceives,   ///< what reaches the far end when this one turns?
    HalfWithSameSign,     ///< with its sign
    NothingToPin,         ///< nothing reaches an end that cannot hold a moment
    TimesCarryOverFactor, ///< of a member that is not prismatic or not rigidly joined
    AddColumn,            ///< everything in it
    LinesOfColumn,        ///< fixed-end moment, balances, carry-overs
    SumsBalance,          ///< the sums at a joint add to its load
    CutFree,              ///< the members that the sway turns
    ShearsOfMembers,      ///< each from its end moments and loads
    ForceOnProp,          ///< the prop holds what is left, along its direction
    PropsMustBeFree,      ///< all forces of a prop, added, are nothing
    SolveForMultiplier,   ///< the shear equation of each prop
    LoadsPlusSways        ///< sum of the loads' sheet and so many times that of the sway
};

/// Up to three for a cell, each telling more than the one before.
std::vector<Hint> hints_for(const Form& form, BlankId id);

} // namespace femoop::cross
