#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <span>

#include "femoop/element/element_loads.h"
#include "femoop/model/dof.h"
#include "femoop/model/ids.h"
#include "femoop/solver/double_double.h"

namespace femoop {

inline constexpr int max_element_dofs = 64;

/// An element's matrices: of any size up to max_element_dofs, without a heap. Used again from element to element.
using ElementMatrix =
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, max_element_dofs, max_element_dofs>;
using ElementVector = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, max_element_dofs, 1>;

/// The degrees of freedom that an element touches, in the order of its matrices' rows:
///
///      u = (node 1: its dofs, node 2: its dofs, ..., own dofs)
struct ElementDofs {
    std::span<const NodeId> nodes;
    std::span<const Dof> of_each_node; ///< the same for all of its nodes
    std::size_t n_own = 0;             ///< that no other element touches, such as a member's ends behind releases

    std::size_t n_of_nodes() const { return nodes.size() * of_each_node.size(); }
    std::size_t size() const { return n_of_nodes() + n_own; }
};

/// A part of a structure between its nodes: which degrees of freedom it touches, and what it contributes to the
/// equations there. It knows neither the equations' numbers nor supports, nor what is done with its matrices.
///
///      forces of the nodes on the element = K u - f       f replaces the loads on it
///
/// Each pass over a structure makes one virtual call per element. Inside, an element works with matrices of fixed
/// size and assigns the last one:
///
///     void stiffness(ElementMatrix& K) const override
///     {
///         Eigen::Matrix<double, 8, 8> sum = ...;
///         K = sum; // takes the size of what is assigned
///     }
///
/// Signs    displacements and forces along the global axes; a rotation and its moment by the right-hand rule
/// Units    any consistent set; rotations in rad
/// Assumes  small displacements, linear elasticity
/// Source   [MarthaParente2002]: the class Element
class Element {
public:
    virtual ~Element() = default;
    Element() = default;
    Element(const Element&) = default;
    Element(Element&&) = default;
    Element& operator=(const Element&) = default;
    Element& operator=(Element&&) = default;

    virtual ElementDofs dofs() const = 0; ///< valid while the element lives

    /// K [dofs x dofs], symmetric, positive semidefinite; along global axes.
    virtual void stiffness(ElementMatrix& K) const = 0;

    /// The same to 32 digits where an element has them; rounded to doubles where it does not say better.
    virtual PreciseMatrix precise_stiffness() const
    {
        ElementMatrix K;
        stiffness(K);
        return K.cast<DoubleDouble>();
    }

    /// M [dofs x dofs], symmetric, positive semidefinite, consistent with the displacements inside: the element's motion
    /// has the energy v' M v / 2. Nothing where an element has no mass.
    virtual void mass(ElementMatrix& M) const
    {
        const auto n = static_cast<Eigen::Index>(dofs().size());
        M.setZero(n, n);
    }

    /// f [dofs]: forces on the nodes that do the same work as the loads on the element.
    virtual void equivalent_forces(const ElementLoads& loads, ElementVector& f) const = 0;

    /// What displacements strain the element by, [strains x dofs], whatever its stiffness: no row is zero but for
    /// motions that leave it its shape. Ratios and angles; lengths are counted in the element's own size.
    virtual Eigen::MatrixXd strains() const = 0;

    /// Elements that follow one another with the same number have the same stiffness and mass, and the same equivalent
    /// forces of the same loads along them, which are then computed once; 0 makes no such promise.
    std::uint32_t stiffness_group() const { return stiffness_group_; }

protected:
    explicit Element(std::uint32_t stiffness_group) : stiffness_group_(stiffness_group) {}

private:
    std::uint32_t stiffness_group_ = 0;
};

} // namespace femoop
