#pragma once

#include <vector>

#include "femoop/material/constitutive_model.h"
#include "femoop/rule/integration_rule.h"
#include "femoop/shape/shape.h"

namespace femoop {

/// A shape's functions at a point of a rule, with the point's weight.
struct ShapeAtPoint {
    Shape::Values N;
    Shape::Derivatives dN;
    double weight = 0.0;
};

std::vector<ShapeAtPoint> tabulated(const Shape& shape, const IntegrationRule& rule);

/// The rule that is usual for a shape: T3 1 point, T6 3, Q4 2 x 2, Q8 and Q9 3 x 3; axisymmetric T3 3 points, T6 6,
/// because of the radius in every integral.
IntegrationRule standard_rule(ShapeKind shape, StressState state);

/// What the continuum elements of one region have in common: the factors that they are composed of. The analysis model
/// is that of the material's stress state (ContinuumModel).
class ContinuumFormulation {
public:
    /// \pre shape and material outlive this; the rule is one of the shape's domain; thickness > 0 (axisymmetric: not
    /// used).  \throws std::invalid_argument otherwise, or for a solid's stress state
    ContinuumFormulation(const Shape& shape, IntegrationRule rule, const ConstitutiveModel& material,
                         double thickness = 1.0);

    const Shape& shape() const { return shape_; }
    const IntegrationRule& rule() const { return rule_; }
    const ConstitutiveModel& material() const { return material_; }
    StressState state() const { return material_.state(); }
    double thickness() const { return thickness_; }

    const std::vector<ShapeAtPoint>& points() const { return points_; } ///< of the rule, for stiffness
    /// Of rules that integrate loads of degree 4 on straight-sided elements exactly: inside, and of its shape on an
    /// edge.
    const std::vector<ShapeAtPoint>& load_points() const { return load_points_; }
    const std::vector<ShapeAtPoint>& edge_points() const { return edge_points_; }

private:
    const Shape& shape_;
    const ConstitutiveModel& material_;
    IntegrationRule rule_;
    double thickness_;
    std::vector<ShapeAtPoint> points_, load_points_, edge_points_;
};

} // namespace femoop
