#include "femoop/methods/influence/member_motion.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "femoop/methods/influence/polynomial_terms.h"

namespace femoop::influence {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// Twist of a stretch without distributed torque.
Polynomial twist(const Bar::State& begin, double GJ)
{
    const bool is_elastic = GJ > 0.0 && GJ < infinite;
    return {begin.u, is_elastic ? begin.N / GJ : 0.0};
}

/// Coefficients of p(length - t).
std::vector<double> reversed(std::vector<double> c, double length)
{
    // p(t + length) by repeated division, then t with the other sign
    for (std::size_t first = 0; first + 1 < c.size(); ++first)
        for (std::size_t i = c.size() - 1; i-- > first;) c[i] += length * c[i + 1];
    for (std::size_t i = 1; i < c.size(); i += 2) c[i] = -c[i];
    return c;
}

using LocalLoad = std::array<double, n_local_axes>;

LocalLoad in_member_axes(const NodeVector& load, const MemberGeometry& geometry)
{
    const Eigen::Vector3d force = geometry.axes * Eigen::Vector3d(load[0], load[1], load[2]);
    const Eigen::Vector3d couple = geometry.axes * Eigen::Vector3d(load[3], load[4], load[5]);
    return {force[0], force[1], force[2], couple[0], couple[1], couple[2]};
}

std::vector<double> work(const MotionPiece& piece, const LocalLoad& load)
{
    std::vector<double> sum;
    for (std::size_t axis = 0; axis < n_local_axes; ++axis) {
        const Polynomial& p = piece.along[axis];
        if (load[axis] == 0.0) continue;
        sum.resize(std::max(sum.size(), p.n_terms()), 0.0);
        for (std::size_t i = 0; i < p.n_terms(); ++i) sum[i] += load[axis] * p[i];
    }
    return sum;
}

bool is_rigid(const Discretisation& structure, MemberId member)
{
    const MemberEndConditions* conditions = structure.end_conditions_of(member);
    return conditions != nullptr && conditions->constraint == Constraint::Rigid;
}

} // namespace

bool is_bar(const Discretisation& structure, MemberId member)
{
    const MemberEndConditions* conditions = structure.end_conditions_of(member);
    return conditions != nullptr && conditions->is_bar;
}

Beam beam_of(const Discretisation& structure, MemberId member, BendingPlane plane)
{
    const MemberProperties& properties = structure.properties_of(member);
    if (is_bar(structure, member)) return {.EI = infinite};
    Beam beam = plane == BendingPlane::xy ? properties.xy : properties.xz;
    if (is_rigid(structure, member)) return {.EI = infinite, .foundation = beam.foundation};
    if (beam.EI == 0.0) beam.EI = infinite;
    return beam;
}

MemberMotion motion_of(const Curve& curve, const Discretisation& structure, MemberId member)
{
    const Beam xy = beam_of(structure, member, BendingPlane::xy), xz = beam_of(structure, member, BendingPlane::xz);
    const bool twists = !is_bar(structure, member) && !is_rigid(structure, member);
    const double GJ = twists ? structure.properties_of(member).torsion.EA : infinite;
    MemberMotion motion;
    for (const Curve::Piece& piece : curve.pieces()) {
        MotionPiece& moved = motion.emplace_back();
        moved.from = piece.load.begin;
        moved.to = piece.load.end;
        moved.along = {curve.polynomial(MemberComponent::u, piece),
                       curve.polynomial(MemberComponent::v, piece),
                       curve.polynomial(MemberComponent::w, piece),
                       twist(piece.begin.torsion, GJ),
                       negated(xz.series(piece.begin.xz, piece.load, BendingPlane::xz, 0.0).phi),
                       xy.series(piece.begin.xy, piece.load, BendingPlane::xy, 0.0).phi};
    }
    return motion;
}

std::vector<LinePiece> work_along(const PathMember& on, const MemberMotion& motion, const MemberGeometry& geometry,
                                  const NodeVector& load)
{
    const LocalLoad local = in_member_axes(load, geometry);
    std::vector<LinePiece> pieces;
    for (const MotionPiece& moved : motion) {
        std::vector<double> c = work(moved, local);
        const double first = on.s_of(moved.from), last = on.s_of(moved.to);
        if (on.is_reversed) c = reversed(std::move(c), moved.length());
        pieces.push_back({.from = std::min(first, last), .to = std::max(first, last), .coefficients = std::move(c)});
    }
    if (on.is_reversed) std::ranges::reverse(pieces);
    pieces.front().from = on.begin; // whatever rounding made of it
    pieces.back().to = on.end();
    for (std::size_t i = 1; i < pieces.size(); ++i) pieces[i].from = pieces[i - 1].to;
    return pieces;
}

} // namespace femoop::influence
