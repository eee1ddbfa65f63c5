#include "femoop/element/bar.h"

namespace femoop {

Eigen::Matrix2d Bar::stiffness(double L) const
{
    const double k = EA / L;
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
    return {.u = {begin.u, N0 / EA + strain, -q / (2.0 * EA), -dq / (6.0 * EA)}, .N = {N0, -q, -0.5 * dq}};
}

Bar::State Bar::at(double t, const State& begin, const SpanPiece& piece, LocalAxis axis, double strain) const
{
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
    const double N0 = -state.u * EA / loading.length(); // brings the second end back to zero
    return {-N0, N0 + state.N - last};
}

} // namespace femoop
