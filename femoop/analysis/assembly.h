#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "femoop/discretisation/case_loads.h"
#include "femoop/discretisation/discretisation.h"
#include "femoop/discretisation/equations.h"
#include "femoop/element/member_element.h"
#include "femoop/solver/double_double.h"

namespace femoop {

/// Builds the system of equations of a structure, member by member, in one of the five models.
///
/// A node's displacements are in the axes of its support. Members with a constraint bring their elastic part here;
/// what the constraint does is in femoop/analysis/constraints.h.
///
/// In DoubleDouble every stiffness is B' S B of strains, so that a rigid motion strains no member and the forces of
/// each are in equilibrium to its last digit; the data, B and S are doubles.
template <AnalysisKind kind, class Scalar = double> class Assembly {
public:
    using Element = MemberElement<kind>;
    static constexpr int n = Element::n;
    using NodeMatrix = Eigen::Matrix<double, n, n>;
    using Dense = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;
    using Vector = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;
    using Sparse = Eigen::SparseMatrix<Scalar>;

    Assembly(const Discretisation& structure, const Equations& equations);

    /// A member's element with what strains it, to be used while its geometry lives.
    Element element(MemberId member, const MemberGeometry& geometry) const;
    /// The same with what its constraint takes from it. \pre the member has a constraint
    Element constrained_element(MemberId member, const MemberGeometry& geometry) const;

    /// An element with stiffnesses 1 in place of its own, for what depends on its shape alone.
    Element unit_element(MemberId member, const MemberGeometry& geometry, ActionSet actions) const;

    /// What resists in a member: its stiffness and, if it has one, its constraint.
    std::vector<Element> resisting_elements(MemberId member, const MemberGeometry& geometry) const;

    /// The equations of a member's nodes, [2n]; Equations::none where a displacement is prescribed.
    std::array<std::int32_t, 2 * n> node_equations(MemberId member) const;

    /// A constrained member's end displacements, local = B x, over its node_equations and then its member-end degrees
    /// of freedom.
    struct MemberEndDofs {
        std::vector<std::int32_t> equations;
        Dense B;
        Dense gaps;             ///< of its springs between node and end, over x
        Eigen::VectorXd joints; ///< their stiffnesses
    };
    MemberEndDofs member_ends(MemberId member, const Element& element) const;

    /// Adds every member's elastic stiffness and every support spring to K, which has the equations' pattern.
    void add_stiffness(Sparse& K) const;

    /// Own stiffness of what constraints take from members, over all unknowns; zero where there is no constraint.
    Sparse constrained_stiffness() const;

    /// Forces on the unknowns from loads, fixed ends, settlements and grounds of springs that moved.
    Vector load_vector(const CaseLoads& loads) const;

    /// Displacements of blocked and grounds of sprung degrees of freedom, node axes, every node; empty when none moves.
    std::vector<double> settlements(const CaseLoads& loads) const;

    /// Turns all node displacements from node axes to global ones.
    void to_global(std::vector<Scalar>& displacements) const;

private:
    bool is_constrained(MemberId member) const;
    bool is_plain(MemberId member) const; ///< without end_conditions, between nodes in global axes
    Element element_of(MemberId member, const MemberGeometry& geometry, ActionSet actions,
                       const MemberProperties& properties) const;
    const NodeMatrix* axes_of(NodeId node) const;
    void add_node_loads(const CaseLoads& loads, Eigen::VectorXd& f) const;
    void add_member_loads(const CaseLoads& loads, Eigen::VectorXd& f) const;
    void add_settlements(const CaseLoads& loads, Vector& f) const;
    template <class Visit> void visit_member(MemberId member, Visit&& visit) const;

    const Discretisation& structure_;
    const Equations& equations_;
    std::vector<NodeMatrix> support_axes_; ///< parallel to supports; empty when none is inclined
};

} // namespace femoop
