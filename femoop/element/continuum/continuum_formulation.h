#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "femoop/element/continuum/element_geometry.h"
#include "femoop/material/constitutive_model.h"
#include "femoop/rule/integration_rule.h"
#include "femoop/shape/shape.h"

namespace femoop {

/// A shape's functions at a point of a rule, with the point's weight.
struct ShapeAtPoint {
    NaturalPoint at;
    Shape::Values N;
    Shape::Derivatives dN;
    double weight = 0.0;
};

std::vector<ShapeAtPoint> tabulated(const Shape& shape, const IntegrationRule& rule);

/// The rule that is usual for a shape: T3 1 point, T6 3, Q4 2 x 2, Q8 and Q9 3 x 3; axisymmetric T3 3 points, T6 6,
/// because of the radius in every integral.
IntegrationRule standard_rule(ShapeKind shape, StressState state);

/// The check of each shape's elements with their usual rule, made when it is first asked for.
class GeometryChecks {
public:
    explicit GeometryChecks(StressState state) : state_(state) {}
    const GeometryCheck& of(ShapeKind shape);
    const GeometryCheck& known(ShapeKind shape) const { return checks_.at(shape); } ///< \pre asked for before

private:
    StressState state_;
    std::map<ShapeKind, GeometryCheck> checks_;
};

/// What an element does about the modes that its shape lacks.
enum class ElementVariant : std::uint8_t {
    Standard,
    /// Q4 whose dilatation is the mean one of the element, a third of it in each of ex, ey, ez: it does not lock where
    /// the material keeps its volume. Not in plane stress. Source [Hughes2000, ch. 4]: B-bar
    MeanDilatation,
    /// Q4 with the modes 1 - xi^2 and 1 - eta^2 of its own, their derivatives by the Jacobian J0 of its centre times
    /// det J0 / det J: it bends without locking, and passes the patch test. Not axisymmetric.
    /// Source [ZienkiewiczTaylor2000, ch. 10]
    IncompatibleModes
};

/// What the continuum elements of one region have in common: the factors that they are composed of. The analysis model
/// is that of the material's stress state (ContinuumModel).
class ContinuumFormulation {
public:
    /// \pre shape and material outlive this; the rule is one of the shape's domain; thickness > 0 (axisymmetric: not
    /// used).  \throws std::invalid_argument otherwise, or for a solid's stress state or a variant that there is not
    /// \param density  mass / volume
    ContinuumFormulation(const Shape& shape, IntegrationRule rule, const ConstitutiveModel& material,
                         double thickness = 1.0, ElementVariant variant = ElementVariant::Standard,
                         double density = 0.0);

    const Shape& shape() const { return shape_; }
    const IntegrationRule& rule() const { return rule_; }
    const ConstitutiveModel& material() const { return material_; }
    StressState state() const { return material_.state(); }
    double thickness() const { return thickness_; }
    ElementVariant variant() const { return variant_; }
    double density() const { return density_; }

    const GeometryCheck& geometry_check() const { return geometry_check_; }
    const std::vector<ShapeAtPoint>& points() const { return points_; } ///< of the rule, for stiffness
    /// Of rules that integrate loads of degree 4, and mass, on straight-sided elements exactly: inside, and of its shape
    /// on an edge.
    const std::vector<ShapeAtPoint>& load_points() const { return load_points_; }
    const std::vector<ShapeAtPoint>& edge_points() const { return edge_points_; }

private:
    const Shape& shape_;
    const ConstitutiveModel& material_;
    IntegrationRule rule_;
    double thickness_;
    ElementVariant variant_;
    double density_;
    GeometryCheck geometry_check_;
    std::vector<ShapeAtPoint> points_, load_points_, edge_points_;
};

} // namespace femoop
