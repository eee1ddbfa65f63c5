#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "topology/text/line_error.h"

namespace topology {

/// What is wrong with a line of a script. Its sentence stands in script_fault.cpp.
enum class ScriptFault : std::uint8_t {
    UnknownWord,    ///< {0}
    CapitalWord,    ///< {0} as it is written
    WrongCount,     ///< {0} the operator, {1} how its line is written
    BadName,        ///< {0}
    BadNumber,      ///< {0}
    BadAmount,      ///< {0}
    BeyondRange,    ///< {0} a vertex
    NameInUse,      ///< {0}, {1} a kind in {2}
    NoSolid,        ///< {0}
    NoVertex,       ///< {0}, {1} solid
    NoFace,         ///< {0}, {1} solid
    NoHalfEdge,     ///< {0}, {1} solid
    NotInFace,      ///< {0} vertex, {1} face
    NoCornerInFace, ///< {0} corner, {1} face
    BadCorner,      ///< {0}
    NoEdgeBetween,  ///< {0}, {1} vertices
    Ambiguous,      ///< {0}, {1} the half-edges that fit
    WrongStart,     ///< {0} half-edge, {1} vertex
    NoRing,         ///< {0} vertex, {1} face
    WhichShell,     ///< {0} solid
    SameHalfEdge,   ///< {0} half-edge
    NothingToUndo,  ///< {0} steps there are, {1} wanted
    NothingToRedo,  ///< {0} steps there are, {1} wanted
};
inline constexpr int n_script_faults = 23;

std::string_view pattern(ScriptFault fault); ///< English, with places {0} {1} {2}

LineError error(ScriptFault fault, const std::vector<std::string>& words);

} // namespace topology
