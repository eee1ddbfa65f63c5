#include "femoop/element/strain_form.h"

#include <algorithm>
#include <array>

namespace femoop {

namespace {

constexpr double soft_foundation = 1e-6; // of the member: it bends 1e-9 of its motion or less within its length

StrainForm without_strain(Eigen::Index n_displacements)
{
    return {.B = Eigen::MatrixXd(0, n_displacements), .S = Eigen::MatrixXd(0, 0)};
}

StrainForm bending(const Beam& beam, double L)
{
    if (beam.EI <= 0.0) return without_strain(4);
    StrainForm form{.B = Eigen::MatrixXd(2, 4), .S = beam.chord_stiffness(L)};
    form.B << 1.0 / L, 1.0, -1.0 / L, 0.0, //
        1.0 / L, 0.0, -1.0 / L, 1.0;
    return form;
}

bool is_soft(const Beam& beam, double L)
{
    return beam.foundation * L * L * std::max(L * L, beam.EI * beam.shear_flexibility) <= soft_foundation * beam.EI;
}

/// v at x = xi L per unit of each of the four strains, of the beam without its foundation.
Eigen::Vector4d deflections(Beam beam, double L, double xi)
{
    beam.foundation = 0.0;
    const Eigen::Matrix4d K = beam.stiffness(L);
    const auto deflection = [&](double phi, int column) {
        return beam.at(xi * L, {.phi = phi, .V = K(0, column), .M = -K(1, column)}, {}, BendingPlane::xy, 0.0).v;
    };
    return {deflection(1.0, 1), deflection(0.0, 3), L * (1.0 - xi), L * xi};
}

/// Integral of k N' N over the length: what the stiffness of a whole beam would drown in its own rounding.
Eigen::Matrix4d soft_support(const Beam& beam, double L)
{
    constexpr std::array<double, 2> places{0.339981043584856265, 0.861136311594052575}; // Gauss, exact for cubic v
    constexpr std::array<double, 2> weights{0.652145154862546143, 0.347854845137453857};
    Eigen::Matrix4d S = Eigen::Matrix4d::Zero();
    for (std::size_t i = 0; i < places.size(); ++i)
        for (const double sign : {-1.0, 1.0}) {
            const Eigen::Vector4d N = deflections(beam, L, 0.5 * (1.0 + sign * places[i]));
            S += 0.5 * L * beam.foundation * weights[i] * N * N.transpose();
        }
    return S;
}

Eigen::Matrix4d firm_support(const Beam& beam, double L, BendingPlane plane)
{
    SpanLoading pieces;
    pieces.assign(L, {}, beam.longest_piece(), beam.settling());
    const Eigen::Matrix4d k = FoundationBeam(beam, pieces, plane, 0.0).stiffness();
    Eigen::Matrix4d displacement;     // d from (phi1 - psi, phi2 - psi, v1 / L, v2 / L)
    displacement << 0.0, 0.0, L, 0.0, //
        1.0, 0.0, -1.0, 1.0,          //
        0.0, 0.0, 0.0, L,             //
        0.0, 1.0, -1.0, 1.0;
    return displacement.transpose() * k * displacement;
}

} // namespace

StrainForm strain_form(const Bar& bar, double L)
{
    if (bar.EA <= 0.0) return without_strain(2);
    return {.B = Eigen::RowVector2d(-1.0, 1.0), .S = Eigen::MatrixXd::Constant(1, 1, 1.0 / bar.flexibility(L))};
}

StrainForm strain_form(const Beam& beam, double L, BendingPlane plane)
{
    if (beam.foundation <= 0.0) return bending(beam, L);
    const StrainForm bent = bending(beam, L);
    StrainForm form{.B = Eigen::MatrixXd::Zero(4, 4), .S = Eigen::MatrixXd::Zero(4, 4)};
    form.B.topRows<2>() = bent.B;
    form.B(2, 0) = form.B(3, 2) = 1.0 / L;
    if (is_soft(beam, L)) {
        form.S.topLeftCorner<2, 2>() = bent.S;
        form.S += soft_support(beam, L);
    } else form.S = firm_support(beam, L, plane);
    return form;
}

} // namespace femoop
