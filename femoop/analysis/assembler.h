#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <vector>

#include "femoop/discretisation/case_loads.h"
#include "femoop/discretisation/discretisation.h"
#include "femoop/discretisation/elements.h"
#include "femoop/discretisation/equations.h"
#include "femoop/discretisation/node_axes.h"
#include "femoop/solver/double_double.h"

namespace femoop {

/// Adds up what elements contribute to the equations of a structure, element by element, whatever they are.
///
/// An element speaks of global axes; here its matrices are turned to the axes of its nodes, which are inclined where
/// supports are. Members with a constraint bring their elastic part; what the constraint does is in
/// femoop/analysis/constraints.h.
///
/// Scalar is double or DoubleDouble: then every stiffness is B' S B of strains, so that a rigid motion strains no
/// member and the forces of each are in equilibrium to its last digit; the data, B and S are doubles.
class Assembler {
public:
    template <class Scalar> using Sparse = Eigen::SparseMatrix<Scalar>;
    template <class Scalar> using Vector = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;

    /// They must live as long as the assembler.
    Assembler(const Discretisation& structure, const Elements& elements, const Equations& equations);

    const Discretisation& structure() const { return structure_; }
    const Elements& elements() const { return elements_; }
    const Equations& equations() const { return equations_; }

    /// Adds every element's elastic stiffness and every support spring to K, which has the equations' pattern. The
    /// first returns the largest stiffness of an element against any of its displacements alone, prescribed ones too.
    double add_stiffness(SparseMatrix& K) const;
    void add_stiffness(PreciseSparseMatrix& K) const;

    /// Adds every element's mass to M, which has the equations' pattern.
    void add_mass(SparseMatrix& M) const;

    /// Own stiffness of what constraints take from members, over all unknowns; zero where there is no constraint.
    template <class Scalar> Sparse<Scalar> constrained_stiffness() const;

    /// Forces on the unknowns from loads on nodes and elements, settlements and grounds of springs that moved. Loads
    /// on one node add up to as many digits as Scalar has.
    template <class Scalar> Vector<Scalar> load_vector(const CaseLoads& loads) const;

    /// Displacements of blocked and grounds of sprung degrees of freedom, node axes, every node; empty when none moves.
    std::vector<double> settlements(const CaseLoads& loads) const;

    /// Of those `moved` the ones that an element's degrees of freedom are prescribed by; 0 where they are unknown, or
    /// where `moved` is empty.
    ElementVector prescribed(std::size_t element, const std::vector<double>& moved) const;

    /// Turns all node displacements from node axes to global ones.
    template <class Scalar> void to_global(std::vector<Scalar>& displacements) const { axes_.to_global(displacements); }

    /// The columns of a matrix over an element's degrees of freedom, or over those of its nodes, from global axes to
    /// the nodes'.
    Eigen::MatrixXd in_node_axes(std::size_t element, Eigen::MatrixXd M) const;

    /// A' A of the strains of all members and support springs, each as its nodes feel it, over all unknowns, lower
    /// triangle: what resists a node's rotation, be it stiffness or constraint.
    SparseMatrix resistance() const;

private:
    template <class Scalar> using Dense = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;
    template <class Matrix> void add_elements(SparseMatrix& A, Matrix&& matrix) const;
    template <class Add> void visit_springs(Add&& add) const;
    template <class Scalar> Dense<Scalar> stiffness(std::size_t element) const;
    template <class Scalar> void add_node_loads(const CaseLoads& loads, Vector<Scalar>& f) const;
    template <class Scalar> void add_span_loads(const CaseLoads& loads, Vector<Scalar>& f) const;
    template <class Scalar>
    void add_element_loads(std::size_t element, const ElementLoads& loads, Vector<Scalar>& f) const;
    template <class Scalar>
    void add_element_forces(std::size_t element, const ElementVector& forces, Vector<Scalar>& f) const;
    template <class Scalar> void add_settlements(const CaseLoads& loads, Vector<Scalar>& f) const;

    const Discretisation& structure_;
    const Elements& elements_;
    const Equations& equations_;
    NodeAxes axes_;
};

} // namespace femoop
