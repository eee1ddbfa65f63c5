#include "femoop/methods/truss/truss.h"

#include <algorithm>
#include <cmath>

#include "femoop/geometry/node_position.h"
#include "femoop/geometry/plane_vectors.h"
#include "femoop/load/case_terms.h"

namespace femoop::truss {

namespace {

constexpr double negligible_share = 1e-9; // of the largest force, and of the sine between two lines

Eigen::Vector2d plane(const NodeVector& vector) { return {vector[index(Dof::ux)], vector[index(Dof::uy)]}; }

/// Puts the truss together: geometry first, then what acts on it.
class TrussMaker {
public:
    TrussMaker(const Model& model, const CaseResult& result) : model_(model), result_(result)
    {
        for (std::size_t i = 0; i < model.nodes.size(); ++i)
            truss_.joints.emplace_back(position_of(model, NodeId(i)).head<2>());
        truss_.bars_at.resize(model.nodes.size());
        loads_.assign(model.nodes.size(), Eigen::Vector2d::Zero());
        reactions_ = loads_;
        for (std::size_t i = 0; i < model.members.size(); ++i) add_bar(MemberId(i));
    }

    Truss made(CaseId load_case) &&
    {
        add_node_loads(load_case);
        for (std::size_t i = 0; i < reactions_.size(); ++i) {
            truss_.is_supported.push_back(result_.is_supported(NodeId(i)));
            if (truss_.is_supported[i]) reactions_[i] = plane(result_.reaction(NodeId(i)));
        }
        silence();
        return std::move(truss_);
    }

private:
    /// What the bar brings to its joints beyond its own force is the load on it.
    void add_bar(MemberId id)
    {
        const Member& member = model_[id];
        const Eigen::Vector2d along = truss_.joints[member.nodes[1].index] - truss_.joints[member.nodes[0].index];
        const Eigen::Vector2d x = along.normalized(), y(-x.y(), x.x());
        const Curve curve = result_.curve(id);
        const SectionForces start = curve.forces(0.0, Side::Before), end = curve.forces(curve.length(), Side::After);
        const double mean = 0.5 * (start.N + end.N);
        loads_[member.nodes[0].index] += (start.N - mean) * x - start.Vy * y;
        loads_[member.nodes[1].index] += (mean - end.N) * x + end.Vy * y;
        truss_.bars.push_back({.joints = member.nodes, .direction = x, .force = mean});
        for (const NodeId joint : member.nodes) truss_.bars_at[joint.index].push_back(id);
    }

    void add_node_loads(CaseId load_case)
    {
        double on_bars = 0.0;
        for (const Eigen::Vector2d& load : loads_) on_bars = std::max(on_bars, load.norm());
        for (const CaseTerms::Term& term : terms_of(model_, load_case).terms)
            for (const NodeLoad& load : model_.load_cases[term.load_case].nodes)
                for (const Component& component : load.components) {
                    if (component.dof == Dof::ux) loads_[load.node.index].x() += term.factor * component.value;
                    if (component.dof == Dof::uy) loads_[load.node.index].y() += term.factor * component.value;
                }
        measure();
        truss_.has_loaded_bars = !truss_.is_zero(on_bars);
    }

    void measure()
    {
        for (const Bar& bar : truss_.bars) truss_.largest_force = std::max(truss_.largest_force, std::abs(bar.force));
        for (const auto* forces : {&loads_, &reactions_})
            for (const Eigen::Vector2d& force : *forces)
                truss_.largest_force = std::max(truss_.largest_force, force.norm());
    }

    /// Round-off is no force: what is negligible_share becomes 0, component by component.
    void silence()
    {
        measure();
        const auto silent = [&](double force) { return truss_.is_zero(force) ? 0.0 : force; };
        for (Bar& bar : truss_.bars) bar.force = silent(bar.force);
        for (std::size_t i = 0; i < loads_.size(); ++i) {
            add_force(NodeId(i), ForceCause::Load, loads_[i].unaryExpr(silent));
            add_force(NodeId(i), ForceCause::Reaction, reactions_[i].unaryExpr(silent));
        }
    }

    void add_force(NodeId joint, ForceCause cause, const Eigen::Vector2d& force)
    {
        if (!force.isZero(0.0)) truss_.forces.push_back({.joint = joint, .cause = cause, .force = force});
    }

    const Model& model_;
    const CaseResult& result_;
    Truss truss_;
    std::vector<Eigen::Vector2d> loads_, reactions_;
};

} // namespace

NodeId Truss::other_joint(MemberId bar, NodeId joint) const
{
    return bars[bar.index].joints[bars[bar.index].joints[0] == joint ? 1 : 0];
}

Eigen::Vector2d Truss::away_from(NodeId joint, MemberId bar) const
{
    return bars[bar.index].joints[0] == joint ? bars[bar.index].direction : -bars[bar.index].direction;
}

Eigen::Vector2d Truss::force_at(NodeId joint) const
{
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    for (const ExternalForce& one : forces)
        if (one.joint == joint) sum += one.force;
    return sum.unaryExpr([&](double force) { return is_zero(force) ? 0.0 : force; });
}

bool Truss::is_zero(double force) const { return std::abs(force) <= negligible_share * largest_force; }

bool Truss::are_parallel(const Eigen::Vector2d& a, const Eigen::Vector2d& b) const
{
    return std::abs(cross_product(a, b)) <= negligible_share * a.norm() * b.norm();
}

std::optional<Refusal> why_no_truss(const Model& model, const Results& results)
{
    if (model.analysis != AnalysisKind::Truss2d) return Refusal{.kind = RefusalKind::NotPlaneTruss};
    if (model.n_cases() == 0) return Refusal{.kind = RefusalKind::NoCase};
    if (const int degree = results.indeterminacy().total(); degree > 0)
        return Refusal{.kind = RefusalKind::Indeterminate, .degree = degree};
    return std::nullopt;
}

Truss scaled(Truss truss, double length, double force)
{
    for (Eigen::Vector2d& joint : truss.joints) joint *= length;
    for (Bar& bar : truss.bars) bar.force *= force;
    for (ExternalForce& one : truss.forces) one.force *= force;
    truss.largest_force *= force;
    return truss;
}

Truss truss_of(const Model& model, const Results& results, CaseId load_case)
{
    const CaseResult result = results[load_case];
    return TrussMaker(model, result).made(load_case);
}

} // namespace femoop::truss
