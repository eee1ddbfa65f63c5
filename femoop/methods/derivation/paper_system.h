#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "femoop/analysis/trace.h"
#include "femoop/discretisation/discretisation.h"
#include "femoop/methods/derivation/derivation.h"

namespace femoop::derivation {

/// The equations of a structure as one writes them on paper, with names beside them.
class PaperSystem {
public:
    explicit PaperSystem(const Model& model);

    const Model& model() const { return model_; }
    const Discretisation& structure() const { return structure_; }
    const SystemTrace& trace() const { return trace_; }

    /// None where a support blocks it or no member meets the node.
    std::optional<Eigen::Index> row_of(NodeId node, Dof dof) const;
    std::string name_of(Eigen::Index row) const; ///< "B.ux"
    /// The unknowns that a row of K couples, itself too, ascending.
    std::vector<Eigen::Index> coupled_with(Eigen::Index row) const;

    /// How a node moves along its own axes: global ones, or those of its support where that is turned.
    Eigen::VectorXd in_node_axes(NodeId node, const NodeVector& displacement) const;
    /// Forces of a node from its own axes to global ones.
    Eigen::VectorXd in_global_axes(NodeId node, Eigen::VectorXd forces) const;
    double angle_of(NodeId node) const; ///< of its support [rad]
    Eigen::VectorXd unknowns_in(const CaseResult& result) const;

    bool is_written_whole() const { return trace_.unknowns.size() <= most_unknowns_shown; }
    /// K, u and f of a load case: all of them where they are few, else these rows and what they couple.
    std::vector<NamedMatrix> equations(std::vector<Eigen::Index> rows, CaseId load_case,
                                       const CaseResult& result) const;

private:
    const Model& model_;
    Discretisation structure_;
    SystemTrace trace_;
};

} // namespace femoop::derivation
