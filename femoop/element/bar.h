#pragma once

#include <Eigen/Core>

#include "femoop/element/polynomial.h"
#include "femoop/element/span_load.h"

namespace femoop {

/// A bar that carries force along its axis, prismatic or tapered, or a shaft that carries torque about it.
///
///      F1 --> o====================o --> F2      d = (u1, u2); as a shaft rotations about x', torques
///             |<------- L -------->|
///
///      N' = -q        u' = N / EA + strain        N(0) = -F1, N(L) = F2
///
/// Signs    N tension positive, q and F along +x'; T and mx as vectors along +x'
/// Units    any consistent set
/// Assumes  small displacements, plane sections; Saint-Venant torsion without warping
/// Accuracy exact for span loads that vary linearly; along a taper to the last bits of a power series
struct Bar {
    struct State {
        double u = 0.0; ///< displacement
        double N = 0.0; ///< section force
    };
    struct Series {
        Polynomial u, N;
    };

    double EA = 0.0;    ///< or GJ
    double taper = 0.0; ///< EA(x) = EA (1 + taper x) [1/length]

    /// How much longer a unit force makes it: the integral of 1 / EA over the length.
    double flexibility(double L) const;
    Eigen::Matrix2d stiffness(double L) const;

    /// Forces [2] on the clamped ends' side of the bar: what the ends do to it while they hold still.
    Eigen::Vector2d fixed_end_forces(const SpanLoading& loading, LocalAxis axis) const;

    /// Over one piece, t measured from its beginning, after the jump there: at one place, and as closed forms.
    double force_at(double t, const State& begin, const SpanPiece& piece, LocalAxis axis) const
    {
        return begin.N - t * (piece.value[index(axis)] + 0.5 * t * piece.slope[index(axis)]);
    }
    State at(double t, const State& begin, const SpanPiece& piece, LocalAxis axis, double strain) const;
    Series series(const State& begin, const SpanPiece& piece, LocalAxis axis, double strain) const;

private:
    Series tapered_series(const State& begin, const SpanPiece& piece, const Polynomial& N, double strain) const;
};

} // namespace femoop
