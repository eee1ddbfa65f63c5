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
    std::string name_of(Eigen::Index row) const; ///< "B.ux"; "AB.start.rz'" of a tied member's end behind a joint
    std::vector<std::string> names_of(const std::vector<Eigen::Index>& rows) const;
    /// The unknowns that a row of K couples, itself too, ascending.
    std::vector<Eigen::Index> coupled_with(Eigen::Index row) const;

    /// How a node moves along its own axes: global ones, or those of its support where that is turned.
    Eigen::VectorXd in_node_axes(NodeId node, const NodeVector& displacement) const;
    /// Forces of a node from its own axes to global ones.
    Eigen::VectorXd in_global_axes(NodeId node, Eigen::VectorXd forces) const;
    double angle_of(NodeId node) const; ///< of its support [rad]
    Eigen::VectorXd unknowns_in(const CaseResult& result) const;

    /// Few enough to write all rows of u and f.
    bool has_few_unknowns() const { return trace_.unknowns.size() <= most_unknowns_shown; }
    std::vector<Eigen::Index> all_rows() const;
    /// All of them where they are few, else these.
    std::vector<Eigen::Index> written_rows(const std::vector<Eigen::Index>& rows) const;

    /// Of the equations that are solved: K u = f, or what ties leave of them.
    bool is_written_whole() const { return static_cast<std::size_t>(solved_.rows()) <= most_unknowns_shown; }
    /// Places in the solved equations of the unknowns that these rows follow, ascending.
    std::vector<Eigen::Index> solved_rows(const std::vector<Eigen::Index>& rows) const;
    std::vector<std::string> solved_names(const std::vector<Eigen::Index>& solved) const;
    /// K, u and f of a load case: all of them where they are few, else these rows and what they couple. With ties G' K G
    /// and its like.
    std::vector<NamedMatrix> equations(const std::vector<Eigen::Index>& rows, CaseId load_case,
                                       const CaseResult& result) const;

private:
    const Model& model_;
    Discretisation structure_;
    SystemTrace trace_;
    SparseMatrix solved_; ///< both triangles
};

} // namespace femoop::derivation
