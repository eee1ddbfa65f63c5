#include "femoop/analysis/mechanism_report.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "femoop/analysis/compatibility.h"
#include "femoop/analysis/equilibrium.h"
#include "femoop/analysis/mechanism_description.h"
#include "femoop/analysis/member_mechanism.h"
#include "femoop/analysis/overflow_check.h"
#include "femoop/analysis/rigid_body.h"
#include "femoop/element/analysis_model.h"

namespace femoop {

namespace {

constexpr Eigen::Index most_modes = 64;     // to look for in a structure that moves in many ways
constexpr Eigen::Index most_described = 12; // of them: who reads more sentences than that?

void append(std::vector<Mechanism>& mechanisms, std::vector<Mechanism> more)
{
    std::move(more.begin(), more.end(), std::back_inserter(mechanisms));
}

} // namespace

MechanismReport::MechanismReport(const Model& model, const StaticSystem& system)
    : model_(model), system_(system), structure_(*system.structure())
{}

void MechanismReport::require_geometric_stability() const
{
    require_finite_stiffness();
    const NullModes free = Compatibility(system_.assembler(), system_.restraints()).free_motions(most_modes);
    if (free.is_singular()) refuse(free.modes);
}

void MechanismReport::require_held_members() const
{
    if (!member_mechanisms(model_, system_.assembler()).empty()) refuse({});
}

void MechanismReport::require_undriven(const std::vector<CaseLoads>& loads, const Eigen::MatrixXd& F) const
{
    if (auto mechanisms = driven(loads, F); !mechanisms.empty()) throw MechanismError(std::move(mechanisms));
}

void MechanismReport::require_compatible(const Elimination& imposed) const
{
    if (!imposed.conflicts.empty()) throw ModelError(conflict_faults(model_, imposed.conflicts));
}

void MechanismReport::require_finite(const Eigen::MatrixXd& values) const
{
    if (values.rows() == 0) return;
    for (Eigen::Index c = 0; c < values.cols(); ++c)
        if (!(values.col(c).cwiseAbs().maxCoeff<Eigen::PropagateNaN>() < largest_number))
            throw ModelError({{FaultKind::ResultsBeyondRange, {model_.load_cases[static_cast<std::size_t>(c)].id}}});
}

bool MechanismReport::has_too_few_members() const
{
    const Indeterminacy count = count_indeterminacy(structure_, system_.restraints().rotations.size());
    return !count.has_foundation && count.total() < 0;
}

std::optional<MechanismReport::SoftParts> MechanismReport::soft_parts() const
{
    constexpr double loose = 1e-9;
    constexpr double by_length = 0.01; // over n^4: a row of n members is softer by so much than one, and no looser
    const double n = static_cast<double>(structure_.members.size());
    const ReducedSystem::SoftMotion soft = system_.reduced().softest_motion();
    if (!std::isfinite(soft.condition)) return std::nullopt;
    return SoftParts{.warning = nearly_singular_fault(model_, soft.condition, system_.motion(soft.x).displacements,
                                                      model_dofs(structure_.kind).size()),
                     .is_nearly_loose = soft.stiffness <= std::min(loose, by_length / (n * n * n * n))};
}

void MechanismReport::require_finite_stiffness() const
{
    std::vector<NodeId> nodes;
    for (std::size_t node = 0; node < structure_.positions.size(); ++node)
        if (!has_finite_stiffness(NodeId(node))) nodes.emplace_back(node);
    if (!nodes.empty()) throw ModelError({beyond_range_fault(model_, nodes)});
}

bool MechanismReport::has_finite_stiffness(NodeId node) const
{
    for (std::size_t i = 0; i < model_dofs(structure_.kind).size(); ++i) {
        const std::int32_t row = system_.equations().of(node, i);
        if (row == Equations::none) continue;
        if (!(std::abs(system_.reduced().stiffness().coeff(row, row)) < largest_number)) return false;
    }
    return true;
}

/// Free motions of the system, and what it does not see: internal mechanisms of members, restrained rotations that a
/// load drives.
void MechanismReport::refuse(const Eigen::MatrixXd& modes) const
{
    const Eigen::Index n_described = std::min(modes.cols(), most_described);
    std::vector<Mechanism> mechanisms = member_mechanisms(model_, system_.assembler());
    append(mechanisms, described(modes.leftCols(n_described)));
    const std::vector<CaseLoads> loads = loads_of(model_, structure_);
    append(mechanisms, driven(loads, system_.load_vectors(loads)));
    std::vector<Fault> causes;
    if (modes.cols() > 0) causes = unheld_parts(model_, structure_);
    causes.resize(std::min<std::size_t>(causes.size(), most_described));
    throw MechanismError(std::move(mechanisms), static_cast<std::size_t>(modes.cols() - n_described),
                         std::move(causes));
}

std::vector<Mechanism> MechanismReport::described(const Eigen::MatrixXd& modes) const
{
    std::vector<detail::CaseSolution> motions;
    for (const auto mode : modes.colwise()) motions.push_back(system_.motion(mode));
    return mechanisms_of(model_, system_.structure(), system_.equations(), std::move(motions));
}

/// Rotations that are restrained because nothing takes part in them, but that loads drive.
std::vector<Mechanism> MechanismReport::driven(const std::vector<CaseLoads>& loads, const Eigen::MatrixXd& F) const
{
    std::vector<Mechanism> mechanisms = loaded_rotations(model_, structure_, F, system_.restraints().rotations);
    append(mechanisms, loaded_twists(model_, system_.assembler(), loads));
    return mechanisms;
}

} // namespace femoop
