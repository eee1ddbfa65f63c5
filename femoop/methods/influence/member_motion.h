#pragma once

#include <array>
#include <vector>

#include "femoop/discretisation/discretisation.h"
#include "femoop/element/polynomial.h"
#include "femoop/element/span_load.h"
#include "femoop/methods/influence/load_path.h"
#include "femoop/methods/influence/piecewise_line.h"
#include "femoop/model/ids.h"
#include "femoop/result/curve.h"

namespace femoop::influence {

inline constexpr double end_of_member = 1e-12; ///< of its length: a section so near to an end is at the end

/// How a stretch of a member moves: along its axes and about them, each a polynomial of t = x - from.
struct MotionPiece {
    double from = 0.0, to = 0.0;
    std::array<Polynomial, n_local_axes> along{}; ///< by LocalAxis

    double length() const { return to - from; }
};

/// How a member without span loads moves, from its first end to its second. On a foundation and along a taper the pieces
/// are so short that their power series give every digit.
using MemberMotion = std::vector<MotionPiece>;

/// \pre the curve is of this member, with nothing but point loads on it
MemberMotion motion_of(const Curve& curve, const Discretisation& structure, MemberId member);

/// The work of a unit load that passes a member, piece by piece along the path.
/// \param load  fx fy fz mx my mz along global axes
std::vector<LinePiece> work_along(const PathMember& on, const MemberMotion& motion, const MemberGeometry& geometry,
                                  const NodeVector& load);

/// The beam that a member is between its ends: infinitely stiff where it does not bend.
Beam beam_of(const Discretisation& structure, MemberId member, BendingPlane plane);
bool is_bar(const Discretisation& structure, MemberId member);

} // namespace femoop::influence
