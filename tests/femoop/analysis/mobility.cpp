#include "tests/femoop/analysis/mobility.h"

#include <Eigen/Dense>
#include <algorithm>
#include <numbers>
#include <vector>

#include "femoop/geometry/member_axes.h"
#include "femoop/geometry/member_geometry.h"

using namespace femoop;

namespace {

using Eigen::Vector3d;

class Kinematics {
public:
    explicit Kinematics(const Model& model) : model_(model), n_nodes_(static_cast<Eigen::Index>(model.nodes.size()))
    {
        for (Eigen::Index i = 0; i < n_nodes_; ++i) {
            add_node(i);
            for (Eigen::Index k = 0; k < 3; ++k) displacements_.push_back(6 * i + k);
        }
        for (std::size_t i = 0; i < model.members.size(); ++i) add_member(static_cast<Eigen::Index>(i));
    }

    Mobility mobility() const
    {
        Eigen::MatrixXd A(static_cast<Eigen::Index>(rows_.size()), n_columns());
        for (std::size_t i = 0; i < rows_.size(); ++i) A.row(static_cast<Eigen::Index>(i)) = rows_[i];
        const Eigen::JacobiSVD<Eigen::MatrixXd> svd(A, Eigen::ComputeFullV);
        Mobility found;
        found.n_free = static_cast<int>(A.cols() - count(svd.singularValues(), free));
        found.is_clear = count(svd.singularValues(), clear_zero) == count(svd.singularValues(), clearly_stiff);
        if (found.n_free == 0) return found;
        const Eigen::MatrixXd motions = svd.matrixV().rightCols(found.n_free);
        const Eigen::VectorXd seen = Eigen::MatrixXd(motions(displacements_, Eigen::all)).jacobiSvd().singularValues();
        found.n_mechanisms = static_cast<int>(count(seen, free));
        found.is_clear = found.is_clear && count(seen, clear_zero) == count(seen, clearly_stiff);
        return found;
    }

private:
    static constexpr double clear_zero = 1e-11, free = 1e-9, clearly_stiff = 1e-5;

    static Eigen::Index count(const Eigen::VectorXd& values, double above) { return (values.array() > above).count(); }
    Eigen::Index n_columns() const { return 6 * n_nodes_ + 12 * static_cast<Eigen::Index>(model_.members.size()); }
    Eigen::RowVectorXd& new_row() { return rows_.emplace_back(Eigen::RowVectorXd::Zero(n_columns())); }

    bool is_attached(Eigen::Index node) const
    {
        return std::any_of(model_.members.begin(), model_.members.end(), [&](const Member& member) {
            return std::count(member.nodes.begin(), member.nodes.end(), NodeId(static_cast<std::size_t>(node))) > 0;
        });
    }

    void add_node(Eigen::Index node)
    {
        const bool is_loose = !is_attached(node); // no part of the structure
        const Node& at = model_.nodes[static_cast<std::size_t>(node)];
        DofSet held;
        double angle = 0.0;
        if (at.support) {
            held = at.support->blocked(model_.analysis);
            for (const Spring& spring : at.support->springs) held.insert(spring.dof);
            angle = at.support->angle * std::numbers::pi / 180.0;
        }
        for (const Dof dof : all_dofs) {
            const bool is_known = dofs(model_.analysis).contains(dof);
            if (is_known && !held.contains(dof) && !is_loose) continue;
            const auto k = static_cast<Eigen::Index>(index(dof));
            Vector3d axis = Vector3d::Unit(k % 3);
            if (k < 3 && is_known) axis = Eigen::AngleAxisd(angle, Vector3d::UnitZ()) * axis;
            new_row().segment<3>(6 * node + k / 3 * 3) = axis;
        }
    }

    void add_member(Eigen::Index at)
    {
        const Member& member = model_.members[static_cast<std::size_t>(at)];
        const auto [axes, start, end, L] = geometry_of(model_, member);
        const bool is_bar = member.bar || is_truss(model_.analysis);
        const Eigen::Index first = 6 * n_nodes_ + 12 * at;
        const auto add = [&](std::initializer_list<std::pair<Eigen::Index, double>> terms) {
            Eigen::RowVectorXd& row = new_row();
            for (const auto& [column, value] : terms) row[first + column] += value;
        };
        add({{0, -1.0 / L}, {6, 1.0 / L}});
        if (!is_bar) add({{3, -1.0}, {9, 1.0}});
        for (Eigen::Index e = 0; e < 12; e += 6) {
            if (is_bar)
                for (Eigen::Index k = 3; k < 6; ++k) add({{e + k, 1.0}});
            else {
                add({{e + 5, 1.0}, {1, 1.0 / L}, {7, -1.0 / L}});
                add({{e + 4, 1.0}, {2, -1.0 / L}, {8, 1.0 / L}});
            }
            join(member, e == 0, axes, first + e, is_bar);
            for (const Eigen::Index k : {0, 1, 2, 4, 5}) displacements_.push_back(first + e + k);
        }
    }

    void join(const Member& member, bool is_start, const Eigen::Matrix3d& axes, Eigen::Index first, bool is_bar)
    {
        const NodeId node = member.nodes[is_start ? 0 : 1];
        const MemberEnd& end = is_start ? member.start : member.end;
        const Vector3d arm = vector_of(end.offset);
        for (const Dof dof : all_dofs) {
            const auto k = static_cast<Eigen::Index>(index(dof));
            if (is_bar && k >= 3) continue;
            const bool is_hinged = model_[node].hinge && k >= 3 && member_dofs(model_.analysis).contains(dof);
            const bool is_released = end.release.contains(dof) && (!is_bar || dof == Dof::ux);
            if (is_released || is_hinged) continue;
            const Vector3d axis = axes.row(k % 3);
            Eigen::RowVectorXd& row = new_row();
            row[first + k] = -1.0;
            const auto column = 6 * static_cast<Eigen::Index>(node.index);
            row.segment<3>(column + k / 3 * 3) = axis;
            if (k < 3) row.segment<3>(column + 3) = arm.cross(axis);
        }
    }

    const Model& model_;
    Eigen::Index n_nodes_;
    std::vector<Eigen::RowVectorXd> rows_;
    std::vector<Eigen::Index> displacements_; ///< all that is no spin
};

} // namespace

Mobility mobility(const Model& model) { return Kinematics(model).mobility(); }
