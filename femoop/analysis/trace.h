#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "femoop/element/member_properties.h"
#include "femoop/model/model.h"
#include "femoop/solver/ordering.h"
#include "femoop/solver/system_pattern.h"

namespace femoop {

/// How one member came into the system of equations: the numbers that a student writes on paper.
struct MemberTrace {
    struct FixedEnd {
        std::string load_case;
        Eigen::VectorXd local;  ///< fixed-end forces on the member in its own axes, releases included; what trusses'
                                ///< members and bars carry as simple beams stands across their axis
        Eigen::VectorXd global; ///< in the axes of the nodes: global, or those of a support that is turned
    };
    std::string member;
    /// Of the nodes' rows: "A.ux", "A.uy", "A.rz", "B.ux", ..; then, of a member that a constraint ties, those of its ends
    /// behind joints that are not rigid: "AB.start.rz'".
    std::vector<std::string> dofs;
    std::vector<std::string> own_dofs; ///< of the rows in the member's axes, as releases name them: "A.ux'", ...
    /// What a constraint takes from the member is in no stiffness and no fixed-end force of its strains: it ties the ends
    /// instead. Loads along what it takes stand in the fixed-end forces, with the member's own stiffness.
    Constraint constraint = Constraint::None;
    double length = 0.0;
    /// In the member's axes, releases and springs condensed, unless a constraint ties it; of a truss member across its
    /// axis too, where it is 0.
    Eigen::MatrixXd local_stiffness;
    Eigen::MatrixXd transformation;   ///< T: local = T u in the axes of the nodes, rigid offsets included
    Eigen::MatrixXd global_stiffness; ///< T^T k T, and the springs of a tied member's joints
    Eigen::MatrixXd to_nodes;         ///< forces on the ends, in the member's axes, as the nodes' rows feel them
    std::vector<FixedEnd> fixed_end;  ///< one per load case
    /// Place of each row in the system matrix, counted node after node from 1; 0 where a support blocks it (the solver
    /// eliminates in an order of its own).
    std::vector<int> equations;
};

/// Traces one member through the same code that solves. \throws ModelError as `analyse`.
MemberTrace trace(const Model& model, MemberId member);

/// The equations K u = f of a structure as one writes them on paper: node after node in the model's order, then the ends
/// of members that constraints tie, behind joints that are not rigid.
struct SystemTrace {
    struct Unknown {
        NodeId node; ///< of an end of a member: the one that it hangs on
        Dof dof; ///< in the axes of the node: global, or those of its support where that is turned; of an end: local
        std::optional<MemberId> end_of{};
    };
    std::vector<Unknown> unknowns;
    SparseMatrix K;                                          ///< both triangles
    Eigen::MatrixXd f;                                       ///< [unknowns x load cases], the sum of:
    Eigen::MatrixXd f_of_nodes, f_of_members, f_of_supports; ///< loads on nodes, on members, what supports impose

    /// What inextensible and rigid members impose: C u = c, and u = G y + u0 of the unknowns y that are left.
    struct Ties {
        std::vector<MemberId> members;         ///< of each row of C
        Eigen::MatrixXd C, c;                  ///< [rows x unknowns], [rows x load cases]
        std::vector<Eigen::Index> independent; ///< the unknowns y, ascending
        SparseMatrix G;                        ///< [unknowns x independent]
        Eigen::MatrixXd u0;                    ///< [unknowns x load cases]
    };
    std::optional<Ties> ties; ///< where any member is inextensible or rigid

    /// Who solves it: without ties K u = f, with them G' K G y = G' (f - K u0).
    SolverKind solver{};
    Ordering ordering{};
    std::vector<std::int32_t> place; ///< of each unknown that is solved for, in the order of elimination, from 0

    SparseMatrix solved_matrix() const { return ties ? SparseMatrix(ties->G.transpose() * K * ties->G) : K; }
};

/// "B.ux"; "AB.start.rz'" of a tied member's end behind a joint
std::string unknown_name(const Model& model, const SystemTrace::Unknown& unknown);

/// Traces the whole system through the same code that solves. \throws ModelError as `analyse`.
SystemTrace trace_system(const Model& model);

} // namespace femoop
