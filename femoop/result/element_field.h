#pragma once

#include <Eigen/Core>
#include <span>

#include "femoop/element/continuum/continuum_element.h"
#include "femoop/element/element.h"
#include "femoop/material/constitutive_model.h"
#include "femoop/shape/natural_point.h"

namespace femoop {

/// What an element that is no member does inside: what its curve is to a member.
///
///      u(p) = sum N_i u_i        strain = B u        stress = D strain
///
/// Signs    those of ContinuumElement
/// Accuracy displacements are continuous from element to element; stresses jump there, and are best at the
///          integration points
/// Source   [ZienkiewiczTaylor2000, ch. 8, 14]
class ElementField {
public:
    /// \param displacements  of all nodes, those of each after one another in the order of the element's dofs.
    /// \pre the element outlives this
    /// \param heat  that the element is warmed by; it lives as long as this
    ElementField(const ContinuumElement& element, std::span<const double> displacements,
                 ContinuumElement::Heat heat = {});

    Eigen::Vector2d place(NaturalPoint p) const { return element_.place(p); }
    Eigen::Vector2d displacement(NaturalPoint p) const;
    StrainVector strain(NaturalPoint p) const { return element_.total_strain(u_, p, heat_); } ///< that of heat too
    ContinuumElement::StrainColumns strains(std::span<const ShapeAtPoint> points) const ///< the same, a column each
    {
        return element_.total_strains(u_, points, heat_);
    }
    StrainVector thermal_strain(NaturalPoint p) const { return element_.thermal_strain(p, heat_); }
    bool is_warmed() const { return !heat_.empty(); }
    StrainVector mechanical_strain(NaturalPoint p) const { return element_.mechanical_strain(u_, p, heat_); }
    StressVector stress(NaturalPoint p) const { return element_.stress(u_, p, heat_); }

    const ContinuumElement& element() const { return element_; }
    const ElementVector& node_displacements() const { return u_; } ///< in the order of the element's dofs

private:
    const ContinuumElement& element_;
    ElementVector u_;
    ContinuumElement::Heat heat_;
};

} // namespace femoop
