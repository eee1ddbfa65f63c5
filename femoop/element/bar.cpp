#include "femoop/element/bar.h"

#include <cmath>

#include "femoop/element/polynomial_product.h"

namespace femoop {

double Bar::flexibility(double L) const { return (taper == 0.0 ? L : std::log1p(taper * L) / taper) / EA; }

Eigen::Matrix2d Bar::stiffness(double L) const
{
    const double k = 1.0 / flexibility(L);
    Eigen::Matrix2d K;
    K << k, -k, -k, k;
    return K;
}

Bar::Series Bar::series(const State& begin, const SpanPiece& piece, LocalAxis axis, double strain) const
{
    const std::size_t a = index(axis);
    const double N0 = begin.N;
    const double q = piece.value[a];
    const double dq = piece.slope[a];
    if (taper != 0.0) return tapered_series(begin, piece, {N0, -q, -0.5 * dq}, strain);
    return {.u = {begin.u, N0 / EA + strain, -q / (2.0 * EA), -dq / (6.0 * EA)}, .N = {N0, -q, -0.5 * dq}};
}

// u' = N / EA(x) + strain, power by power: the coefficient n + 1 of u is that of its derivative over n + 1.
Bar::Series Bar::tapered_series(const State& begin, const SpanPiece& piece, const Polynomial& N, double strain) const
{
    const Polynomial flexibility = Polynomial{EA * (1.0 + taper * piece.begin), EA * taper}.reciprocal();
    Series s{.u = {begin.u}, .N = N};
    for (std::size_t n = 0; n + 1 < Polynomial::max_terms; ++n) {
        const double du = (n == 0 ? strain : 0.0) + product_coefficient(N, flexibility, n);
        s.u.append(du / static_cast<double>(n + 1));
    }
    return s;
}

Bar::State Bar::at(double t, const State& begin, const SpanPiece& piece, LocalAxis axis, double strain) const
{
    if (taper != 0.0) {
        const Series s = series(begin, piece, axis, strain);
        return {.u = s.u(t), .N = s.N(t)};
    }
    const double q = piece.value[index(axis)], dq = piece.slope[index(axis)];
    return {.u = begin.u + t * (strain + (begin.N - t * (0.5 * q + t * dq / 6.0)) / EA),
            .N = force_at(t, begin, piece, axis)};
}

Eigen::Vector2d Bar::fixed_end_forces(const SpanLoading& loading, LocalAxis axis) const
{
    State state; // of the bar with its first end held and its second end free of the unknown force
    for (const SpanPiece& piece : loading.pieces()) {
        state.N -= piece.jump[index(axis)];
        const double strain = axis == LocalAxis::x ? loading.strain() : 0.0;
        state = at(piece.length(), state, piece, axis, strain);
    }
    const double last = loading.last_jump()[index(axis)];
    const double N0 = -state.u / flexibility(loading.length()); // brings the second end back to zero
    return {-N0, N0 + state.N - last};
}

} // namespace femoop
