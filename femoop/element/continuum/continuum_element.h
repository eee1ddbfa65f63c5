#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>

#include "femoop/element/continuum/continuum_formulation.h"
#include "femoop/element/continuum/continuum_load.h"
#include "femoop/element/element.h"
#include "femoop/shape/natural_point.h"

namespace femoop {

/// A piece of a plane or axisymmetric body, composed of a Shape, an IntegrationRule, a ConstitutiveModel and an
/// analysis model (ContinuumModel). Geometry and displacements have the same functions: it is isoparametric.
///
///      y ^    4---7---3
///        |   /       /        u = (ux, uy of node 1, ux, uy of node 2, ...)
///        |  8       6
///        | /       /          K = sum over points of B' D B  weight  det J  depth
///        |1---5---2
///        +-----------> x      axisymmetric: x is the radius, y the axis
///
/// Signs    tension positive; txy acts along +y on the face +x. Axisymmetric forces are of the whole turn
/// Units    any consistent set
/// Assumes  small displacements
/// Accuracy fields up to the shape's degree p are exact (Shape::degree); where the solution is smooth, the error in
///          energy falls with the size of elements to the power p
/// Source   [MarthaParente2002]; [ZienkiewiczTaylor2000, ch. 8-9]; errors [Hughes2000]
class ContinuumElement : public Element {
public:
    using Heat = std::span<const ThermalLoad>;
    static constexpr int max_strain_points = 9;
    using StrainColumns =
        Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, n_stress_components, max_strain_points>;

    /// M = integral of density N' N over the volume.
    void mass(ElementMatrix& M) const override;

    virtual Eigen::Vector2d place(NaturalPoint p) const = 0;
    /// The volume that a natural area of 1 has at a place: det J x depth.
    virtual double volume(NaturalPoint p) const = 0;

    /// From the element's displacements, in the order of its degrees of freedom.
    StrainVector strain(const ElementVector& u, NaturalPoint p) const { return total_strain(u, p, {}); }
    /// The same where it is warmed too: heat moves the modes of IncompatibleModes.
    StrainVector total_strain(const ElementVector& u, NaturalPoint p, Heat heat) const;
    /// At several points of its shape, a column each. \pre at most max_strain_points
    virtual StrainColumns total_strains(const ElementVector& u, std::span<const ShapeAtPoint> points,
                                        Heat heat) const = 0;
    /// What stresses follow from: the total strain without that of heat.
    StrainVector mechanical_strain(const ElementVector& u, NaturalPoint p, Heat heat) const;
    StrainVector thermal_strain(NaturalPoint p, Heat heat) const; ///< what heat alone would make of it there
    StressVector stress(const ElementVector& u, NaturalPoint p, Heat heat = {}) const
    {
        return formulation_.material().stress({.strain = mechanical_strain(u, p, heat)});
    }

    const ContinuumFormulation& formulation() const { return formulation_; }

protected:
    ContinuumElement(const ContinuumFormulation& formulation, std::uint32_t stiffness_group)
        : Element(stiffness_group), formulation_(formulation)
    {}

private:
    const ContinuumFormulation& formulation_;
};

/// Elements of one analysis, one after the other in memory.
class ContinuumBlock {
public:
    virtual ~ContinuumBlock() = default;
    virtual std::size_t size() const = 0;
    virtual const ContinuumElement& operator[](std::size_t i) const = 0;
};

/// What an element of a block is made of; what it points to outlives the block.
struct ContinuumRow {
    const ContinuumFormulation& formulation;
    std::span<const NodeId> nodes;
    std::uint32_t stiffness_group = 0;
};

/// Calls add(row) for each of the elements begin .. end - 1, in order.
using ContinuumRows =
    std::function<void(std::size_t begin, std::size_t end, const std::function<void(const ContinuumRow&)>& add)>;

/// `n` elements in the stress state of their formulations. Ranges of them are asked for at the same time.
/// \pre formulations and positions outlive the block
/// \throws std::invalid_argument with the sentence of why_not_element
std::unique_ptr<const ContinuumBlock> make_continuum_elements(StressState state, std::size_t n,
                                                              std::span<const Eigen::Vector2d> positions,
                                                              const ContinuumRows& rows);

/// An element between nodes. `positions` are of all nodes, by their ids.
/// \pre formulation and positions outlive the element
/// \throws std::invalid_argument with the sentence of why_not_element
std::unique_ptr<ContinuumElement> make_continuum_element(const ContinuumFormulation& formulation,
                                                         std::span<const NodeId> nodes,
                                                         std::span<const Eigen::Vector2d> positions,
                                                         std::uint32_t stiffness_group = 0);

} // namespace femoop
