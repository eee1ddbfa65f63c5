#pragma once

#include <cstddef>
#include <vector>

#include "femoop/model/expected.h"
#include "femoop/model/model.h"

namespace femoop::influence {

/// A member of a path, as the load passes it.
struct PathMember {
    MemberId member;
    bool is_reversed = false; ///< it is passed from its second end to its first
    double begin = 0.0;       ///< s where the load comes onto it
    double length = 0.0;      ///< of its flexible part: rigid offsets do not count

    double end() const { return begin + length; }
    double x_of(double s) const { return is_reversed ? end() - s : s - begin; } ///< along the member
    double s_of(double x) const { return is_reversed ? end() - x : begin + x; }
};

/// A place of a path on its member.
struct PathPlace {
    std::size_t index = 0; ///< of the path's members
    MemberId member;
    double x = 0.0; ///< from the member's first end, 0 .. its length
};

/// A path laid out: its members one after the other, and the place s along them.
///
///      s = 0                s                    s = length
///        o======AB======o===*==BC======o======CD======o
///
/// s counts from the end of the first member that the second does not touch; of a single member from its first node.
struct PathLayout {
    std::vector<PathMember> members;

    double length() const { return members.empty() ? 0.0 : members.back().end(); }
    /// At a node between two members Side::Before is on the one that ends there. \pre 0 <= s <= length()
    PathPlace place(double s, Side side = Side::After) const;
    std::vector<double> nodes() const;                         ///< s of the members' ends: 0, ..., length()
    std::vector<double> places_of(MemberId m, double x) const; ///< each s where the path is there; empty off the path
};

/// The members that a path or a list means.
const std::vector<MemberId>& members_of(const Model& model, const LoadPathReference& path);

/// \throws ModelError  `why_no_path` (femoop/geometry/path_walk.h)
PathLayout lay_out(const Model& model, const std::vector<MemberId>& members);

/// A unit load's components along global axes fx fy fz mx my mz; down where none are given: -y in the plane, else -z.
NodeVector unit_load(AnalysisKind kind, const std::vector<Component>& components);

} // namespace femoop::influence
