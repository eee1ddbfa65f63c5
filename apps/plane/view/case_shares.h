#pragma once

#include <Eigen/Core>
#include <vector>

#include "femoop/plane/model/plane_model.h"

namespace plane {

/// A load case with its factor in the case that is shown.
struct CaseShare {
    const femoop::plane::PlaneLoadCase& load_case;
    double factor = 1.0;
};
/// None of a case that the model lacks.
std::vector<CaseShare> shares_of(const femoop::plane::PlaneModel& model, femoop::CaseId shown);

/// All that the case puts on a point: a file may give it several forces, a combination brings those of its cases.
struct PointForce {
    femoop::NodeId point;
    Eigen::Vector2d force = Eigen::Vector2d::Zero();
};
std::vector<PointForce> point_forces(const femoop::plane::PlaneModel& model, femoop::CaseId shown);

} // namespace plane
