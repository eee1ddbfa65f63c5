#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "femoop/analysis/trace.h"
#include "femoop/methods/derivation/derivation.h"
#include "femoop/methods/derivation/paper_system.h"
#include "femoop/methods/derivation/stiffness_entries.h"

namespace femoop::derivation {

/// A member as the direct stiffness method sees it, step by step.
class MemberSteps {
public:
    MemberSteps(const PaperSystem& system, MemberId member);

    /// What does not depend on loads: its data, k', T, and k with its place in K.
    std::vector<Step> stiffness() const;

    Step fixed_end_forces(CaseId load_case) const;
    Step end_displacements(CaseId load_case, const CaseResult& result) const;
    Step end_forces(CaseId load_case, const CaseResult& result) const;
    /// Forces of the nodes on the member, and the part that one of them takes, both in global axes.
    Step node_forces(NodeId node, CaseId load_case, const CaseResult& result) const;

    bool is_tied() const { return trace_.constraint != Constraint::None; } ///< inextensible or rigid
    const MemberTrace& trace() const { return trace_; }
    std::vector<Eigen::Index> rows() const; ///< of the system, that it has a part in
    /// Where a node's rows begin among the member's; a member may begin and end at other nodes alone.
    Eigen::Index first_row(NodeId node) const;

private:
    Eigen::Index dofs_per_node() const;
    /// In the axes of the nodes; then of ends behind joints, of a tied member.
    Eigen::VectorXd node_displacements(const CaseResult& result) const;
    /// Forces on its ends along the rows of its own axes: of their motion, of loads, of what ties it; and their sum.
    Eigen::MatrixXd end_force_parts(CaseId load_case, const CaseResult& result) const;
    NamedMatrix data() const;
    void add_joints(std::vector<NamedNumber>& numbers) const;
    std::string row_name(std::size_t end, LocalAxis axis) const; ///< "A.rz'"
    std::vector<NamedMatrix> entries() const;

    const PaperSystem& system_;
    MemberId member_;
    MemberTrace trace_;
};

} // namespace femoop::derivation
