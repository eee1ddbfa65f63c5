#include "femoop/element/beam.h"

#include <Eigen/LU>
#include <cmath>
#include <limits>
#include <span>

#include "femoop/element/polynomial_product.h"
#include "femoop/element/strain_form.h"

namespace femoop {

Eigen::Matrix4d Beam::stiffness(double L) const
{
    if (!taper.is_prismatic()) {
        const StrainForm form = strain_form(*this, L, BendingPlane::xy);
        return form.B.transpose() * form.S * form.B;
    }
    const double shear = 12.0 * EI * shear_flexibility / (L * L);
    const double k = EI / (L * L * L * (1.0 + shear));
    const double a = 12.0 * k;
    const double b = 6.0 * L * k;
    const double near = (4.0 + shear) * L * L * k;
    const double far = (2.0 - shear) * L * L * k;
    Eigen::Matrix4d K;
    K << a, b, -a, b,     //
        b, near, -b, far, //
        -a, -b, a, -b,    //
        b, far, -b, near;
    return K;
}

Eigen::Matrix2d Beam::chord_stiffness(double L) const
{
    if (!taper.is_prismatic()) return tapered_chord_stiffness(L);
    const double shear = 12.0 * EI * shear_flexibility / (L * L);
    Eigen::Matrix2d S;
    S << 4.0 + shear, 2.0 - shear, //
        2.0 - shear, 4.0 + shear;
    return S * (EI / (L * (1.0 + shear)));
}

// By the unit-load theorem [Kassimali, ch. 7], with M = -m1 (1 - x/L) + m2 x/L and V = (m1 + m2) / L.
Eigen::Matrix2d Beam::tapered_chord_stiffness(double L) const
{
    SpanLoading pieces;
    pieces.assign(L, {}, longest_piece());
    double near = 0.0, far = 0.0, mixed = 0.0, shear = 0.0; // integrals
    for (const SpanPiece& piece : pieces.pieces()) {
        const Polynomial flexibility = bending_flexibility(piece.begin);
        const double h = piece.length(), b = piece.begin / L, a = 1.0 - b; // (1 - x/L, x/L) = (a - t/L, b + t/L)
        const double f0 = flexibility.moment(0, h), f1 = flexibility.moment(1, h) / L,
                     f2 = flexibility.moment(2, h) / (L * L);
        near += a * a * f0 - 2.0 * a * f1 + f2;
        far += b * b * f0 + 2.0 * b * f1 + f2;
        mixed += a * b * f0 + (a - b) * f1 - f2;
        if (shear_flexibility > 0.0) shear += shearing_flexibility(piece.begin).moment(0, h) / (L * L);
    }
    Eigen::Matrix2d flexibility;
    flexibility << near + shear, shear - mixed, //
        shear - mixed, far + shear;
    return flexibility.inverse();
}

Polynomial Beam::bending_flexibility(double x) const
{
    const auto [a1, a2, a3] = taper.inertia;
    return Polynomial{EI, EI * a1, EI * a2, EI * a3}.shifted(x).reciprocal();
}

Polynomial Beam::shearing_flexibility(double x) const
{
    const double GAs = 1.0 / shear_flexibility;
    return Polynomial{GAs, GAs * taper.shear_area}.shifted(x).reciprocal();
}

Beam::Series Beam::tapered_series(const State& begin, const SpanPiece& piece, BendingPlane plane,
                                  double curvature) const
{
    const std::size_t force = index(force_axis(plane)), moment = index(moment_axis(plane));
    const double q = piece.value[force], dq = piece.slope[force];
    const double m = moment_sign(plane) * piece.value[moment], dm = moment_sign(plane) * piece.slope[moment];
    Series s{.v = {begin.v},
             .phi = {begin.phi},
             .V = {begin.V, q, 0.5 * dq},
             .M = {begin.M, begin.V - m, 0.5 * (q - dm), dq / 6.0}};
    const Polynomial bending = bending_flexibility(piece.begin);
    const Polynomial shearing = shear_flexibility > 0.0 ? shearing_flexibility(piece.begin) : Polynomial{0.0};
    const Polynomial depth = Polynomial{1.0, taper.depth}.shifted(piece.begin).reciprocal();
    for (std::size_t n = 0; n + 1 < Polynomial::max_terms; ++n) {
        const double next = 1.0 / static_cast<double>(n + 1);
        s.v.append((s.phi[n] - product_coefficient(s.V, shearing, n)) * next);
        s.phi.append((product_coefficient(s.M, bending, n) + curvature * depth[n]) * next);
    }
    return s;
}

Beam::Series Beam::series(const State& begin, const SpanPiece& piece, BendingPlane plane, double curvature) const
{
    if (!taper.is_prismatic()) return tapered_series(begin, piece, plane, curvature);
    if (piece.is_settled && foundation > 0.0) return settled(piece, plane, curvature);
    const std::size_t force = index(force_axis(plane));
    const std::size_t moment = index(moment_axis(plane));
    const double sign = moment_sign(plane);
    const std::array<double, 2> q{piece.value[force], piece.slope[force]};
    const std::array<double, 2> m{sign * piece.value[moment], sign * piece.slope[moment]};

    // The beam's equations, power by power: the coefficient n + 1 of a function is that of its derivative over n + 1.
    const std::size_t n_powers = foundation > 0.0 ? Polynomial::max_terms - 1 : 5;
    const double flexibility = 1.0 / EI;
    Series s;
    double v = begin.v, phi = begin.phi, V = begin.V, M = begin.M;
    for (std::size_t n = 0; n <= n_powers; ++n) {
        s.v.append(v);
        s.phi.append(phi);
        s.V.append(V);
        s.M.append(M);
        const double next = 1.0 / static_cast<double>(n + 1);
        const double dV = (n < 2 ? q[n] : 0.0) - foundation * v;
        const double dM = V - (n < 2 ? m[n] : 0.0);
        const double dphi = M * flexibility + (n == 0 ? curvature : 0.0);
        const double dv = phi - V * shear_flexibility;
        v = dv * next;
        phi = dphi * next;
        V = dV * next;
        M = dM * next;
    }
    return s;
}

Beam::State Beam::at(double t, const State& begin, const SpanPiece& piece, BendingPlane plane, double curvature) const
{
    if (foundation > 0.0 || !taper.is_prismatic()) return series(begin, piece, plane, curvature).at(t);
    const std::size_t force = index(force_axis(plane));
    const std::size_t moment = index(moment_axis(plane));
    const double q = piece.value[force], dq = piece.slope[force];
    const double m = moment_sign(plane) * piece.value[moment], dm = moment_sign(plane) * piece.slope[moment];
    const double V0 = begin.V, M0 = begin.M, c = 1.0 / EI;
    const Forces forces = forces_at(t, begin, piece, plane, curvature);
    // V' = q, M' = V - m, phi' = M / EI + curvature, v' = phi - V / GAs, integrated once after the other
    return {
        .v = begin.v +
             t * (begin.phi + t * (0.5 * curvature +
                                   c * (0.5 * M0 + t * ((V0 - m) / 6.0 + t * ((q - dm) / 24.0 + t * dq / 120.0))))) -
             shear_flexibility * t * (V0 + t * (0.5 * q + t * dq / 6.0)),
        .phi = begin.phi + t * (curvature + c * (M0 + t * (0.5 * (V0 - m) + t * ((q - dm) / 6.0 + t * dq / 24.0)))),
        .V = forces.V,
        .M = forces.M};
}

Beam::State Beam::after_jump(State before, const std::array<double, n_local_axes>& jump, BendingPlane plane)
{
    before.V += jump[index(force_axis(plane))];
    before.M -= moment_sign(plane) * jump[index(moment_axis(plane))];
    return before;
}

Eigen::Vector4d Beam::fixed_end_forces(const SpanLoading& loading, BendingPlane plane) const
{
    const double L = loading.length();
    const double curvature = plane == BendingPlane::xy ? loading.curvature() : 0.0;
    State state; // with the first end held and the second free of its unknown forces
    for (const SpanPiece& piece : loading.pieces())
        state = at(piece.length(), after_jump(state, piece.jump, plane), piece, plane, curvature);
    state = after_jump(state, loading.last_jump(), plane);
    // The unknown V0 and M0 bring the second end back: the same force and moment that hold a clamped-clamped beam.
    const Eigen::Vector4d moved(0.0, 0.0, -state.v, -state.phi);
    const Eigen::Vector4d held = stiffness(L) * moved;
    const double V0 = held[0];
    const double M0 = -held[1];
    return {V0, -M0, -(V0 + state.V), M0 + V0 * L + state.M};
}

Eigen::Vector2d Beam::simple_span_forces(const SpanLoading& loading, BendingPlane plane)
{
    const Beam stiff{.EI = std::numeric_limits<double>::infinity()};
    State state; // of the loads alone
    for (const SpanPiece& piece : loading.pieces())
        state = stiff.at(piece.length(), after_jump(state, piece.jump, plane), piece, plane, 0.0);
    state = after_jump(state, loading.last_jump(), plane);
    const double V0 = -state.M / loading.length(); // makes the moment at the second end vanish
    return {V0, -(V0 + state.V)};
}

namespace {

/// Of the roots of lambda^4 - (k / GAs) lambda^2 + k / EI = 0: half the sum of their squares, and their product.
struct Rates {
    double half_sum, product;
};

Rates rates(const Beam& beam)
{
    return {.half_sum = 0.5 * beam.foundation * beam.shear_flexibility,
            .product = std::sqrt(beam.foundation / beam.EI)};
}

} // namespace

double Beam::longest_piece() const
{
    if (foundation <= 0.0) return taper.longest_piece;
    // The largest root of lambda^4 - (k / GAs) lambda^2 + k / EI = 0 bounds how fast a solution varies.
    const auto [a, p] = rates(*this);
    return 1.0 / std::sqrt(a > p ? a + std::sqrt((a - p) * (a + p)) : p);
}

double Beam::settling() const
{
    if (foundation <= 0.0) return std::numeric_limits<double>::infinity();
    constexpr double forgotten = 40.0; // exp(-40) is below the last bit
    const auto [a, p] = rates(*this);
    // the smallest real part of a root
    return forgotten / (a > p ? p * longest_piece() : std::sqrt(0.5 * (a + p)));
}

double Beam::stiffest_foundation(double L) const
{
    // Without shear the pieces stay few, but they must not drown in the rounding of x. With shear one of the roots
    // grows with the foundation and the other does not, so that nothing settles and the pieces fill the member.
    const double lambda = (shear_flexibility > 0.0 ? 1e4 : 1e6) / L;
    const double lambda2 = lambda * lambda;
    if (lambda2 * EI * shear_flexibility < 2.0) return EI * lambda2 * lambda2;
    return lambda2 * lambda2 / (lambda2 * shear_flexibility - 1.0 / EI);
}

Beam::Series Beam::settled(const SpanPiece& piece, BendingPlane plane, double curvature) const
{
    const std::size_t force = index(force_axis(plane)), moment = index(moment_axis(plane));
    const double q = piece.value[force], dq = piece.slope[force];
    const double m = moment_sign(plane) * piece.value[moment], dm = moment_sign(plane) * piece.slope[moment];
    return {.v = {(q - dm) / foundation, dq / foundation},
            .phi = {dq / foundation + m * shear_flexibility, dm * shear_flexibility},
            .V = {m, dm},
            .M = {EI * (dm * shear_flexibility - curvature)}};
}

namespace {

/// How a piece's far end follows from its near end: (v, phi, V, M) there = A (v, phi, V, M) here + load.
struct Transfer {
    Eigen::Matrix4d A;
    Eigen::Vector4d load;
};

Eigen::Vector4d column(const Beam::State& s) { return {s.v, s.phi, s.V, s.M}; }

Transfer transfer(const Beam& beam, const SpanPiece& piece, BendingPlane plane, double curvature)
{
    const SpanPiece bare{.begin = piece.begin, .end = piece.end};
    const double h = piece.length();
    Transfer t;
    t.A.col(0) = column(beam.series({.v = 1.0}, bare, plane, 0.0).at(h));
    t.A.col(1) = column(beam.series({.phi = 1.0}, bare, plane, 0.0).at(h));
    t.A.col(2) = column(beam.series({.V = 1.0}, bare, plane, 0.0).at(h));
    t.A.col(3) = column(beam.series({.M = 1.0}, bare, plane, 0.0).at(h));
    const Beam::State begin = Beam::after_jump({}, piece.jump, plane);
    t.load = column(beam.series(begin, piece, plane, curvature).at(h));
    return t;
}

/// Through one after the other.
Transfer transfer(const Beam& beam, std::span<const SpanPiece> pieces, BendingPlane plane, double curvature)
{
    Transfer through = transfer(beam, pieces.front(), plane, curvature);
    for (const SpanPiece& piece : pieces.subspan(1)) {
        const Transfer next = transfer(beam, piece, plane, curvature);
        through = {next.A * through.A, next.A * through.load + next.load};
    }
    return through;
}

struct Ends {
    Eigen::Matrix4d K;
    Eigen::Vector4d fixed;
};

/// The piece as a beam between two joints: its forces solved for from its displacements.
Ends ends(const Transfer& t)
{
    const Eigen::Matrix2d to_force = t.A.topRightCorner<2, 2>().inverse(); // near force from far displacement
    const Eigen::DiagonalMatrix<double, 2> near_sign(1.0, -1.0), far_sign(-1.0, 1.0);
    const Eigen::Matrix2d near_near = -to_force * t.A.topLeftCorner<2, 2>();
    const Eigen::Vector2d near_load = -to_force * t.load.head<2>();
    const Eigen::Matrix2d spread = t.A.bottomRightCorner<2, 2>();
    Ends e;
    e.K.topLeftCorner<2, 2>() = near_sign * near_near;
    e.K.topRightCorner<2, 2>() = near_sign * to_force;
    e.K.bottomLeftCorner<2, 2>() = far_sign * (t.A.bottomLeftCorner<2, 2>() + spread * near_near);
    e.K.bottomRightCorner<2, 2>() = far_sign * (spread * to_force);
    e.K = (0.5 * (e.K + e.K.transpose())).eval();
    e.fixed << near_sign * near_load, far_sign * (spread * near_load + t.load.tail<2>());
    return e;
}

/// The settled piece as two half-infinite beams that part from its particular solution at its ends.
Ends settled_ends(const Beam& beam, const SpanPiece& piece, BendingPlane plane, double curvature)
{
    const auto [a, p] = rates(beam);
    const double sum = std::sqrt(2.0 * (a + p)); // of the two roots that decay
    const double k = beam.foundation / (2.0 * a + p);
    const double turning = beam.EI * sum * p / (2.0 * a + p);
    const Beam::Series particular = beam.series({}, piece, plane, curvature);
    const Beam::State near = particular.at(0.0), far = particular.at(piece.length());
    Ends e;
    e.K << k * sum, k, 0.0, 0.0, //
        k, turning, 0.0, 0.0,    //
        0.0, 0.0, k * sum, -k,   //
        0.0, 0.0, -k, turning;
    e.fixed = Eigen::Vector4d(near.V, -near.M, -far.V, far.M) - e.K * Eigen::Vector4d(near.v, near.phi, far.v, far.phi);
    return e;
}

Ends ends(const Beam& beam, std::span<const SpanPiece> pieces, BendingPlane plane, double curvature)
{
    return pieces.front().is_settled ? settled_ends(beam, pieces.front(), plane, curvature)
                                     : ends(transfer(beam, pieces, plane, curvature));
}

/// Where each link ends: a settled piece is one by itself, others follow one another until they are half as long as a
/// piece may be; what is left before a settled piece, or at the end, goes to the link before.
std::vector<std::size_t> link_ends(const std::vector<SpanPiece>& pieces, double longest)
{
    std::vector<std::size_t> ends;
    double length = 0.0;
    bool is_after_link = false; // of pieces that are not settled
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        length += pieces[i].length();
        const bool is_last = i + 1 == pieces.size() || pieces[i].is_settled || pieces[i + 1].is_settled;
        const bool is_long = length >= 0.5 * longest || pieces[i].is_settled;
        if (!is_long && !is_last) continue;
        if (!is_long && is_after_link) ends.back() = i + 1;
        else ends.push_back(i + 1);
        is_after_link = !is_last;
        length = 0.0;
    }
    return ends;
}

} // namespace

FoundationBeam::FoundationBeam(const Beam& beam, const SpanLoading& loading, BendingPlane plane, double curvature)
    : beam_(beam), plane_(plane), curvature_(curvature), pieces_(loading.pieces())
{
    std::size_t begin = 0;
    for (const std::size_t end : link_ends(pieces_, beam.longest_piece())) {
        const Ends of_link = ends(beam_, std::span(pieces_).subspan(begin, end - begin), plane_, curvature_);
        const Link& link = links_.emplace_back(Link{begin, end, of_link.K, of_link.fixed});
        begin = end;
        if (links_.size() == 1) {
            K_ = link.K;
            fixed_ = link.fixed;
            continue;
        }
        // Eliminate the joint between the chain so far and this link.
        const Eigen::Matrix2d middle = (K_.bottomRightCorner<2, 2>() + link.K.topLeftCorner<2, 2>()).inverse();
        const Joint joint{.G = -middle * K_.bottomLeftCorner<2, 2>(),
                          .H = -middle * link.K.topRightCorner<2, 2>(),
                          .g = -middle * (fixed_.tail<2>() + link.fixed.head<2>())};
        const Eigen::Matrix2d chain_to_joint = K_.topRightCorner<2, 2>();
        const Eigen::Matrix2d link_to_joint = link.K.bottomLeftCorner<2, 2>();
        Eigen::Matrix4d K;
        K.topLeftCorner<2, 2>() = K_.topLeftCorner<2, 2>() + chain_to_joint * joint.G;
        K.topRightCorner<2, 2>() = chain_to_joint * joint.H;
        K.bottomLeftCorner<2, 2>() = K.topRightCorner<2, 2>().transpose();
        K.bottomRightCorner<2, 2>() = link.K.bottomRightCorner<2, 2>() + link_to_joint * joint.H;
        const Eigen::Vector2d first = fixed_.head<2>() + chain_to_joint * joint.g;
        const Eigen::Vector2d last = link.fixed.tail<2>() + link_to_joint * joint.g;
        K_ = K;
        fixed_ << first, last;
        joints_.push_back(joint);
    }
    const auto& last = loading.last_jump();
    fixed_.tail<2>() -= Eigen::Vector2d(last[index(force_axis(plane))],
                                        moment_sign(plane) * last[index(moment_axis(plane))]);
}

std::vector<Beam::State> FoundationBeam::states(const Eigen::Vector4d& d) const
{
    std::vector<Eigen::Vector2d> at(links_.size() + 1);
    at.front() = d.head<2>();
    at.back() = d.tail<2>();
    for (std::size_t i = joints_.size(); i-- > 0;)
        at[i + 1] = joints_[i].G * at.front() + joints_[i].H * at[i + 2] + joints_[i].g;

    std::vector<Beam::State> states;
    for (std::size_t i = 0; i < links_.size(); ++i) {
        const Link& link = links_[i];
        Eigen::Vector4d between;
        between << at[i], at[i + 1];
        const Eigen::Vector2d near = (link.K * between + link.fixed).head<2>();
        states.push_back({.v = at[i][0], .phi = at[i][1], .V = near[0], .M = -near[1]});
        for (std::size_t k = link.begin; k + 1 < link.end; ++k) {
            const Beam::State begin = Beam::after_jump(states.back(), pieces_[k].jump, plane_);
            states.push_back(beam_.series(begin, pieces_[k], plane_, curvature_).at(pieces_[k].length()));
        }
    }
    return states;
}

} // namespace femoop
