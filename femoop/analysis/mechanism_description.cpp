#include "femoop/analysis/mechanism_description.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>

#include "femoop/algebra/least_squares.h"
#include "femoop/analysis/node_names.h"
#include "femoop/element/analysis_model.h"
#include "femoop/result/end_vectors.h"

namespace femoop {

namespace {

constexpr double still = 1e-6; // of the largest motion: less does not count as moving

Eigen::Vector3d translation(const NodeVector& v) { return {v[0], v[1], v[2]}; }
Eigen::Vector3d rotation(const NodeVector& v) { return {v[3], v[4], v[5]}; }

std::string number(double value)
{
    std::ostringstream text;
    text.precision(4);
    text << (std::abs(value) < 1e-9 ? 0.0 : value);
    return text.str();
}

std::string point(const Eigen::Vector3d& at, AnalysisKind kind)
{
    std::string text = "(" + number(at.x()) + ", " + number(at.y());
    return text + (is_plane(kind) ? ")" : ", " + number(at.z()) + ")");
}

/// The point that all moving nodes of a plane model turn about, if they do.
std::optional<Eigen::Vector3d> pivot(const Discretisation& structure, const std::vector<NodeVector>& motion,
                                     const std::vector<NodeId>& moving)
{
    // u = a - w y, v = b + w x: three unknowns for two equations a node
    Eigen::MatrixXd A(2 * static_cast<Eigen::Index>(moving.size()), 3);
    Eigen::VectorXd c(A.rows());
    for (std::size_t i = 0; i < moving.size(); ++i) {
        const Eigen::Vector3d& at = structure.positions[moving[i].index];
        const auto row = 2 * static_cast<Eigen::Index>(i);
        A.row(row) << 1.0, 0.0, -at.y();
        A.row(row + 1) << 0.0, 1.0, at.x();
        c.segment<2>(row) = translation(motion[moving[i].index]).head<2>();
    }
    const Eigen::Vector3d fit = least_squares(A, c);
    if ((A * fit - c).cwiseAbs().maxCoeff() > still || std::abs(fit[2]) < 1e-9) return std::nullopt;
    return Eigen::Vector3d(-fit[1] / fit[2], fit[0] / fit[2], 0.0);
}

/// Makes the largest translation (or, without one, rotation) 1 and its main component positive; returns the factor.
double normalize(std::vector<NodeVector>& motion)
{
    for (const std::size_t first : {std::size_t{0}, std::size_t{3}}) {
        double largest = 0.0;
        for (const NodeVector& v : motion)
            for (std::size_t i = first; i < first + 3; ++i)
                if (std::abs(v[i]) > std::abs(largest) * (1.0 + 1e-6)) largest = v[i];
        double everything = 0.0;
        for (const NodeVector& v : motion)
            for (const double component : v) everything = std::max(everything, std::abs(component));
        if (std::abs(largest) <= still * everything || largest == 0.0) continue;
        for (NodeVector& v : motion)
            for (double& component : v) component /= largest;
        return 1.0 / largest;
    }
    return 1.0;
}

Fault along(const Model& model, const std::vector<NodeId>& moving, const Eigen::Vector3d& direction)
{
    static constexpr std::array together{FaultKind::MechanismSwayX, FaultKind::MechanismSwayY,
                                         FaultKind::MechanismSwayZ};
    static constexpr std::array alone{FaultKind::MechanismMoveX, FaultKind::MechanismMoveY, FaultKind::MechanismMoveZ};
    for (int axis = 0; axis < 3; ++axis)
        if (std::abs(std::abs(direction[axis]) - direction.norm()) < still)
            return {.kind = (moving.size() > 1 ? together : alone)[static_cast<std::size_t>(axis)],
                    .arguments = {names_of(model, moving)}};
    return {.kind = FaultKind::MechanismMoveOblique,
            .arguments = {names_of(model, moving), point(direction, model.analysis)}};
}

/// A truss has no joint that could be rigid.
std::string_view remedy(AnalysisKind kind)
{
    return is_truss(kind) ? translatable("a bar or a support") : translatable("a brace, a support or a rigid joint");
}

/// Tells such motions of the same nodes apart by the one that moves the most; of nearly equal ones the first.
Fault each_its_way(const Model& model, const std::vector<NodeVector>& motion, const std::vector<NodeId>& moving)
{
    NodeId most = moving.front();
    for (const NodeId node : moving)
        if (translation(motion[node.index]).norm() > translation(motion[most.index]).norm() * (1.0 + 1e-6)) most = node;
    return {.kind = FaultKind::MechanismMixed,
            .arguments = {names_of(model, moving), model[most].id,
                          point(translation(motion[most.index]), model.analysis), std::string(remedy(model.analysis))}};
}

/// What a single node's rotation is called depends on its cause: nothing holds it, or a moment drives it.
Fault words(const Model& model, const Discretisation& structure, const std::vector<NodeVector>& motion, FaultKind spin)
{
    std::vector<NodeId> moving, turning;
    for (std::size_t i = 0; i < motion.size(); ++i) {
        if (translation(motion[i]).norm() > still) moving.emplace_back(i);
        if (rotation(motion[i]).norm() > still) turning.emplace_back(i);
    }
    if (moving.empty() && turning.size() == 1) {
        Eigen::Index axis = 0;
        rotation(motion[turning.front().index]).cwiseAbs().maxCoeff(&axis);
        return {
            .kind = spin,
            .arguments = {model[turning.front()].id, std::string(name(all_dofs[3 + static_cast<std::size_t>(axis)]))}};
    }
    if (moving.empty()) return {.kind = FaultKind::MechanismSpins, .arguments = {names_of(model, turning)}};
    const Eigen::Vector3d first = translation(motion[moving.front().index]);
    const bool is_common = std::all_of(moving.begin(), moving.end(), [&](NodeId node) {
        return (translation(motion[node.index]) - first).norm() < still;
    });
    if (is_common) return along(model, moving, first);
    if (is_plane(model.analysis))
        if (const auto about = pivot(structure, motion, moving)) {
            const std::string place = point(*about, model.analysis) + " " + std::string(name(model.units.length));
            return {.kind = FaultKind::MechanismTurn,
                    .arguments = {names_of(model, moving), place, std::string(remedy(model.analysis))}};
        }
    return each_its_way(model, motion, moving);
}

std::vector<NodeVector> motion_of(const Discretisation& structure, const std::vector<double>& displacements)
{
    const std::span<const Dof> dofs = model_dofs(structure.kind);
    std::vector<NodeVector> motion(structure.positions.size());
    for (std::size_t node = 0; node < motion.size(); ++node)
        for (std::size_t i = 0; i < dofs.size(); ++i)
            motion[node][index(dofs[i])] = displacements[node * dofs.size() + i];
    return motion;
}

std::vector<std::array<Eigen::Vector3d, 2>> still_ends(const Discretisation& structure)
{
    return {structure.members.size(), {Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()}};
}

/// Translations of every member's ends when its nodes move: through rigid arms, and where a shear or axial release lets
/// the end part from its node, with the least motion that does not strain the member.
std::vector<std::array<Eigen::Vector3d, 2>> member_ends(const std::shared_ptr<const Discretisation>& structure,
                                                        const Equations& equations, const detail::CaseSolution& motion)
{
    detail::Solution solution;
    solution.structure = structure;
    solution.loads.resize(1);
    solution.cases = {{.name = {}, .terms = {{.load_case = 0, .factor = 1.0}}}};
    solution.member_end_dofs_of = equations.member_end_dofs_of();
    solution.solutions = {motion};
    solution.solutions.front().constraint_displacements.assign(motion.displacements.size(), 0.0);
    solution.solutions.front().constraint_member_ends.assign(motion.member_ends.size(), 0.0);
    auto ends = still_ends(*structure);
    for (std::size_t i = 0; i < ends.size(); ++i) {
        const detail::EndVectors local = detail::end_displacements(solution, 0, MemberId(i));
        const Eigen::Matrix3d axes = structure->geometry(MemberId(i)).axes;
        for (std::size_t end = 0; end < 2; ++end) ends[i][end] = axes.transpose() * local[end].head<3>();
    }
    return ends;
}

/// Where a node that rotates takes along a member whose far end is released, it is the member that swings about it.
Fault swing(const Model& model, const Mechanism& mechanism)
{
    const auto turns = [](const NodeVector& v) { return rotation(v).norm() > still; };
    const auto node = std::ranges::find_if(mechanism.motion, turns) - mechanism.motion.begin();
    for (std::size_t i = 0; i < model.members.size(); ++i)
        for (std::size_t end = 0; end < 2; ++end)
            if (model.members[i].nodes[1 - end].index == static_cast<std::size_t>(node) &&
                mechanism.member_ends[i][end].norm() > still)
                return {.kind = FaultKind::MechanismMemberSwings,
                        .arguments = {model.members[i].id, model.nodes[static_cast<std::size_t>(node)].id}};
    return mechanism.fault;
}

} // namespace

std::vector<Mechanism> mechanisms_of(const Model& model, const std::shared_ptr<const Discretisation>& structure,
                                     const Equations& equations, std::vector<detail::CaseSolution> motions)
{
    std::vector<Mechanism> mechanisms;
    for (detail::CaseSolution& motion : motions) {
        std::vector<NodeVector> nodes = motion_of(*structure, motion.displacements);
        const double factor = normalize(nodes);
        for (double& u : motion.displacements) u *= factor;
        for (double& u : motion.member_ends) u *= factor;
        Mechanism mechanism{.fault = words(model, *structure, nodes, FaultKind::MechanismNodeTurns),
                            .motion = {},
                            .member_ends = member_ends(structure, equations, motion)};
        mechanism.motion = std::move(nodes);
        if (mechanism.fault.kind == FaultKind::MechanismNodeTurns) mechanism.fault = swing(model, mechanism);
        mechanisms.push_back(std::move(mechanism));
    }
    return mechanisms;
}

Mechanism member_mechanism(const Model& model, const Discretisation& structure, const LooseMember& loose)
{
    const auto& [member, internal] = loose;
    const auto axis = static_cast<std::size_t>(internal.axis);
    Mechanism mechanism{.fault = {.kind = FaultKind::MechanismMemberFlies,
                                  .arguments = {model[member].id, std::string(name(all_dofs[axis]))}},
                        .motion = std::vector<NodeVector>(structure.positions.size()),
                        .member_ends = still_ends(structure)};
    const Eigen::Matrix3d axes = structure.geometry(member).axes;
    const double largest = std::max(internal.mode[0].head<3>().norm(), internal.mode[1].head<3>().norm());
    for (std::size_t end = 0; end < 2 && largest > 0.0; ++end)
        mechanism.member_ends[member.index][end] = axes.transpose() * internal.mode[end].head<3>() / largest;
    return mechanism;
}

Mechanism rotation_mechanism(const Model& model, const Discretisation& structure, const ArtificialRestraint& rotation)
{
    std::vector<NodeVector> motion(structure.positions.size());
    for (std::size_t i = 0; i < rotation.parts.size(); ++i)
        motion[rotation.parts[i].node.index][index(rotation.parts[i].dof)] =
            rotation.direction[static_cast<Eigen::Index>(i)];
    normalize(motion);
    Fault fault = words(model, structure, motion, FaultKind::MechanismSpin);
    return {.fault = std::move(fault), .motion = std::move(motion), .member_ends = still_ends(structure)};
}

Fault beyond_range_fault(const Model& model, const std::vector<NodeId>& nodes)
{
    return {.kind = FaultKind::StiffnessBeyondRange, .arguments = {names_of(model, nodes)}};
}

Fault nearly_singular_fault(const Model& model, double condition, const std::vector<double>& displacements,
                            std::size_t n)
{
    double largest = 0.0;
    for (const double u : displacements) largest = std::max(largest, std::abs(u));
    std::vector<NodeId> softest;
    for (std::size_t i = 0; i < displacements.size(); ++i)
        if (std::abs(displacements[i]) >= 0.5 * largest && (softest.empty() || softest.back() != NodeId(i / n)))
            softest.emplace_back(i / n);
    std::ostringstream estimate;
    estimate.precision(1);
    estimate << std::scientific << condition;
    return {.kind = FaultKind::NearlySingular, .arguments = {estimate.str(), names_of(model, softest)}};
}

std::vector<Fault> conflict_faults(const Model& model, const std::vector<Elimination::Conflict>& conflicts)
{
    std::vector<Fault> faults;
    for (const Elimination::Conflict& conflict : conflicts) {
        std::vector<std::string> members;
        for (const MemberId member : conflict.members) members.push_back(model[member].id);
        faults.push_back({.kind = FaultKind::ConstraintConflict,
                          .arguments = {listed(members), model.case_name(CaseId(conflict.load_case))}});
    }
    return faults;
}

namespace {

std::vector<Fault> all_faults(const std::vector<Mechanism>& mechanisms, std::vector<Fault> causes)
{
    for (const Mechanism& mechanism : mechanisms) causes.push_back(mechanism.fault);
    return causes;
}

} // namespace

std::string without_remedy(const std::string& sentence) { return sentence.substr(0, sentence.rfind(';')); }

MechanismError::MechanismError(std::vector<Mechanism> mechanisms, std::size_t n_more, std::vector<Fault> causes)
    : ModelError(all_faults(mechanisms, causes)),
      mechanisms_(std::move(mechanisms)),
      n_more_(n_more),
      causes_(std::move(causes))
{}

} // namespace femoop
