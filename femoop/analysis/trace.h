#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>
#include <vector>

#include "femoop/element/member_properties.h"
#include "femoop/model/model.h"
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
    std::vector<std::string> dofs;     ///< of the nodes' rows: "A.ux", "A.uy", "A.rz", "B.ux", ...
    std::vector<std::string> own_dofs; ///< of the rows in the member's axes, as releases name them: "A.ux'", ...
    /// What a constraint takes from the member is in no stiffness and no fixed-end force: it ties the ends instead.
    Constraint constraint = Constraint::None;
    double length = 0.0;
    /// In the member's axes, releases and springs condensed; of a truss member across its axis too, where it is 0.
    Eigen::MatrixXd local_stiffness;
    Eigen::MatrixXd transformation;   ///< T: local = T u in the axes of the nodes, rigid offsets included
    Eigen::MatrixXd global_stiffness; ///< T^T k T
    std::vector<FixedEnd> fixed_end;  ///< one per load case
    /// Place of each row in the system matrix, counted node after node from 1; 0 where a support blocks it (the solver
    /// eliminates in an order of its own).
    std::vector<int> equations;
};

/// Traces one member through the same code that solves. \throws ModelError as `analyse`.
MemberTrace trace(const Model& model, MemberId member);

/// The equations K u = f of a structure as one writes them on paper: node after node in the model's order.
struct SystemTrace {
    struct Unknown {
        NodeId node;
        Dof dof; ///< in the axes of the node: global, or those of its support where that is turned
    };
    std::vector<Unknown> unknowns;
    SparseMatrix K;    ///< both triangles
    Eigen::MatrixXd f; ///< [unknowns x load cases], with what settlements bring
};

/// Traces the whole system through the same code that solves. \throws ModelError as `analyse`.
/// \pre no member is inextensible or rigid: a constraint is in no stiffness
SystemTrace trace_system(const Model& model);

} // namespace femoop
