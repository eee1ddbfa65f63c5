#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "femoop/material/constitutive_model.h"

namespace femoop {

struct ElasticConstants {
    double E = 0.0;     ///< Young's modulus
    double nu = 0.0;    ///< Poisson's ratio
    double alpha = 0.0; ///< thermal expansion [1/K]
};

/// What is wrong with elastic constants.
enum class ElasticFlaw : std::uint8_t {
    ModulusNotPositive, ///< E is zero, negative or not finite
    RatioOutOfRange,    ///< nu is not within -1 < nu <= 0.5
    Incompressible      ///< nu = 0.5 leaves the mean stress unknown unless sz = 0
};

struct ElasticFault {
    ElasticFlaw flaw = ElasticFlaw::ModulusNotPositive;
    double value = 0.0; ///< that was found
};

/// Why a linear elastic body cannot have these constants; nothing if it can.
std::optional<ElasticFault> why_not_elastic(const ElasticConstants& constants, StressState state);

std::string message(const ElasticFault& fault); ///< English: `nu is 0.5: the body keeps its volume ...`

/// Hooke's law of an isotropic body: s = D e.
///
///      sx = 2 G ex + lambda (ex + ey + ez)     G = E / (2 (1 + nu))     lambda = 2 G nu / (1 - 2 nu)
///      txy = G gxy                             plane stress: sx = E (ex + nu ey) / (1 - nu^2)
///
/// Signs    tension and elongation positive
/// Units    any consistent set
/// Assumes  small strains
/// Source   [TimoshenkoGoodier1970, ch. 1-2]
class LinearElastic final : public ConstitutiveModel {
public:
    /// \throws std::invalid_argument with the sentence of why_not_elastic
    LinearElastic(const ElasticConstants& constants, StressState state);

    StressVector stress(const MaterialPoint& point) const override { return D_.lazyProduct(point.strain); }
    TangentMatrix tangent(const MaterialPoint&) const override { return D_; }
    StrainVector thermal_strain(double rise) const override;

private:
    TangentMatrix D_;
    double alpha_;
};

} // namespace femoop
