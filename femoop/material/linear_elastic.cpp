#include "femoop/material/linear_elastic.h"

#include <cmath>
#include <sstream>
#include <stdexcept>

namespace femoop {

namespace {

TangentMatrix sheet_stiffness(double E, double nu)
{
    const double c = E / (1.0 - nu * nu);
    TangentMatrix D(3, 3);
    D << c, c * nu, 0.0, //
        c * nu, c, 0.0,  //
        0.0, 0.0, 0.5 * E / (1.0 + nu);
    return D;
}

TangentMatrix body_stiffness(double E, double nu, int n)
{
    const double G = 0.5 * E / (1.0 + nu), lambda = 2.0 * G * nu / (1.0 - 2.0 * nu);
    TangentMatrix D = TangentMatrix::Zero(n, n);
    D.topLeftCorner(3, 3).setConstant(lambda);
    for (int i = 0; i < n; ++i) D(i, i) += i < 3 ? 2.0 * G : G;
    return D;
}

TangentMatrix stiffness_of(const ElasticConstants& constants, StressState state)
{
    if (const std::optional<ElasticFault> fault = why_not_elastic(constants, state))
        throw std::invalid_argument(message(*fault));
    return state == StressState::PlaneStress ? sheet_stiffness(constants.E, constants.nu)
                                             : body_stiffness(constants.E, constants.nu, n_components(state));
}

} // namespace

std::optional<ElasticFault> why_not_elastic(const ElasticConstants& constants, StressState state)
{
    const auto [E, nu, alpha] = constants;
    if (!(E > 0.0 && std::isfinite(E))) return ElasticFault{.flaw = ElasticFlaw::ModulusNotPositive, .value = E};
    if (!(nu > -1.0 && nu <= 0.5)) return ElasticFault{.flaw = ElasticFlaw::RatioOutOfRange, .value = nu};
    if (nu == 0.5 && state != StressState::PlaneStress)
        return ElasticFault{.flaw = ElasticFlaw::Incompressible, .value = nu};
    return std::nullopt;
}

std::string message(const ElasticFault& fault)
{
    std::ostringstream text;
    switch (fault.flaw) {
    case ElasticFlaw::ModulusNotPositive: text << "E is " << fault.value << ", which is not a positive stress"; break;
    case ElasticFlaw::RatioOutOfRange:
        text << "nu is " << fault.value << ", which is not above -1 and at most 0.5";
        break;
    case ElasticFlaw::Incompressible:
        text << "nu is " << fault.value
             << ": the body keeps its volume, so that strains do not tell its mean stress; take nu below 0.5 or plane "
                "stress";
        break;
    }
    return text.str();
}

LinearElastic::LinearElastic(const ElasticConstants& constants, StressState state)
    : ConstitutiveModel(state), D_(stiffness_of(constants, state)), alpha_(constants.alpha)
{}

StrainVector LinearElastic::thermal_strain(double rise) const
{
    StrainVector strain = StrainVector::Zero(n_components(state()));
    strain.head(state() == StressState::PlaneStress ? 2 : 3).setConstant(alpha_ * rise);
    return strain;
}

} // namespace femoop
