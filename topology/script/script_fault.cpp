#include "topology/script/script_fault.h"

namespace topology {

std::string_view pattern(ScriptFault fault)
{
    switch (fault) {
    case ScriptFault::UnknownWord: return "there is no operator {0}";
    case ScriptFault::CapitalWord: return "operators are written in small letters: {0}";
    case ScriptFault::WrongCount: return "{0} is written: {1}";
    case ScriptFault::BadName: return "\"{0}\" is no name; begin with a letter and leave out > % #";
    case ScriptFault::BadNumber: return "\"{0}\" is no finite number";
    case ScriptFault::BadAmount: return "\"{0}\" is no whole number from 1 on";
    case ScriptFault::BeyondRange: return "{0} would move beyond the range of numbers";
    case ScriptFault::NameInUse: return "the name {0} is in use in {1}; choose another";
    case ScriptFault::NoSolid: return "there is no solid {0}";
    case ScriptFault::NoVertex: return "there is no vertex {0} in {1}";
    case ScriptFault::NoFace: return "there is no face {0} in {1}";
    case ScriptFault::NoHalfEdge: return "there is no half-edge {0} in {1}";
    case ScriptFault::NotInFace: return "{0} is not in face {1}";
    case ScriptFault::NoCornerInFace: return "there is no half-edge {0} in face {1}";
    case ScriptFault::BadCorner:
        return "{0} is no corner: a name is missing beside >; write v1, v1>v2, v1>v2>v3 or a number %7";
    case ScriptFault::NoEdgeBetween: return "there is no edge between {0} and {1}";
    case ScriptFault::Ambiguous: return "{0} fits several half-edges: {1}; name one of them by its number";
    case ScriptFault::WrongStart: return "{0} does not start at {1}";
    case ScriptFault::NoRing: return "{0} is no lone vertex of face {1}";
    case ScriptFault::WhichShell: return "{0} has several shells; say which by its face";
    case ScriptFault::SameHalfEdge: return "{0} is given twice; write mev for a strut";
    case ScriptFault::NothingToUndo: return "there are {0} steps to undo, not {1}";
    case ScriptFault::NothingToRedo: return "there are {0} steps to redo, not {1}";
    }
    return "";
}

LineError error(ScriptFault fault, const std::vector<std::string>& words) { return {pattern(fault), words}; }

} // namespace topology
