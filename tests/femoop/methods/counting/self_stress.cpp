#include "tests/femoop/methods/counting/self_stress.h"

#include <Eigen/Dense>
#include <array>
#include <numbers>
#include <vector>

#include "femoop/geometry/member_geometry.h"
#include "femoop/geometry/node_position.h"

using namespace femoop;

namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Vector3d;

/// What carries a force and a moment (fx, fy, mz) over to a place, of which the force stands off by `arm`.
Matrix3d carried(const Vector3d& arm)
{
    Matrix3d T = Matrix3d::Identity();
    T.row(2) << -arm.y(), arm.x(), 1.0;
    return T;
}

class EquilibriumEquations {
public:
    explicit EquilibriumEquations(const Model& model)
        : model_(model), n_node_rows_(3 * static_cast<Index>(model.nodes.size()))
    {
        for (const Member& member : model.members) add(member);
        for (std::size_t i = 0; i < model.nodes.size(); ++i)
            if (is_attached(NodeId(i))) add_support(NodeId(i));
    }

    int n_left_open() const
    {
        const auto n_columns = static_cast<Index>(columns_.size());
        Eigen::MatrixXd A = Eigen::MatrixXd::Zero(n_node_rows_ + static_cast<Index>(releases_.size()), n_columns);
        for (Index j = 0; j < n_columns; ++j) A.col(j).head(n_node_rows_) = columns_[static_cast<std::size_t>(j)];
        for (std::size_t i = 0; i < releases_.size(); ++i)
            A.row(n_node_rows_ + static_cast<Index>(i)).segment<3>(releases_[i].first_column) = releases_[i].row;
        Eigen::FullPivLU<Eigen::MatrixXd> lu(A);
        lu.setThreshold(1e-9);
        return static_cast<int>(n_columns - lu.rank());
    }

private:
    struct Release {
        Index first_column;
        Eigen::RowVector3d row;
    };

    bool is_attached(NodeId node) const
    {
        for (const Member& member : model_.members)
            if (member.nodes[0] == node || member.nodes[1] == node) return true;
        return false;
    }

    /// Its forces on its first end are (N, V, M) along its axes; those on its second balance them.
    void add(const Member& member)
    {
        const auto [axes, start, end, L] = geometry_of(model_, member);
        const std::array<Matrix3d, 2> at_ends{Matrix3d::Identity(), -carried({-L, 0.0, 0.0})};
        const std::array<Vector3d, 2> places{start, end};
        const auto first_column = static_cast<Index>(columns_.size());
        Eigen::MatrixXd on_nodes = Eigen::MatrixXd::Zero(n_node_rows_, 3);
        for (std::size_t e = 0; e < 2; ++e) {
            const NodeId node = member.nodes[e];
            const Vector3d arm = places[e] - position_of(model_, node);
            on_nodes.middleRows<3>(3 * static_cast<Index>(node.index)) = carried(arm) * axes.transpose() * at_ends[e];
            for (const Index k : released(member, e)) releases_.push_back({first_column, at_ends[e].row(k)});
        }
        for (Index k = 0; k < 3; ++k) columns_.emplace_back(on_nodes.col(k));
    }

    std::vector<Index> released(const Member& member, std::size_t e) const
    {
        const DofSet& release = (e == 0 ? member.start : member.end).release;
        std::vector<Index> found;
        if (release.contains(Dof::ux)) found.push_back(0);
        if (release.contains(Dof::uy) && !member.bar) found.push_back(1);
        if (release.contains(Dof::rz) || member.bar || model_[member.nodes[e]].hinge) found.push_back(2);
        return found;
    }

    void add_support(NodeId node)
    {
        const std::optional<Support>& support = model_[node].support;
        if (!support) return;
        DofSet held = support->blocked(model_.analysis);
        for (const Spring& spring : support->springs) held.insert(spring.dof);
        const Matrix3d turn =
            Eigen::AngleAxisd(support->angle * std::numbers::pi / 180.0, Vector3d::UnitZ()).toRotationMatrix();
        const std::array directions{Dof::ux, Dof::uy, Dof::rz};
        for (std::size_t k = 0; k < directions.size(); ++k) {
            if (!held.contains(directions[k])) continue;
            columns_.emplace_back(Eigen::VectorXd::Zero(n_node_rows_));
            columns_.back().segment<3>(3 * static_cast<Index>(node.index)) = turn.col(static_cast<Index>(k));
        }
    }

    const Model& model_;
    Index n_node_rows_;
    std::vector<Eigen::VectorXd> columns_;
    std::vector<Release> releases_;
};

} // namespace

int n_self_stresses(const Model& model) { return EquilibriumEquations(model).n_left_open(); }
