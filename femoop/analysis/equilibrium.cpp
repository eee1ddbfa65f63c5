#include "femoop/analysis/equilibrium.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "femoop/discretisation/equations.h"
#include "femoop/discretisation/parts.h"
#include "femoop/result/end_vectors.h"

#include "femoop/element/analysis_model.h"

namespace femoop {

namespace {

/// A force and a moment, about the origin.
struct Wrench {
    Eigen::Vector3d force = Eigen::Vector3d::Zero();
    Eigen::Vector3d moment = Eigen::Vector3d::Zero();

    void add(const Eigen::Vector3d& F, const Eigen::Vector3d& M, const Eigen::Vector3d& at)
    {
        force += F;
        moment += M + at.cross(F);
    }
    NodeVector vector() const { return {force[0], force[1], force[2], moment[0], moment[1], moment[2]}; }
};

Eigen::Vector3d forces(const NodeVector& v) { return {v[0], v[1], v[2]}; }
Eigen::Vector3d moments(const NodeVector& v) { return {v[3], v[4], v[5]}; }

/// The loads of a member in its own axes, about its first end.
Wrench local_sum(std::span<const SpanLoad> loads)
{
    Wrench sum;
    for (const SpanLoad& load : loads) {
        if (load.kind == SpanLoad::Kind::Strain) continue;
        const auto axis = static_cast<int>(index(load.axis));
        double total = load.start;
        double at = load.from;
        if (load.kind == SpanLoad::Kind::Distributed) {
            const double length = load.to - load.from;
            total = 0.5 * (load.start + load.end) * length;
            const double first_moment = length * length * (load.start + 2.0 * load.end) / 6.0; // about `from`
            if (axis < 3) {
                sum.add(total * Eigen::Vector3d::Unit(axis), Eigen::Vector3d::Zero(), {load.from, 0.0, 0.0});
                sum.moment += Eigen::Vector3d::UnitX().cross(first_moment * Eigen::Vector3d::Unit(axis));
                continue;
            }
        }
        if (axis < 3) sum.add(total * Eigen::Vector3d::Unit(axis), Eigen::Vector3d::Zero(), {at, 0.0, 0.0});
        else sum.moment += total * Eigen::Vector3d::Unit(axis - 3);
    }
    return sum;
}

/// Moments that a plane model or a grillage does not know are no part of its sums.
NodeVector known(const Wrench& wrench, AnalysisKind kind)
{
    NodeVector v = wrench.vector();
    DofSet kept = dofs(kind);
    if (kind == AnalysisKind::Truss2d) kept.insert(Dof::rz);
    if (kind == AnalysisKind::Truss3d) kept = dofs(AnalysisKind::Frame3d);
    for (const Dof dof : all_dofs)
        if (!kept.contains(dof)) v[index(dof)] = 0.0;
    return v;
}

// Of reactions: loads that cancel at every node, as those of heat do in a row of alike members, leave rounding, which no
// residual is measured by.
constexpr double negligible_loads = 1e-9;

/// What one member does to its nodes, and what its foundation does to it, in one load case.
class Equilibrist {
public:
    Equilibrist(detail::Solution& solution, std::size_t load_case)
        : solution_(solution),
          structure_(*solution.structure),
          case_(load_case),
          loads_(solution.loads[load_case]),
          result_(solution.solutions[load_case])
    {}

    void run()
    {
        for (const Discretisation::Tie& tie : structure_.ties) ties_.emplace(key(tie.node, tie.dof), &tie);
        result_.reactions.assign(structure_.supports.size(), NodeVector{});
        for (const Eigen::Vector3d& position : structure_.positions)
            result_.balance.reach = std::max(result_.balance.reach, position.norm());
        for (std::size_t i = 0; i < structure_.members.size(); ++i) add_member(MemberId(i));
        add_node_loads();
        if (!structure_.bodies.empty()) add_bodies();
        if (!structure_.ties.empty()) give_back_to_tied();
        for (std::size_t s = 0; s < structure_.supports.size(); ++s) finish(s);
        if (result_.balance.imposed < negligible_loads * result_.balance.largest)
            result_.equilibrium.residual = result_.balance.out_of_balance / result_.balance.largest;
        result_.equilibrium.sum_loads = known(sum_of_loads_, structure_.kind);
        result_.equilibrium.sum_reactions = known(sum_of_reactions_, structure_.kind);
    }

private:
    void add_member(MemberId member)
    {
        const auto& nodes = structure_.members[member.index].nodes;
        const std::span<const SpanLoad> span_loads = loads_.of(member);
        const bool at_support = structure_.support_of_node[nodes[0].index] >= 0 ||
                                structure_.support_of_node[nodes[1].index] >= 0;
        const bool on_foundation = structure_.properties_of(member).xy.foundation > 0.0;
        if (span_loads.empty() && !at_support && !on_foundation) return;
        const MemberGeometry geometry = structure_.geometry(member);
        const Eigen::Matrix3d to_global = geometry.axes.transpose();
        Wrench load;
        if (!span_loads.empty()) {
            const Wrench local = local_sum(span_loads);
            load.add(to_global * local.force, to_global * local.moment, geometry.start);
            weigh(to_global * local.force, to_global * local.moment, geometry.start);
            sum_of_loads_.force += load.force;
            sum_of_loads_.moment += load.moment;
        }
        if (!at_support && !on_foundation) return;

        const detail::EndVectors p = detail::end_forces(solution_, case_, member);
        Wrench ends;
        for (std::size_t end = 0; end < 2; ++end) {
            const Eigen::Vector3d F = to_global * p[end].head<3>();
            const Eigen::Vector3d M = to_global * p[end].tail<3>();
            const Eigen::Vector3d& place = end == 0 ? geometry.start : geometry.end;
            ends.add(F, M, place);
            const std::int32_t support = structure_.support_of_node[nodes[end].index];
            if (support < 0) continue;
            const Eigen::Vector3d arm = place - structure_.positions[nodes[end].index];
            add(result_.reactions[static_cast<std::size_t>(support)], F, M + arm.cross(F));
        }
        if (on_foundation) { // what neither the ends nor the loads balance, the foundation does
            sum_of_reactions_.force -= ends.force + load.force;
            sum_of_reactions_.moment -= ends.moment + load.moment;
            weigh(ends.force + load.force, Eigen::Vector3d::Zero(), geometry.start);
        }
    }

    /// What the nodes do to the bodies between them, at supports: K u less what replaces the loads on them.
    void add_bodies()
    {
        for (const CaseLoads::OnElement& on : loads_.elements)
            if (const Element* body = body_of(on.element)) add_body_loads(*body, on);
        ElementMatrix K;
        for (const auto& body : structure_.bodies) {
            const ElementDofs dofs = body->dofs();
            if (!meets_support(dofs)) continue;
            body->stiffness(K);
            add_at_supports(dofs, K * displacements_of(dofs));
        }
    }

    /// Nothing for members, whose loads are elsewhere, and for foundations, which are supports.
    const Element* body_of(std::size_t element) const
    {
        const std::size_t first = structure_.members.size();
        const bool is_body = element >= first && element - first < structure_.bodies.size();
        return is_body ? structure_.bodies[element - first].get() : nullptr;
    }

    void add_body_loads(const Element& body, const CaseLoads::OnElement& on)
    {
        ElementVector f;
        body.equivalent_forces(on.loads(), f);
        const ElementDofs dofs = body.dofs();
        add_at_supports(dofs, -f);
        const std::size_t n = dofs.of_each_node.size();
        for (std::size_t i = 0; i < dofs.n_of_nodes(); ++i) {
            Eigen::Vector3d F = Eigen::Vector3d::Zero();
            F[static_cast<int>(index(dofs.of_each_node[i % n]))] = f[static_cast<Eigen::Index>(i)];
            const Eigen::Vector3d& at = structure_.positions[dofs.nodes[i / n].index];
            sum_of_loads_.add(F, Eigen::Vector3d::Zero(), at);
            weigh(F, Eigen::Vector3d::Zero(), at);
        }
    }

    bool meets_support(const ElementDofs& dofs) const
    {
        return std::ranges::any_of(dofs.nodes, [&](NodeId node) {
            return structure_.support_of_node[node.index] >= 0 ||
                   std::ranges::any_of(dofs.of_each_node, [&](Dof dof) { return tie_of(node, dof) != nullptr; });
        });
    }

    ElementVector displacements_of(const ElementDofs& dofs) const
    {
        const std::size_t n = dofs.of_each_node.size();
        ElementVector u(static_cast<Eigen::Index>(dofs.n_of_nodes()));
        for (std::size_t i = 0; i < dofs.n_of_nodes(); ++i)
            u[static_cast<Eigen::Index>(i)] = result_.displacements[dofs.nodes[i / n].index * n + i % n];
        return u;
    }

    void add_at_supports(const ElementDofs& dofs, const ElementVector& forces)
    {
        const std::size_t n = dofs.of_each_node.size();
        for (std::size_t i = 0; i < dofs.n_of_nodes(); ++i)
            add_at_support(dofs.nodes[i / n], dofs.of_each_node[i % n], forces[static_cast<Eigen::Index>(i)]);
    }

    /// What a node needs to be held by. One that is tied hands it over to its leader, and the tie takes its moment.
    void add_at_support(NodeId node, Dof dof, double force)
    {
        if (const Discretisation::Tie* const tie = tie_of(node, dof)) {
            hand_over(*tie, force);
            node = tie->leader;
        }
        hold(node, dof, force);
    }

    const Discretisation::Tie* tie_of(NodeId node, Dof dof) const
    {
        const auto tie = ties_.empty() ? ties_.end() : ties_.find(key(node, dof));
        return tie == ties_.end() ? nullptr : tie->second;
    }
    static std::size_t key(NodeId node, Dof dof) { return node.index * all_dofs.size() + index(dof); }

    /// The moment of a force that a node's tie takes to its leader.
    void hand_over(const Discretisation::Tie& tie, double force)
    {
        const Eigen::Vector3d F = force * Eigen::Vector3d::Unit(static_cast<int>(index(tie.dof)) % 3);
        const Eigen::Vector3d arm = structure_.positions[tie.node.index] - structure_.positions[tie.leader.index];
        sum_of_reactions_.moment += arm.cross(F);
    }

    void hold(NodeId node, Dof dof, double force)
    {
        const std::int32_t support = structure_.support_of_node[node.index];
        if (support >= 0) result_.reactions[static_cast<std::size_t>(support)][index(dof)] += force;
    }

    /// Tied nodes on springs: each is held by its own ground, which the tie does not take to the leader.
    void give_back_to_tied()
    {
        const std::size_t first = structure_.members.size() + structure_.bodies.size();
        ElementMatrix K;
        for (const auto& ground : structure_.foundations) {
            ground->stiffness(K);
            give_back(ground->dofs(), -(K * displacements_of(ground->dofs())));
        }
        for (const CaseLoads::OnElement& on : loads_.elements) {
            if (on.element < first) continue;
            const Element& ground = *structure_.foundations[on.element - first];
            ElementVector f;
            ground.equivalent_forces(on.loads(), f);
            give_back(ground.dofs(), f);
        }
    }

    void give_back(const ElementDofs& dofs, const ElementVector& forces)
    {
        const std::size_t n = dofs.of_each_node.size();
        for (std::size_t i = 0; i < dofs.n_of_nodes(); ++i) {
            const Discretisation::Tie* const tie = tie_of(dofs.nodes[i / n], dofs.of_each_node[i % n]);
            if (tie == nullptr) continue;
            const double force = forces[static_cast<Eigen::Index>(i)];
            hand_over(*tie, -force);
            hold(tie->leader, tie->dof, -force);
            hold(tie->node, tie->dof, force);
        }
    }

    void add_node_loads()
    {
        for (const CaseLoads::OnNode& load : loads_.nodes) {
            sum_of_loads_.add(forces(load.value), moments(load.value), structure_.positions[load.node.index]);
            weigh(forces(load.value), moments(load.value), structure_.positions[load.node.index]);
            for (const Dof dof : all_dofs)
                if (load.value[index(dof)] != 0.0) add_at_support(load.node, dof, -load.value[index(dof)]);
        }
    }

    static void add(NodeVector& sum, const Eigen::Vector3d& F, const Eigen::Vector3d& M)
    {
        for (std::size_t i = 0; i < 3; ++i) {
            sum[i] += F[static_cast<int>(i)];
            sum[3 + i] += M[static_cast<int>(i)];
        }
    }

    /// Keeps what the support can do along its own axes: the rest is the node's residual.
    void finish(std::size_t s)
    {
        const Discretisation::SupportRow& support = structure_.supports[s];
        NodeVector& reaction = result_.reactions[s];
        const double c = std::cos(support.angle);
        const double si = std::sin(support.angle);
        const auto turn = [&](double sine) {
            const double x = reaction[0];
            const double y = reaction[1];
            reaction[0] = c * x - sine * y;
            reaction[1] = sine * x + c * y;
        };
        if (support.angle != 0.0) turn(-si);
        for (const Dof dof : all_dofs)
            if (!support.blocked.contains(dof) && support.springs[index(dof)] == 0.0 &&
                !support.on_foundations.contains(dof))
                reaction[index(dof)] = 0.0;
        if (support.angle != 0.0) turn(si);
        sum_of_reactions_.add(forces(reaction), moments(reaction), structure_.positions[support.node.index]);
        weigh(forces(reaction), moments(reaction), structure_.positions[support.node.index]);
    }

    /// Takes note of how large what the sums are made of is.
    void weigh(const Eigen::Vector3d& F, const Eigen::Vector3d& M, const Eigen::Vector3d& at)
    {
        detail::Balance& balance = result_.balance;
        balance.largest = std::max({balance.largest, F.cwiseAbs().maxCoeff(), M.cwiseAbs().maxCoeff()});
        balance.sum_forces += F.norm();
        balance.sum_moments += M.norm() + at.norm() * F.norm();
    }

    detail::Solution& solution_;
    const Discretisation& structure_;
    std::size_t case_;
    const CaseLoads& loads_;
    detail::CaseSolution& result_;
    std::unordered_map<std::size_t, const Discretisation::Tie*> ties_; ///< of nodes that have one
    Wrench sum_of_loads_, sum_of_reactions_;
};

/// How many section forces a member has less its releases: of a member that these leave loose less than none, since
/// its motion counts with the others. A twist that is released at both ends is none.
int member_forces(const MemberEndConditions* end_conditions, AnalysisKind kind)
{
    const bool is_bar = end_conditions != nullptr && end_conditions->is_bar;
    if (is_bar && kind == AnalysisKind::Grillage) return 0; // its axial force is none of a grillage's
    const auto n_released = [&](std::initializer_list<LocalAxis> axes) {
        int n = 0;
        if (end_conditions == nullptr) return n;
        for (const JointStiffness& joints : end_conditions->joints)
            for (const LocalAxis axis : axes) n += joints[index(axis)] == 0.0 ? 1 : 0;
        return n;
    };
    const int axial = 1 - n_released({LocalAxis::x});
    if (is_truss(kind) || is_bar) return axial;
    const int torsion = std::max(0, 1 - n_released({LocalAxis::rx}));
    const int xy = 2 - n_released({LocalAxis::y, LocalAxis::rz});
    const int xz = 2 - n_released({LocalAxis::z, LocalAxis::ry});
    switch (kind) {
    case AnalysisKind::Frame2d: return axial + xy;
    case AnalysisKind::Grillage: return torsion + xy;
    default: return axial + torsion + xy + xz;
    }
}

} // namespace

void add_reactions(detail::Solution& solution)
{
    for (std::size_t c = 0; c < solution.solutions.size(); ++c) Equilibrist(solution, c).run();
}

Indeterminacy count_indeterminacy(const Discretisation& structure, std::size_t n_restraints)
{
    Indeterminacy count;
    const auto n_node_dofs = static_cast<int>(model_dofs(structure.kind).size());
    int forces = 0;
    for (std::size_t i = 0; i < structure.members.size(); ++i) {
        forces += member_forces(structure.end_conditions_of(MemberId(i)), structure.kind);
        count.has_foundation |= structure.properties_of(MemberId(i)).xy.foundation > 0.0;
    }
    int reactions = 0;
    for (const Discretisation::SupportRow& support : structure.supports) {
        if (!structure.is_attached[support.node.index]) continue;
        reactions += support.blocked.size();
        for (const double k : support.springs) reactions += k > 0.0 ? 1 : 0;
    }
    const int equations = n_node_dofs * static_cast<int>(n_joints(structure)) - static_cast<int>(n_restraints);
    count.external = reactions - n_rigid_motions(structure.kind) * static_cast<int>(n_parts(structure));
    count.internal = forces + reactions - equations - count.external;
    return count;
}

} // namespace femoop
