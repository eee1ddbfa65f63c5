#include "femoop/methods/cross/problem.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <string_view>

#include "femoop/analysis/static_system.h"
#include "femoop/methods/cross/kinematics.h"
#include "femoop/methods/cross/member_action.h"
#include "femoop/methods/cross/overhang.h"
#include "femoop/methods/cross/symmetry.h"
#include "femoop/model/check/check.h"
#include "femoop/model/quantity/number_text.h"

namespace femoop::cross {

namespace {

constexpr double no_stiffness = 1e-13;   // of 4EI/L: what condensing a release leaves
constexpr double no_moment = 1e-9;       // of the largest moment: a free joint bears no more
constexpr double nice_fixed_end = 100.0; // the largest fixed-end moment of a sway's sheet
constexpr double same_multiple = 1e-9;   // of EI/L
constexpr double no_strain = 1e-12;      // what rounding leaves of heat that only bends

bool skews(const Member& member, const MemberGeometry& geometry)
{
    const auto is_skew = [&](const MemberEnd& end) {
        if (end.offset.empty()) return false;
        const double across = geometry.axes(1, 0) * end.offset[0] + geometry.axes(1, 1) * end.offset[1];
        return std::abs(across) > 1e-9 * geometry.length;
    };
    return is_skew(member.start) || is_skew(member.end);
}

bool has_axial_spring(const Member& member)
{
    const auto is_axial = [](const Spring& spring) { return spring.dof == Dof::ux; };
    return std::ranges::any_of(member.start.springs, is_axial) || std::ranges::any_of(member.end.springs, is_axial);
}

/// What the method cannot do, all of it.
void require_suitable(const Model& model)
{
    require_sound(model);
    if (model.analysis != AnalysisKind::Frame2d)
        throw ModelError({{FaultKind::CrossNeedsPlaneFrame, {std::string(name(model.analysis))}}});
    if (model.n_cases() == 0) throw ModelError({{FaultKind::CrossWithoutCase, {}}});
    if (model.nodes.size() > most_nodes)
        throw ModelError(
            {{FaultKind::CrossTooLarge, {std::to_string(model.nodes.size()), std::to_string(most_nodes)}}});
    std::vector<Fault> faults;
    const Discretisation structure = discretise(model);
    for (std::size_t i = 0; i < model.members.size(); ++i) {
        const Member& member = model.members[i];
        if (member.rigid) faults.push_back({FaultKind::CrossRigidMember, {member.id}});
        if (skews(member, structure.geometry(MemberId(i)))) faults.push_back({FaultKind::CrossSkewOffset, {member.id}});
        if (has_axial_spring(member)) faults.push_back({FaultKind::CrossAxialSpring, {member.id}});
    }
    if (!faults.empty()) throw ModelError(std::move(faults));
}

/// Builds a problem part after part.
class Builder {
public:
    Builder(const Model& model, CaseId load_case, FarEnds far_ends) : model_(model), structure_(discretise(model))
    {
        problem_.load_case = load_case;
        problem_.far_ends = far_ends;
        const std::vector<CaseLoads> loads = loads_of(model, structure_);
        const CaseTerms terms = cases_of(model)[load_case.index];
        members_ = loaded_members(structure_, loads, terms);
        forces_ = case_forces(structure_, loads, terms);
    }

    Problem build()
    {
        const Overhangs overhangs = take_off_overhangs(structure_, members_, forces_);
        Motion motion = motion_of(structure_, taking_part(overhangs), ties(), forces_.settlement);
        if (motion.is_contradictory) refuse_contradiction();
        carry_over_load(overhangs, motion.imposed);
        for (Motion::Mode& mode : motion.modes) carry_over_load(overhangs, mode.displacement);
        problem_.imposed = motion.imposed;
        add_imposed();
        add_springs();
        add_bar_forces();
        problem_.node_force = forces_.node_force;
        for (const LoadedMember& member : members_) problem_.members.push_back(member.action);
        add_ends();
        add_joints();
        condense_far_ends();
        find_factors();
        read_loading();
        for (const Motion::Mode& mode : motion.modes) problem_.sways.push_back(sway(mode));
        name_ends();
        return std::move(problem_);
    }

private:
    std::vector<bool> taking_part(const Overhangs& overhangs) const
    {
        std::vector<bool> is_part = structure_.is_attached;
        for (std::size_t i = 0; i < is_part.size(); ++i) is_part[i] = is_part[i] && !overhangs.is_tip[i];
        return is_part;
    }

    std::vector<AxialTie> ties() const
    {
        std::vector<AxialTie> found;
        for (const LoadedMember& member : members_) {
            const MemberAction& action = member.action;
            if (!action.is_overhang && action.is_axially_rigid)
                found.push_back({action.nodes[0], action.nodes[1], action.x, member.elongation});
        }
        return found;
    }

    /// Settlements and changes of length that axially rigid members cannot follow.
    [[noreturn]] void refuse_contradiction() const
    {
        std::vector<std::string> all, heated;
        for (const MemberId member : contradicting_members()) {
            const LoadedMember& loaded = members_[member.index];
            all.push_back(model_[member].id);
            if (std::abs(loaded.elongation) > no_strain * loaded.action.length) heated.push_back(model_[member].id);
        }
        const FaultKind kind = heated.empty() ? FaultKind::CrossHeldSettlement : FaultKind::CrossHeldElongation;
        throw ModelError({{kind, {listed(heated.empty() ? all : heated), model_.case_name(problem_.load_case)}}});
    }

    /// Those that the constraints of such members speak of, in the load cases that the case sums.
    std::vector<MemberId> contradicting_members() const
    {
        const auto rigid = std::make_shared<const Discretisation>(discretise(inextensible_copy(model_)));
        const StaticSystem system(rigid, SolverKind::Automatic);
        const CaseTerms terms = terms_of(model_, problem_.load_case);
        std::set<MemberId> members;
        for (const auto& conflict : system.imposed(loads_of(model_, *rigid)).conflicts)
            if (std::ranges::find(terms.terms, conflict.load_case, &CaseTerms::Term::load_case) != terms.terms.end())
                members.insert(conflict.members.begin(), conflict.members.end());
        return {members.begin(), members.end()};
    }

    bool turns(NodeId node) const
    {
        const Discretisation::SupportRow* support = structure_.support_of(node);
        return support == nullptr || !support->blocked.contains(Dof::rz);
    }

    double rotational_spring(NodeId node) const
    {
        const Discretisation::SupportRow* support = structure_.support_of(node);
        return support == nullptr ? 0.0 : support->springs[index(Dof::rz)];
    }

    /// What settlements, heat and turned supports do to members whose joints are locked.
    void add_imposed()
    {
        for (LoadedMember& member : members_) {
            MemberAction& action = member.action;
            if (action.is_overhang) continue;
            Eigen::Vector4d d;
            for (int end = 0; end < 2; ++end) {
                const NodeId node = action.nodes[static_cast<std::size_t>(end)];
                d[2 * end] = action.y.dot(problem_.imposed[node.index]);
                d[2 * end + 1] = turns(node) ? 0.0 : forces_.turn[node.index];
            }
            action.f += action.K * d;
        }
    }

    void add_springs()
    {
        for (const Discretisation::SupportRow& support : structure_.supports) {
            const Eigen::Matrix2d axes = support_axes(structure_, support.node);
            for (const int axis : {0, 1})
                if (const double k = support.springs[static_cast<std::size_t>(axis)]; k > 0.0)
                    problem_.springs.push_back({.node = support.node,
                                                .direction = axes.row(axis).transpose(),
                                                .stiffness = k,
                                                .ground = forces_.settlement[support.node.index][axis]});
        }
    }

    void add_bar_forces()
    {
        for (const LoadedMember& member : members_)
            for (std::size_t end = 0; end < 2; ++end)
                forces_.node_force[member.action.nodes[end].index] -= member.bar_force[end];
    }

    void add_ends()
    {
        for (std::size_t n = 0; n < model_.nodes.size(); ++n) {
            for (std::size_t m = 0; m < members_.size(); ++m)
                for (std::size_t which = 0; which < 2; ++which)
                    if (problem_.members[m].nodes[which] == NodeId(n) && problem_.members[m].EI_over_L > 0.0)
                        add_end(MemberId(m), which);
            if (const double k = rotational_spring(NodeId(n)); k > 0.0)
                problem_.ends.push_back(
                    {.node = NodeId(n), .member = {}, .far = {}, .joint = {}, .label = {}, .stiffness = k});
        }
        for (MemberAction& action : problem_.members)
            for (std::size_t which = 0; which < 2; ++which)
                if (action.ends[which]) problem_.ends[action.ends[which]->index].far = action.ends[1 - which];
    }

    void add_end(MemberId member, std::size_t which)
    {
        MemberAction& action = problem_.members[member.index];
        action.ends[which] = EndId(problem_.ends.size());
        problem_.ends.push_back({.node = action.nodes[which],
                                 .member = member,
                                 .which = which,
                                 .far = {},
                                 .joint = {},
                                 .label = {},
                                 .stiffness = 0.0,
                                 .carry_over = 0.0,
                                 .factor = 0.0,
                                 .is_overhang = action.is_overhang});
    }

    double own_stiffness(const End& end) const
    {
        if (!end.member) return end.stiffness;
        const MemberAction& action = problem_.members[end.member->index];
        const auto row = static_cast<Eigen::Index>(2 * end.which + 1);
        const double s = action.K(row, row);
        return s > no_stiffness * action.EI_over_L ? s : 0.0;
    }

    /// Nodes that turn against some stiffness.
    void add_joints()
    {
        std::vector<std::vector<EndId>> ends_at(model_.nodes.size());
        for (std::size_t e = 0; e < problem_.ends.size(); ++e) ends_at[problem_.ends[e].node.index].emplace_back(e);
        for (std::size_t n = 0; n < ends_at.size(); ++n) {
            if (!turns(NodeId(n))) continue;
            double stiffness = 0.0;
            for (const EndId e : ends_at[n]) stiffness += own_stiffness(problem_[e]);
            if (stiffness > 0.0) problem_.joints.push_back({.node = NodeId(n), .ends = ends_at[n], .stiffness = 0.0});
            else require_no_moment(NodeId(n), ends_at[n]);
        }
    }

    void require_no_moment(NodeId node, const std::vector<EndId>& ends) const
    {
        double moment = forces_.node_moment[node.index];
        double largest = std::abs(moment);
        for (const EndId e : ends) {
            const double own = fixed_end(problem_[e]);
            moment -= own;
            largest = std::max(largest, std::abs(own));
        }
        const bool is_tip = std::ranges::any_of(ends, [&](EndId e) { return problem_[e].is_overhang; });
        if (std::abs(moment) <= no_moment * largest || (is_tip && ends.size() == 1)) return;
        throw ModelError(
            {{FaultKind::CrossJointFree, {model_[node].id, quantity_text(moment, dimension::moment, model_.units)}}});
    }

    double fixed_end(const End& end) const
    {
        if (!end.member) return -end.stiffness * forces_.turn[end.node.index];
        return problem_.members[end.member->index].f[static_cast<Eigen::Index>(2 * end.which + 1)];
    }

    /// The one end that resists a joint's rotation, where there is but one.
    std::optional<EndId> lone_end(const Joint& joint) const
    {
        std::optional<EndId> lone;
        for (const EndId e : joint.ends) {
            if (own_stiffness(problem_[e]) == 0.0) continue;
            if (lone || !problem_[e].member) return std::nullopt;
            lone = e;
        }
        return lone;
    }

    void condense_far_ends()
    {
        if (problem_.far_ends == FarEnds::Plain) return;
        std::vector<std::optional<EndId>> lone;
        for (const Joint& joint : problem_.joints) lone.push_back(lone_end(joint));
        for (std::size_t j = 0; j < lone.size(); ++j) {
            if (!lone[j]) continue;
            if (problem_.far_ends == FarEnds::Modified) condense(problem_.joints[j], *lone[j]);
            else problem_.joints[j].is_released_once = can_be_released_once(*lone[j], lone);
        }
        if (problem_.far_ends == FarEnds::Modified)
            std::erase_if(problem_.joints, [](const Joint& joint) { return joint.is_released_once; });
    }

    bool can_be_released_once(EndId end, const std::vector<std::optional<EndId>>& lone) const
    {
        const std::optional<EndId> far = problem_[end].far;
        return !problem_.members[problem_[end].member->index].has_foundation &&
               std::ranges::find(lone, far) == lone.end();
    }

    /// Lets the joint turn: its end keeps the moment that the joint's load leaves for it.
    void condense(Joint& joint, EndId lone)
    {
        double moment = forces_.node_moment[joint.node.index];
        for (const EndId e : joint.ends)
            if (e != lone) moment -= fixed_end(problem_[e]);
        joint.is_released_once = true;
        if (own_stiffness(problem_[lone]) == 0.0) return require_no_moment(joint.node, joint.ends);
        MemberAction& action = problem_.members[problem_[lone].member->index];
        const auto row = static_cast<Eigen::Index>(2 * problem_[lone].which + 1);
        const Eigen::Vector4d column = action.K.col(row) / action.K(row, row);
        action.f += column * (moment - action.f[row]);
        action.f[row] = moment;
        action.K -= (column * action.K.row(row)).eval();
        action.K.row(row).setZero();
        action.K.col(row).setZero();
        problem_.ends[lone.index].is_hinged = true;
    }

    void find_factors()
    {
        for (std::size_t j = 0; j < problem_.joints.size(); ++j)
            for (const EndId e : problem_.joints[j].ends) problem_.ends[e.index].joint = JointId(j);
        for (End& end : problem_.ends) {
            end.stiffness = own_stiffness(end);
            if (end.far && end.stiffness > 0.0) set_carry_over(end);
            if (end.joint) problem_.joints[end.joint->index].stiffness += end.stiffness;
        }
        for (End& end : problem_.ends)
            if (end.is_hinged) end.factor = 1.0;
            else if (end.joint) end.factor = end.stiffness / problem_.joints[end.joint->index].stiffness;
    }

    void set_carry_over(End& end) const
    {
        const Eigen::Matrix4d& K = problem_.members[end.member->index].K;
        const auto near = static_cast<Eigen::Index>(2 * end.which + 1), far = 4 - near;
        const std::optional<JointId> far_joint = problem_[*end.far].joint;
        const bool is_near_lone = end.joint && problem_[*end.joint].is_released_once;
        if (far_joint && problem_[*far_joint].is_released_once && !is_near_lone)
            end.stiffness -= K(near, far) * K(near, far) / K(far, far);
        else end.carry_over = K(near, far) / K(near, near);
    }

    void read_loading()
    {
        for (const End& end : problem_.ends) problem_.loading.fixed_end.push_back(fixed_end(end));
        for (const Joint& joint : problem_.joints)
            problem_.loading.joint_load.push_back(forces_.node_moment[joint.node.index]);
    }

    Sway sway(const Motion::Mode& mode) const
    {
        Sway sway{.prop = mode.node, .direction = mode.direction, .displacement = mode.displacement, .loading = {}};
        sway.loading.fixed_end.assign(problem_.ends.size(), 0.0);
        sway.loading.joint_load.assign(problem_.joints.size(), 0.0);
        double largest = 0.0;
        for (const MemberAction& action : problem_.members) {
            Eigen::Vector4d d = Eigen::Vector4d::Zero();
            for (int end = 0; end < 2; ++end)
                d[2 * end] = action.y.dot(mode.displacement[action.nodes[static_cast<std::size_t>(end)].index]);
            sway.chord_rotation.push_back(action.is_overhang ? 0.0 : (d[2] - d[0]) / action.length);
            const Eigen::Vector4d p = action.K * d;
            for (std::size_t which = 0; which < 2; ++which) {
                if (!action.ends[which]) continue;
                const double moment = p[static_cast<Eigen::Index>(2 * which + 1)];
                sway.loading.fixed_end[action.ends[which]->index] = moment;
                largest = std::max(largest, std::abs(moment));
            }
        }
        sway.scale = largest > 0.0 ? nice_fixed_end / largest : 1.0;
        for (double& moment : sway.loading.fixed_end) moment *= sway.scale;
        return sway;
    }

    /// "AB"; where two ends would be called the same, or nodes have names of several words, "A-B", and of members side
    /// by side "A-B (m)".
    void name_ends()
    {
        const auto name = [&](const End& end, std::string_view between) {
            if (!end.member) return model_[end.node].id + " spring";
            const auto& nodes = model_[*end.member].nodes;
            return model_[nodes[end.which]].id + std::string(between) + model_[nodes[1 - end.which]].id;
        };
        const auto has_words = [](const Node& node) { return node.id.find(' ') != std::string::npos; };
        const bool are_words = std::ranges::any_of(model_.nodes, has_words);
        for (const std::string_view between : {"", "-"}) {
            if (between.empty() && are_words) continue;
            std::map<std::string, int> count;
            for (End& end : problem_.ends) ++count[end.label = name(end, between)];
            if (std::ranges::all_of(count, [](const auto& entry) { return entry.second == 1; })) return;
            if (between.empty()) continue;
            for (End& end : problem_.ends)
                if (end.member && count[end.label] > 1) end.label += " (" + model_[*end.member].id + ")";
        }
    }

    const Model& model_;
    Discretisation structure_;
    std::vector<LoadedMember> members_;
    CaseForces forces_;
    Problem problem_;
};

} // namespace

std::optional<JointId> Problem::joint_at(NodeId node) const
{
    const auto at = std::ranges::find(joints, node, &Joint::node);
    if (at == joints.end()) return std::nullopt;
    return JointId(static_cast<std::size_t>(at - joints.begin()));
}

std::optional<EndId> Problem::find_end(std::string_view label) const
{
    const auto at = std::ranges::find(ends, label, &End::label);
    if (at == ends.end()) return std::nullopt;
    return EndId(static_cast<std::size_t>(at - ends.begin()));
}

bool Problem::is_balanced(JointId joint) const
{
    if (halves.empty()) return !mirror || mirror->is_balanced[joint.index];
    return std::ranges::any_of(halves, [&](const Problem& half) { return half.is_balanced(joint); });
}

std::vector<JointId> Problem::balanced_joints() const
{
    std::vector<JointId> balanced;
    for (std::size_t j = 0; j < joints.size(); ++j)
        if (is_balanced(JointId(j))) balanced.emplace_back(j);
    return balanced;
}

std::optional<JointId> Problem::balanced_for(JointId joint) const
{
    if (is_balanced(joint)) return joint;
    const JointId image = mirror ? mirror->joints[joint.index] : joint;
    return is_balanced(image) ? std::optional(image) : std::nullopt;
}

Problem problem_of(const Model& model, CaseId load_case, FarEnds far_ends, Extent extent)
{
    require_suitable(model);
    Problem whole = Builder(model, load_case, far_ends).build();
    return extent == Extent::Half ? by_halves(model, whole) : whole;
}

Model inextensible_copy(const Model& model)
{
    Model copy = model;
    for (Member& member : copy.members) member.inextensible = !member.rigid;
    return copy;
}

std::vector<std::string> joint_names(const Model& model, const Problem& problem)
{
    std::vector<std::string> names;
    for (const JointId joint : problem.balanced_joints()) names.push_back(model[problem[joint].node].id);
    return names;
}

std::string_view formula(const Problem& problem, EndId id)
{
    const End& end = problem[id];
    if (!end.member) return "";
    if (end.stiffness == 0.0) return "0";
    const MemberAction& member = problem.members[end.member->index];
    if (member.is_tapered) return "";
    const double multiple = end.stiffness / member.EI_over_L;
    const std::array<std::pair<double, std::string_view>, 4> known{
        {{4.0, "4EI/L"}, {3.0, "3EI/L"}, {2.0, "2EI/L"}, {6.0, "6EI/L"}}};
    for (const auto& [times, text] : known)
        if (std::abs(multiple - times) < same_multiple * times) return text;
    return "";
}

} // namespace femoop::cross
