#include "femoop/methods/counting/counting.h"

#include <algorithm>
#include <map>
#include <memory>
#include <numeric>
#include <span>
#include <utility>

#include "femoop/analysis/compatibility.h"
#include "femoop/analysis/member_mechanism.h"
#include "femoop/analysis/static_system.h"
#include "femoop/discretisation/parts.h"
#include "femoop/model/check/check.h"

namespace femoop::counting {

namespace {

constexpr Eigen::Index most_motions = 64;

/// The displacements in which joints can let go a section force that a model knows.
std::vector<LocalAxis> released_axes(AnalysisKind kind)
{
    using enum LocalAxis;
    switch (kind) {
    case AnalysisKind::Truss2d:
    case AnalysisKind::Truss3d: return {x};
    case AnalysisKind::Frame2d: return {x, y, rz};
    case AnalysisKind::Grillage: return {y, rx, rz};
    case AnalysisKind::Frame3d: break;
    }
    return {x, y, z, rx, ry, rz};
}

bool is_released(const MemberEndConditions& conditions, std::size_t end, LocalAxis axis)
{
    if (conditions.is_bar && is_rotation(axis)) return true;
    return conditions.joints[end][index(axis)] == 0.0 && (!conditions.is_bar || axis == LocalAxis::x);
}

/// A member that is released about its own axis at both ends turns by itself: its second release holds nothing back.
bool is_twist_free_already(const MemberEndConditions& conditions, std::size_t end, LocalAxis axis)
{
    return axis == LocalAxis::rx && end == 1 && is_released(conditions, 0, axis);
}

/// How many section forces each end of a member lets go.
std::array<int, 2> released_at_ends(const MemberEndConditions& conditions, AnalysisKind kind)
{
    std::array<int, 2> released{};
    for (std::size_t end = 0; end < 2; ++end)
        for (const LocalAxis axis : released_axes(kind))
            if (is_released(conditions, end, axis) && !is_twist_free_already(conditions, end, axis)) ++released[end];
    return released;
}

std::vector<ReleasedJoint> released_joints(const Discretisation& structure,
                                           std::span<const ArtificialRestraint> free_rotations)
{
    std::map<NodeId, ReleasedJoint> joints;
    for (std::size_t i = 0; i < structure.members.size(); ++i) {
        const MemberEndConditions* conditions = structure.end_conditions_of(MemberId(i));
        if (conditions == nullptr) continue;
        const std::array<int, 2> released = released_at_ends(*conditions, structure.kind);
        for (std::size_t end = 0; end < 2; ++end)
            if (released[end] > 0)
                joints[structure.members[i].nodes[end]].ends.push_back({MemberId(i), end, released[end]});
    }
    for (const ArtificialRestraint& rotation : free_rotations) ++joints[rotation.parts.front().node].n_free_rotations;
    std::vector<ReleasedJoint> list;
    for (auto& [node, joint] : joints) {
        joint.node = node;
        list.push_back(std::move(joint));
    }
    return list;
}

std::vector<SupportReactions> reactions_of(const Discretisation& structure)
{
    std::vector<SupportReactions> list;
    for (const Discretisation::SupportRow& support : structure.supports)
        if (structure.is_attached[support.node.index])
            list.push_back({.node = support.node,
                            .n_blocked = support.blocked.size(),
                            .n_springs = static_cast<int>(
                                std::ranges::count_if(support.springs, [](double k) { return k > 0.0; }))});
    return list;
}

std::vector<NodeId> loose_nodes(const Discretisation& structure)
{
    std::vector<NodeId> nodes;
    for (std::size_t i = 0; i < structure.positions.size(); ++i)
        if (!structure.is_attached[i]) nodes.emplace_back(i);
    return nodes;
}

bool has_foundation(const Discretisation& structure)
{
    return std::ranges::any_of(structure.properties, [](const auto& p) { return p.xy.foundation > 0.0; });
}

/// Of the equations, and of members that their own releases leave loose, which stand in none.
std::optional<std::size_t> n_motions(const StaticSystem& system)
{
    const std::size_t n_loose = loose_members(system.assembler()).size();
    if (system.equations().n_unknowns() == 0) return n_loose;
    const NullModes free = Compatibility(system.assembler(), system.restraints()).free_motions(most_motions);
    return free.is_complete ? std::optional(static_cast<std::size_t>(free.modes.cols()) + n_loose) : std::nullopt;
}

int sum_of_counts(const auto& list)
{
    return std::accumulate(list.begin(), list.end(), 0, [](int sum, const auto& one) { return sum + one.count(); });
}

} // namespace

int ReleasedJoint::count() const
{
    return std::accumulate(ends.begin(), ends.end(), -n_free_rotations,
                           [](int sum, const End& end) { return sum + end.n_released; });
}

int Counting::n_released() const { return sum_of_counts(releases); }
int Counting::n_reactions() const { return sum_of_counts(reactions); }

Indeterminacy Counting::degree() const
{
    const int equations = equations_per_part() * static_cast<int>(n_parts);
    Indeterminacy degree{.external = n_reactions() - equations, .has_foundation = has_foundation};
    if (is_truss(kind))
        degree.internal = static_cast<int>(n_members) - n_released() -
                          (equations_per_joint() * static_cast<int>(n_joints) - equations);
    else degree.internal = forces_per_ring() * static_cast<int>(rings.size()) - n_released();
    return degree;
}

Counting count(const Model& model)
{
    require_sound(model);
    const auto structure = std::make_shared<const Discretisation>(discretise(model));
    StaticSystem system(structure, SolverKind::Automatic);
    system.assemble();
    Counting counting{.kind = structure->kind,
                      .n_members = structure->members.size(),
                      .n_joints = n_joints(*structure),
                      .n_parts = n_parts(*structure),
                      .releases = released_joints(*structure, system.restraints().rotations),
                      .reactions = reactions_of(*structure),
                      .loose_nodes = loose_nodes(*structure),
                      .has_foundation = has_foundation(*structure),
                      .n_motions = n_motions(system)};
    if (!is_truss(structure->kind)) counting.rings = rings(*structure);
    return counting;
}

} // namespace femoop::counting
