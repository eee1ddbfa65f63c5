#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "femoop/element/polynomial.h"
#include "femoop/element/span_load.h"
#include "femoop/element/taper.h"

namespace femoop {

/// The plane that a beam bends in. In x'z' the same equations hold for w, the slope -ry, Vz and My.
enum class BendingPlane : std::uint8_t { xy, xz };

constexpr LocalAxis force_axis(BendingPlane plane) { return plane == BendingPlane::xy ? LocalAxis::y : LocalAxis::z; }
constexpr LocalAxis moment_axis(BendingPlane plane)
{
    return plane == BendingPlane::xy ? LocalAxis::rz : LocalAxis::ry;
}
/// Turns a moment or rotation about the member's axis into one of the plane, counter-clockwise from x' to y' or z'.
constexpr double moment_sign(BendingPlane plane) { return plane == BendingPlane::xy ? 1.0 : -1.0; }

/// A beam in one plane: Euler-Bernoulli or Timoshenko, either on a Winkler foundation or tapered.
///
///    y' ^     q [force/length], positive along +y'
///       |   ||||||||||||||||||||
///       1 o--------------------o 2 --> x'    d = (v1, phi1, v2, phi2), phi positive counter-clockwise
///         |<------- L -------->|             F = (F1, m1, F2, m2) along d, acting on the beam
///
///      V' = q - k v       phi' = M / EI + curvature
///      M' = V - m         v'   = phi - V / GAs
///
/// Signs    V positive along -y' on the face looking along +x', M positive when it stretches the -y' fibre:
///          F1 = V(0), m1 = -M(0), F2 = -V(L), m2 = M(L)
/// Units    any consistent set; rotations in rad
/// Assumes  small displacements, straight axis, foundation pulls as well as it pushes; no taper on a foundation
/// Accuracy exact for span loads that vary linearly; on a foundation and along a taper to the last bits of a power
///          series
/// Source   [Timoshenko1921] for the shear term, [Hetenyi1946, ch. 1] for the foundation
struct Beam {
    struct State {
        double v = 0.0, phi = 0.0, V = 0.0, M = 0.0;
    };
    struct Series {
        Polynomial v, phi, V, M;
        State at(double t) const { return {.v = v(t), .phi = phi(t), .V = V(t), .M = M(t)}; }
    };

    double EI = 0.0;                ///< of a tapered one at its first end, like 1 / GAs
    double shear_flexibility = 0.0; ///< 1 / GAs; 0 for an Euler-Bernoulli beam
    double foundation = 0.0;        ///< k [force/length^2]
    Taper taper{};

    /// Stiffness [4x4] of d, symmetric, rank 2. \pre foundation == 0 (else FoundationBeam)
    Eigen::Matrix4d stiffness(double L) const;

    /// Moments [2] on the ends per rotation of each against the chord, (phi1 - psi, phi2 - psi), psi = (v2 - v1) / L.
    /// \pre foundation == 0
    Eigen::Matrix2d chord_stiffness(double L) const;

    /// Forces [4] that hold both ends still under the loads. \pre foundation == 0 (else FoundationBeam)
    Eigen::Vector4d fixed_end_forces(const SpanLoading& loading, BendingPlane plane) const;

    /// Forces (F1, F2) that hold the ends of a simply supported span: statics alone, whatever its stiffness.
    static Eigen::Vector2d simple_span_forces(const SpanLoading& loading, BendingPlane plane);

    /// Closed forms over one piece, t measured from its beginning, from the state after the jump there. An imposed
    /// `curvature` is that at the first end: along a taper, as of a temperature's gradient, curvature h(0) / h(x).
    Series series(const State& begin, const SpanPiece& piece, BendingPlane plane, double curvature) const;

    /// The same at one place of the piece, straight from the state at its beginning.
    State at(double t, const State& begin, const SpanPiece& piece, BendingPlane plane, double curvature) const;

    /// Section forces alone, where displacements are not asked for.
    struct Forces {
        double V = 0.0, M = 0.0;
    };
    Forces forces_at(double t, const State& begin, const SpanPiece& piece, BendingPlane plane, double curvature) const
    {
        if (foundation > 0.0) {
            const State s = at(t, begin, piece, plane, curvature);
            return {.V = s.V, .M = s.M};
        }
        const std::size_t force = index(force_axis(plane)), moment = index(moment_axis(plane));
        const double q = piece.value[force], dq = piece.slope[force];
        const double m = moment_sign(plane) * piece.value[moment], dm = moment_sign(plane) * piece.slope[moment];
        return {.V = begin.V + t * (q + 0.5 * t * dq),
                .M = begin.M + t * (begin.V - m + t * (0.5 * (q - dm) + t * dq / 6.0))};
    }

    /// The state after the point loads at the beginning of a piece.
    static State after_jump(State before, const std::array<double, n_local_axes>& jump, BendingPlane plane);

    /// Pieces up to this length keep the series short and exact; infinite without a foundation or a taper.
    double longest_piece() const;

    /// What happens at a place is felt no further on than this; infinite without a foundation.
    double settling() const;

    /// A member's loads in the pieces that this beam is solved over.
    void cut(SpanLoading& loading, double L, std::span<const SpanLoading::Scaled> terms) const
    {
        loading.assign(L, terms, longest_piece(), settling());
    }

    /// On a stiffer one a member of this length has more pieces, or shorter ones, than arithmetic bears.
    double stiffest_foundation(double L) const;

private:
    Series settled(const SpanPiece& piece, BendingPlane plane, double curvature) const;
    Series tapered_series(const State& begin, const SpanPiece& piece, BendingPlane plane, double curvature) const;
    Polynomial bending_flexibility(double x) const;  ///< 1 / EI(x + t)
    Polynomial shearing_flexibility(double x) const; ///< 1 / GAs(x + t)
    Eigen::Matrix2d tapered_chord_stiffness(double L) const;
};

/// A beam on a Winkler foundation, joined from pieces that the series can carry: each piece is exact, so the
/// chain is one exact member however long it is against the foundation's characteristic length. Far from ends and
/// loads nothing is left but the particular solution, linear in x: one piece, with half-infinite beams at its ends.
class FoundationBeam {
public:
    FoundationBeam(const Beam& beam, const SpanLoading& loading, BendingPlane plane, double curvature);

    const Eigen::Matrix4d& stiffness() const { return K_; }            ///< of d = (v1, phi1, v2, phi2)
    const Eigen::Vector4d& fixed_end_forces() const { return fixed_; } ///< hold both ends still
    std::vector<Beam::State> states(
        const Eigen::Vector4d& d) const; ///< at the beginning of each piece, before its jump

private:
    /// Pieces that follow one another, long enough together to be a beam between two joints: of a shorter one the forces
    /// would drown in the rounding of what its ends do.
    struct Link {
        std::size_t begin, end; ///< of pieces
        Eigen::Matrix4d K;
        Eigen::Vector4d fixed;
    };
    /// A joint between two links, as a function of the first end and of the next joint: d = G d1 + H next + g.
    struct Joint {
        Eigen::Matrix2d G, H;
        Eigen::Vector2d g;
    };
    Beam beam_;
    BendingPlane plane_;
    double curvature_;
    std::vector<SpanPiece> pieces_;
    std::vector<Link> links_;
    std::vector<Joint> joints_;
    Eigen::Matrix4d K_;
    Eigen::Vector4d fixed_;
};

} // namespace femoop
