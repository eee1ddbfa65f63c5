#include "femoop/analysis/mechanism_report.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <span>
#include <utility>

#include "femoop/analysis/compatibility.h"
#include "femoop/analysis/driven_rotation.h"
#include "femoop/analysis/equilibrium.h"
#include "femoop/analysis/mechanism_description.h"
#include "femoop/analysis/overflow_check.h"
#include "femoop/analysis/rigid_body.h"
#include "femoop/element/analysis_model.h"

namespace femoop {

namespace {

constexpr Eigen::Index most_modes = 64;     // to look for in a structure that moves in many ways
constexpr Eigen::Index most_described = 12; // of them: who reads more sentences than that?

Eigen::Index n_described(std::size_t n) { return std::min(static_cast<Eigen::Index>(n), most_described); }

} // namespace

MechanismReport::MechanismReport(const Model& model, const StaticSystem& system)
    : model_(model), system_(system), structure_(*system.structure())
{}

void MechanismReport::require_geometric_stability() const
{
    require_finite_stiffness();
    if (has_vanishing_member()) return;
    const NullModes free = Compatibility(system_.assembler(), system_.restraints()).free_motions(most_modes);
    if (free.is_singular()) refuse(free.modes);
}

void MechanismReport::require_held_members() const
{
    if (!loose_members(system_.assembler()).empty()) refuse({});
}

void MechanismReport::require_undriven(const std::vector<CaseLoads>& loads, const Eigen::MatrixXd& F) const
{
    Found found;
    add_driven(loads, F, found);
    if (!found.mechanisms.empty()) throw MechanismError(std::move(found.mechanisms), found.n_more);
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

bool MechanismReport::has_vanishing_member() const
{
    constexpr double vanishing = 1e-20; // of the structure's size: its strains hide those of all others
    for (std::size_t i = 0; i < structure_.members.size(); ++i)
        if (structure_.geometry(MemberId(i)).length < vanishing * structure_.size()) return true;
    return false;
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
    Found found;
    add_members(loose_members(system_.assembler()), found);
    add_motions(modes, found);
    const std::vector<CaseLoads> loads = loads_of(model_, structure_);
    add_driven(loads, system_.load_vectors(loads), found);
    std::vector<Fault> causes;
    if (modes.cols() > 0) causes = unheld_parts(model_, structure_);
    causes.resize(std::min<std::size_t>(causes.size(), most_described));
    throw MechanismError(std::move(found.mechanisms), found.n_more, std::move(causes));
}

void MechanismReport::add_motions(const Eigen::MatrixXd& modes, Found& found) const
{
    const auto n = static_cast<std::size_t>(modes.cols());
    std::vector<detail::CaseSolution> motions;
    for (const auto mode : modes.leftCols(n_described(n)).colwise()) motions.push_back(system_.motion(mode));
    found.n_more += n - motions.size();
    std::ranges::move(mechanisms_of(model_, system_.structure(), system_.equations(), std::move(motions)),
                      std::back_inserter(found.mechanisms));
}

void MechanismReport::add_members(const std::vector<LooseMember>& members, Found& found) const
{
    const auto n = static_cast<std::size_t>(n_described(members.size()));
    for (const LooseMember& loose : std::span(members).first(n))
        found.mechanisms.push_back(member_mechanism(model_, structure_, loose));
    found.n_more += members.size() - n;
}

/// Rotations that are restrained because nothing takes part in them, but that loads drive.
void MechanismReport::add_driven(const std::vector<CaseLoads>& loads, const Eigen::MatrixXd& F, Found& found) const
{
    std::size_t n = 0;
    DrivenRotations driven(system_.assembler(), loads, F);
    for (const ArtificialRestraint& rotation : system_.restraints().rotations)
        if (driven.contains(rotation) && n++ < static_cast<std::size_t>(most_described))
            found.mechanisms.push_back(rotation_mechanism(model_, structure_, rotation));
    found.n_more += n - static_cast<std::size_t>(n_described(n));
    add_members(loaded_twists(system_.assembler(), loads), found);
}

} // namespace femoop
