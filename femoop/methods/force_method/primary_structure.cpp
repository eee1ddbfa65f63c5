#include "femoop/methods/force_method/primary_structure.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <utility>

#include "femoop/edit/split.h"
#include "femoop/geometry/member_geometry.h"
#include "femoop/geometry/node_position.h"
#include "femoop/load/place_along.h"
#include "femoop/methods/influence/effect_name.h"
#include "femoop/methods/unit_load_case.h"
#include "femoop/methods/virtual_work/loaded_structure.h"
#include "femoop/model/check/check.h"
#include "femoop/model/fault/errors_among.h"

namespace femoop::force_method {

namespace {

constexpr double nearness = 1e-9; ///< of a member's length: places that are nearer are one

double length_of(const Model& model, MemberId member) { return geometry_of(model, model[member]).length; }

/// Of the member's end, what a section force works on.
Dof dof_of(MemberComponent force) { return all_dofs[index(virtual_work::axis_of(force))]; }

/// Of a positive section force on the end whose face is +x'.
double sign_on_second_end(Dof dof) { return dof == Dof::uy || dof == Dof::uz || dof == Dof::ry ? -1.0 : 1.0; }

bool is_bar(const Model& model, MemberId member) { return model[member].bar || is_truss(model.analysis); }

std::optional<std::size_t> end_of(const Model& model, const Redundant& section)
{
    const double length = length_of(model, *section.member);
    return end_at(along(*section.at, length), length);
}

bool carries(const Model& model, const Redundant& asked)
{
    const Dof dof = dof_of(*asked.component);
    if (is_bar(model, *asked.member)) return dof == Dof::ux;
    const Member& member = model[*asked.member];
    const auto end = end_of(model, asked);
    if (!end) return true;
    const MemberEnd& joint = *end == 0 ? member.start : member.end;
    const bool is_hinged = model[member.nodes.at(*end)].hinge && is_rotation(dof);
    return !joint.release.contains(dof) && !is_hinged;
}

bool carries_force(const Model& model, const Redundant& asked)
{
    if (asked.member) return carries(model, asked);
    const auto& support = model[*asked.node].support;
    return support && holds(*support, *asked.dof, model.analysis);
}

/// Takes out the spring along a degree of freedom. \returns its flexibility, 0 without one
double take_spring(std::vector<Spring>& springs, Dof dof)
{
    const auto spring = std::ranges::find(springs, dof, &Spring::dof);
    if (spring == springs.end()) return 0.0;
    const double flexibility = 1.0 / spring->stiffness;
    springs.erase(spring);
    return flexibility;
}

/// Takes out what a load case imposes on a support. \returns how much it was
double take_settlement(LoadCase& load_case, const Release& release)
{
    double imposed = 0.0;
    for (Settlement& settlement : load_case.settlements) {
        if (settlement.node != release.node) continue;
        for (const Component& one : settlement.components) imposed += one.dof == release.dof ? one.value.value() : 0.0;
        std::erase_if(settlement.components, [&](const Component& one) { return one.dof == release.dof; });
    }
    std::erase_if(load_case.settlements, [](const Settlement& one) { return one.components.empty(); });
    return imposed;
}

/// Makes the primary structure of a model, one redundant after the other.
class Releasing {
public:
    explicit Releasing(const Model& model)
    {
        primary_.model = without_loads(model);
        primary_.model.load_cases = model.load_cases;
        primary_.imposed.resize(model.load_cases.size());
        for (std::size_t i = 0; i < model.members.size(); ++i)
            primary_.parts.push_back({{MemberId(i), 0.0, length_of(model, MemberId(i))}});
    }

    /// All cuts come before the first release, which belongs to an end.
    void cut(const Redundant& redundant)
    {
        if (!redundant.member) return;
        std::vector<Part>& parts = primary_.parts[redundant.member->index];
        const double length = parts.back().end, x = along(*redundant.at, length);
        if (end_at(x, length)) return;
        const auto part = std::ranges::find_if(parts, [&](const Part& one) {
            return one.begin < x - nearness * length && one.end > x + nearness * length;
        });
        if (part == parts.end()) return; // cut there already
        const SplitMember cut = split_member(primary_.model, part->member, x - part->begin);
        const Part beyond{cut.second, x, part->end};
        part->end = x;
        parts.insert(part + 1, beyond);
    }

    void release(const Redundant& redundant)
    {
        Release release = redundant.member ? section(redundant) : support(redundant);
        release.flexibility = release.member ? release_end(release) : release_support(release);
        for (std::size_t i = 0; i < primary_.imposed.size(); ++i)
            primary_.imposed[i].push_back(release.member ? 0.0
                                                         : take_settlement(primary_.model.load_cases[i], release));
        primary_.releases.push_back(release);
    }

    PrimaryStructure take() { return std::move(primary_); }

private:
    using Part = PrimaryStructure::Part;

    // At a jump a place is read on its + side, so that the cut is at the start of what lies beyond.
    Release section(const Redundant& redundant) const
    {
        const std::vector<Part>& parts = primary_.parts[redundant.member->index];
        const double length = parts.back().end, x = along(*redundant.at, length);
        const bool is_before = redundant.side == Side::Before && x > nearness * length;
        const auto begins_there = [&](const Part& one) { return std::abs(one.begin - x) <= nearness * length; };
        const auto ends_there = [&](const Part& one) { return std::abs(one.end - x) <= nearness * length; };
        auto part = is_before ? parts.end() : std::ranges::find_if(parts, begins_there);
        const std::size_t end = part == parts.end() ? 1 : 0;
        if (end == 1) part = std::ranges::find_if(parts, ends_there);
        const Member& member = primary_.model[part->member];
        const Dof dof = dof_of(*redundant.component);
        const auto axis = static_cast<Eigen::Index>(index(dof) % 3);
        return {.node = member.nodes.at(end),
                .member = part->member,
                .end = end,
                .dof = dof,
                .axis = geometry_of(primary_.model, member).axes.row(axis).transpose()};
    }

    Release support(const Redundant& redundant) const
    {
        const auto& support = primary_.model[*redundant.node].support;
        const double angle = support->angle * std::numbers::pi / 180.0;
        const auto axis = static_cast<Eigen::Index>(index(*redundant.dof) % 3);
        const Eigen::AngleAxisd turn(angle, Eigen::Vector3d::UnitZ());
        return {.node = *redundant.node, .dof = *redundant.dof, .axis = turn * Eigen::Vector3d::Unit(axis).eval()};
    }

    double release_end(const Release& release)
    {
        Member& member = primary_.model.members[release.member->index];
        MemberEnd& end = release.end == 0 ? member.start : member.end;
        end.release.insert(release.dof);
        return take_spring(end.springs, release.dof);
    }

    double release_support(const Release& release)
    {
        std::optional<Support>& support = primary_.model.nodes[release.node.index].support;
        support->fixed = support->blocked(primary_.model.analysis);
        support->kind = SupportKind::Custom;
        support->fixed.erase(release.dof);
        const double flexibility = take_spring(support->springs, release.dof);
        if (support->fixed.is_empty() && support->springs.empty()) support.reset();
        return flexibility;
    }

    PrimaryStructure primary_;
};

/// A force or couple along one axis, as components in global axes.
std::vector<Component> global_components(AnalysisKind kind, const Eigen::Vector3d& force, const Eigen::Vector3d& moment)
{
    std::vector<Component> components;
    for (const Dof dof : all_dofs) {
        const auto axis = static_cast<Eigen::Index>(index(dof) % 3);
        const double value = is_rotation(dof) ? moment[axis] : force[axis];
        if (dofs(kind).contains(dof) && value != 0.0) components.push_back({.dof = dof, .value = value});
    }
    return components;
}

} // namespace

bool holds(const Support& support, Dof dof, AnalysisKind kind)
{
    const auto is_along = [&](const Spring& spring) { return spring.dof == dof; };
    return support.blocked(kind).contains(dof) || std::ranges::any_of(support.springs, is_along);
}

std::optional<std::size_t> end_at(double x, double length)
{
    if (x <= nearness * length) return 0;
    return x >= length * (1.0 - nearness) ? std::optional<std::size_t>(1) : std::nullopt;
}

std::vector<Fault> check_redundants(const Model& model, std::span<const Redundant> redundants, const std::string& place)
{
    std::vector<Fault> faults;
    for (std::size_t i = 0; i < redundants.size(); ++i) {
        const Redundant& one = redundants[i];
        if (auto errors = errors_among(check_effect(model, one, {place, std::nullopt})); !errors.empty()) {
            std::ranges::move(errors, std::back_inserter(faults));
            continue;
        }
        const std::vector<std::string> words{place, influence::effect_name(model, one)};
        const bool is_section = one.quantity == ExpectedQuantity::SectionForce;
        if (!is_section && one.quantity != ExpectedQuantity::Reaction)
            faults.push_back({FaultKind::RedundantNoForce, words});
        else if (!carries_force(model, one)) faults.push_back({FaultKind::RedundantReleased, words});
        else if (is_section && is_bar(model, *one.member) && !end_of(model, one))
            faults.push_back({FaultKind::RedundantInsideBar, words});
        else if (std::ranges::find(redundants.first(i), one) != redundants.first(i).end())
            faults.push_back({FaultKind::RedundantTwice, words});
    }
    return faults;
}

PrimaryStructure primary_structure(const Model& model, std::span<const Redundant> redundants)
{
    Releasing releasing(model);
    for (const Redundant& redundant : redundants) releasing.cut(redundant);
    for (const Redundant& redundant : redundants) releasing.release(redundant);
    return releasing.take();
}

LoadCase unit_state(const Model& primary, const Release& release, std::string id)
{
    LoadCase state{.id = std::move(id)};
    const Eigen::Vector3d none = Eigen::Vector3d::Zero();
    Eigen::Vector3d force = is_rotation(release.dof) ? none : release.axis;
    Eigen::Vector3d moment = is_rotation(release.dof) ? release.axis : none;
    if (release.member) {
        const double sign = sign_on_second_end(release.dof) * (release.end == 0 ? -1.0 : 1.0);
        const std::vector<Component> on_end{{.dof = release.dof, .value = sign}};
        EndLoads loads{.axes = LoadAxes::Local};
        (release.end == 0 ? loads.start : loads.end) = on_end;
        state.members.push_back({*release.member, std::move(loads)});
        const MemberGeometry geometry = geometry_of(primary, primary[*release.member]);
        const Eigen::Vector3d arm = (release.end == 0 ? geometry.start : geometry.end) -
                                    position_of(primary, release.node);
        force *= -sign;
        moment = -sign * moment + arm.cross(force);
    }
    state.nodes.push_back({release.node, global_components(primary.analysis, force, moment)});
    return state;
}

} // namespace femoop::force_method
