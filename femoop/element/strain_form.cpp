#include "femoop/element/strain_form.h"

namespace femoop {

namespace {

constexpr double negligible_foundation = 1e-14; // of the bending stiffness: below it only rounding is left

StrainForm without_strain(Eigen::Index n_displacements)
{
    return {.B = Eigen::MatrixXd(0, n_displacements), .S = Eigen::MatrixXd(0, 0)};
}

StrainForm bending(const Beam& beam, double L)
{
    if (beam.EI <= 0.0) return without_strain(4);
    const double shear = 12.0 * beam.EI * beam.shear_flexibility / (L * L);
    const double k = beam.EI / (L * (1.0 + shear));
    StrainForm form{.B = Eigen::MatrixXd(2, 4), .S = Eigen::MatrixXd(2, 2)};
    form.B << 1.0 / L, 1.0, -1.0 / L, 0.0, //
        1.0 / L, 0.0, -1.0 / L, 1.0;
    form.S << 4.0 + shear, 2.0 - shear, //
        2.0 - shear, 4.0 + shear;
    form.S *= k;
    return form;
}

} // namespace

StrainForm strain_form(const Bar& bar, double L)
{
    if (bar.EA <= 0.0) return without_strain(2);
    return {.B = Eigen::RowVector2d(-1.0, 1.0), .S = Eigen::MatrixXd::Constant(1, 1, bar.EA / L)};
}

StrainForm strain_form(const Beam& beam, double L, BendingPlane plane)
{
    if (beam.foundation <= 0.0) return bending(beam, L);
    SpanLoading pieces;
    pieces.assign(L, {}, beam.longest_piece(), beam.settling());
    const Eigen::Matrix4d k = FoundationBeam(beam, pieces, plane, 0.0).stiffness();
    Eigen::Matrix4d displacement;     // d from (phi1 - psi, phi2 - psi, v1 / L, v2 / L)
    displacement << 0.0, 0.0, L, 0.0, //
        1.0, 0.0, -1.0, 1.0,          //
        0.0, 0.0, 0.0, L,             //
        0.0, 1.0, -1.0, 1.0;
    StrainForm form{.B = Eigen::MatrixXd::Zero(4, 4), .S = displacement.transpose() * k * displacement};
    if (form.S.diagonal().tail<2>().minCoeff() <= negligible_foundation * form.S(0, 0)) return bending(beam, L);
    form.B.topRows<2>() = bending(beam, L).B;
    form.B(2, 0) = form.B(3, 2) = 1.0 / L;
    return form;
}

} // namespace femoop
