#pragma once

#include <Eigen/Core>

#include "femoop/material/stress_state.h"

namespace femoop {

/// Components of a stress or a strain, in the order of its state; without a heap.
using StressVector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, n_stress_components, 1>;
using StrainVector = StressVector;
using TangentMatrix =
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, n_stress_components, n_stress_components>;

/// What has come to a point of a body. What a material with a memory must know joins here.
struct MaterialPoint {
    StrainVector strain; ///< that the stress follows: without thermal strain
};

/// How a material answers strain with stress, in one stress state.
///
/// Source  [MarthaParente2002]: the class ConstitutiveModel
class ConstitutiveModel {
public:
    virtual ~ConstitutiveModel() = default;
    ConstitutiveModel(const ConstitutiveModel&) = delete;
    ConstitutiveModel& operator=(const ConstitutiveModel&) = delete;

    StressState state() const { return state_; }

    virtual StressVector stress(const MaterialPoint& point) const = 0;
    virtual TangentMatrix tangent(const MaterialPoint& point) const = 0; ///< d stress / d strain
    virtual StrainVector thermal_strain(double rise) const = 0;          ///< of a free body, warmer by `rise`

protected:
    explicit ConstitutiveModel(StressState state) : state_(state) {}

private:
    StressState state_;
};

} // namespace femoop
