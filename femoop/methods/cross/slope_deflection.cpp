#include "femoop/methods/cross/slope_deflection.h"

#include <Eigen/Cholesky>

#include "femoop/analysis/linear_static.h"
#include "femoop/methods/cross/virtual_work.h"

namespace femoop::cross {

namespace {

constexpr double no_diagonal = 1e-12; // of a diagonal entry

/// Where a member's four displacements stand among the unknowns: d = B x.
Eigen::Matrix<double, 4, Eigen::Dynamic> end_motion_of(const Problem& problem, const MemberAction& action)
{
    const auto n = static_cast<Eigen::Index>(problem.joints.size());
    const auto n_all = n + static_cast<Eigen::Index>(problem.sways.size());
    Eigen::Matrix<double, 4, Eigen::Dynamic> B = Eigen::Matrix<double, 4, Eigen::Dynamic>::Zero(4, n_all);
    for (std::size_t which = 0; which < 2; ++which)
        if (action.ends[which])
            if (const std::optional<JointId> joint = problem[*action.ends[which]].joint)
                B(static_cast<Eigen::Index>(2 * which + 1), static_cast<Eigen::Index>(joint->index)) = 1.0;
    for (std::size_t s = 0; s < problem.sways.size(); ++s)
        B.col(n + static_cast<Eigen::Index>(s)) = across(action, problem.sways[s].displacement);
    return B;
}

/// Adds B' K B, of whose columns most are empty.
void add_member(const Problem& problem, const MemberAction& action, Eigen::MatrixXd& A)
{
    const Eigen::Matrix<double, 4, Eigen::Dynamic> B = end_motion_of(problem, action);
    std::vector<Eigen::Index> used;
    for (Eigen::Index i = 0; i < B.cols(); ++i)
        if (!B.col(i).isZero(0.0)) used.push_back(i);
    for (const Eigen::Index j : used) {
        const Eigen::Vector4d p = action.K * B.col(j);
        for (const Eigen::Index i : used) A(i, j) += B.col(i).dot(p);
    }
}

void add_support_springs(const Problem& problem, Eigen::MatrixXd& A)
{
    for (const End& end : problem.ends)
        if (!end.member && end.joint) A(end.joint->index, end.joint->index) += end.stiffness;
    const auto n = static_cast<Eigen::Index>(problem.joints.size());
    for (const GroundSpring& spring : problem.springs)
        for (std::size_t i = 0; i < problem.sways.size(); ++i)
            for (std::size_t j = 0; j < problem.sways.size(); ++j)
                A(n + static_cast<Eigen::Index>(i), n + static_cast<Eigen::Index>(j)) +=
                    spring.stiffness * spring.direction.dot(problem.sways[i].displacement[spring.node.index]) *
                    spring.direction.dot(problem.sways[j].displacement[spring.node.index]);
}

Eigen::VectorXd right_hand_side(const Problem& problem)
{
    const std::size_t n = problem.joints.size();
    Eigen::VectorXd b(static_cast<Eigen::Index>(n + problem.sways.size()));
    for (std::size_t j = 0; j < n; ++j) {
        double sum = problem.loading.joint_load[j];
        for (const EndId e : problem.joints[j].ends) sum -= problem.loading.fixed_end[e.index];
        b[static_cast<Eigen::Index>(j)] = sum;
    }
    const std::vector<double> locked(n, 0.0);
    const std::vector<double> held = holding_forces(problem, {problem.loading.fixed_end, locked});
    for (std::size_t s = 0; s < held.size(); ++s) b[static_cast<Eigen::Index>(n + s)] = -held[s];
    return b;
}

} // namespace

void refuse_mechanism(const Model& model)
{
    static_cast<void>(analyse(inextensible_copy(model)));
    throw ModelError({{FaultKind::CrossSwayUndetermined, {}}});
}

SlopeDeflection equations_of(const Problem& problem)
{
    const auto n = static_cast<Eigen::Index>(problem.joints.size() + problem.sways.size());
    SlopeDeflection system{.A = Eigen::MatrixXd::Zero(n, n), .b = right_hand_side(problem), .x = {}, .moments = {}};
    for (const MemberAction& action : problem.members)
        if (!action.is_overhang) add_member(problem, action, system.A);
    add_support_springs(problem, system.A);
    return system;
}

SlopeDeflection slope_deflection(const Model& model, const Problem& problem)
{
    SlopeDeflection system = equations_of(problem);
    if (system.b.size() > 0) {
        if (!(system.A.diagonal().minCoeff() > 0.0)) refuse_mechanism(model);
        const Eigen::VectorXd scale = system.A.diagonal().cwiseSqrt().cwiseInverse();
        const Eigen::LDLT<Eigen::MatrixXd> factored(scale.asDiagonal() * system.A * scale.asDiagonal());
        if (!(factored.vectorD().minCoeff() > no_diagonal)) refuse_mechanism(model);
        system.x = scale.asDiagonal() * factored.solve(scale.asDiagonal() * system.b);
    }
    system.moments = end_moments(problem, system.x);
    return system;
}

std::vector<double> end_moments(const Problem& problem, const Eigen::VectorXd& unknowns)
{
    std::vector<double> moments(problem.ends.size(), 0.0);
    for (std::size_t e = 0; e < moments.size(); ++e) {
        const End& end = problem.ends[e];
        moments[e] = problem.loading.fixed_end[e];
        if (!end.member && end.joint) moments[e] += end.stiffness * unknowns[end.joint->index];
    }
    for (const MemberAction& action : problem.members) {
        if (action.is_overhang) continue;
        const Eigen::Vector4d p = action.K * (end_motion_of(problem, action) * unknowns);
        for (std::size_t which = 0; which < 2; ++which)
            if (action.ends[which]) moments[action.ends[which]->index] += p[static_cast<Eigen::Index>(2 * which + 1)];
    }
    return moments;
}

} // namespace femoop::cross
