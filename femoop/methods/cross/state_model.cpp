#include "femoop/methods/cross/state_model.h"

#include <algorithm>
#include <array>

#include "femoop/analysis/linear_static.h"
#include "femoop/discretisation/case_loads.h"
#include "femoop/load/case_terms.h"
#include "femoop/methods/cross/kinematics.h"

namespace femoop::cross {

namespace {

/// Blocks degrees of freedom of a model's nodes and moves them, in a load case of their own.
class Clamps {
public:
    explicit Clamps(const Model& model) : model_(inextensible_copy(model)), lock_(CaseId(model.load_cases.size()))
    {
        model_.combinations.clear();
        model_.expected.clear();
        model_.extra.clear();
        std::string id = "locks";
        while (model.find_case(id)) id += "'";
        model_.add(LoadCase{.id = id});
    }

    void clamp(NodeId node, Dof dof, double displacement)
    {
        Node& clamped = model_.nodes[node.index];
        const DofSet blocked = clamped.support ? clamped.support->blocked(model_.analysis) : DofSet{};
        if (!clamped.support) clamped.support = Support{};
        clamped.support->kind = SupportKind::Custom;
        clamped.support->fixed = blocked;
        clamped.support->fixed.insert(dof);
        if (std::erase_if(clamped.support->springs, [&](const Spring& spring) { return spring.dof == dof; }) > 0)
            forget_ground(node, dof);
        if (displacement != 0.0)
            lock_case().settlements.push_back({.node = node, .components = {{.dof = dof, .value = displacement}}});
    }

    void load(NodeId node, double moment)
    {
        lock_case().nodes.push_back({.node = node, .components = {{.dof = Dof::rz, .value = moment}}});
    }

    Model with_case(const std::vector<CaseTerms::Term>& terms)
    {
        Combination state{.id = model_.load_cases.back().id + " and loads", .terms = {{.of = lock_, .factor = 1.0}}};
        while (model_.find_case(state.id)) state.id += "'";
        for (const CaseTerms::Term& term : terms)
            state.terms.push_back({.of = CaseId(term.load_case), .factor = term.factor});
        model_.combinations.push_back(std::move(state));
        return std::move(model_);
    }

private:
    LoadCase& lock_case() { return model_.load_cases[lock_.index]; }

    /// The ground of a spring that a clamp replaced moves nothing any more.
    void forget_ground(NodeId node, Dof dof)
    {
        for (LoadCase& load_case : model_.load_cases) {
            for (Settlement& settlement : load_case.settlements)
                if (settlement.node == node)
                    std::erase_if(settlement.components, [&](const Component& c) { return c.dof == dof; });
            std::erase_if(load_case.settlements, [](const Settlement& s) { return s.components.empty(); });
        }
    }

    Model model_;
    CaseId lock_;
};

Dof prop_dof(const Discretisation& structure, const Sway& sway)
{
    const Eigen::Vector2d along = support_axes(structure, sway.prop) * sway.direction;
    return along[0] > 0.5 ? Dof::ux : Dof::uy;
}

/// Forces of a member's nodes on it across its axis and about it, read off its curve: (F1, m1, F2, m2).
Eigen::Vector4d end_forces(const Curve& curve, const std::array<double, n_local_axes>& last_jump)
{
    constexpr std::size_t y = index(LocalAxis::y), rz = index(LocalAxis::rz);
    const std::array<double, n_local_axes>& jump = curve.pieces().front().load.jump;
    const SectionForces first = curve.forces(0.0), last = curve.forces(curve.length(), Side::Before);
    return {first.Vy - jump[y], -(first.Mz + jump[rz]), -(last.Vy + last_jump[y]), last.Mz - last_jump[rz]};
}

/// Point loads at the second end of a member.
std::array<double, n_local_axes> last_jump(const Discretisation& structure, const std::vector<CaseLoads>& loads,
                                           const CaseTerms& terms, MemberId member)
{
    std::vector<SpanLoading::Scaled> scaled;
    for (const CaseTerms::Term& term : terms.terms)
        scaled.push_back({.loads = loads[term.load_case].of(member), .factor = term.factor});
    SpanLoading loading;
    structure.properties_of(member).xy.cut(loading, structure.geometry(member).length, scaled);
    return loading.last_jump();
}

} // namespace

Locks locks_of(const Problem& problem, const State& state)
{
    Locks locks{.is_loaded = true,
                .rotations = state.rotations,
                .displacements = std::vector<double>(problem.sways.size(), 0.0),
                .dead_moments = {}};
    const bool is_any_free = std::ranges::any_of(problem.joints, &Joint::is_released_once);
    if (is_any_free) locks.dead_moments = state.unbalance;
    return locks;
}

Locks locks_of(const Problem& problem, const State& state, std::size_t sway)
{
    Locks locks = locks_of(problem, state);
    locks.is_loaded = false;
    locks.displacements[sway] = problem.sways[sway].scale;
    return locks;
}

Locks locks_of(const Problem& problem, const Superposition& all)
{
    Locks locks = locks_of(problem, all.held.sheet.end);
    locks.rotations = all.rotations;
    locks.displacements = all.displacements;
    for (std::size_t k = 0; k < all.sways.size(); ++k)
        for (std::size_t j = 0; j < locks.dead_moments.size(); ++j)
            locks.dead_moments[j] += all.x[static_cast<Eigen::Index>(k)] * all.sways[k].sheet.end.unbalance[j];
    return locks;
}

Model state_model(const Model& model, const Problem& problem, const Locks& locks)
{
    const Discretisation structure = discretise(model);
    Clamps clamps(model);
    for (std::size_t j = 0; j < problem.joints.size(); ++j) {
        const Joint& joint = problem.joints[j];
        if (!joint.is_released_once) clamps.clamp(joint.node, Dof::rz, locks.rotations[j]);
        else if (locks.dead_moments[j] != 0.0) clamps.load(joint.node, locks.dead_moments[j]);
    }
    for (std::size_t s = 0; s < problem.sways.size(); ++s)
        clamps.clamp(problem.sways[s].prop, prop_dof(structure, problem.sways[s]), locks.displacements[s]);
    return clamps.with_case(locks.is_loaded ? cases_of(model)[problem.load_case.index].terms
                                            : std::vector<CaseTerms::Term>{});
}

Results state_results(const Model& model, const Problem& problem, const Locks& locks)
{
    return analyse(state_model(model, problem, locks));
}

namespace {

Locks locks_at_rest(const Problem& problem)
{
    return {.rotations = std::vector<double>(problem.joints.size(), 0.0),
            .displacements = std::vector<double>(problem.sways.size(), 0.0),
            .dead_moments = std::vector<double>(problem.joints.size(), 0.0)};
}

} // namespace

StateAnalysis::StateAnalysis(const Model& model, const Problem& problem)
    : analysis_(state_model(model, problem, locks_at_rest(problem)))
{}

Results StateAnalysis::solve(const Model& model, const Problem& problem, const Locks& locks)
{
    return analysis_.solve(state_model(model, problem, locks));
}

std::vector<double> end_moments(const Model& model, const Problem& problem, const CaseResult& result)
{
    const Discretisation structure = discretise(model);
    const std::vector<CaseLoads> loads = loads_of(model, structure);
    const CaseTerms terms = cases_of(model)[problem.load_case.index];
    std::vector<double> moments;
    for (const End& end : problem.ends) {
        if (!end.member) {
            const double turn = result.displacement(end.node)[index(Dof::rz)];
            moments.push_back(end.stiffness * turn + problem.loading.fixed_end[moments.size()]);
            continue;
        }
        const Eigen::Vector4d p = end_forces(result.curve(*end.member),
                                             last_jump(structure, loads, terms, *end.member));
        const MemberEndConditions* end_conditions = structure.end_conditions_of(*end.member);
        const bool has_arm = end_conditions != nullptr && end_conditions->has_offset;
        const double arm = has_arm ? structure.geometry(*end.member).axes.row(0).dot(end_conditions->offsets[end.which])
                                   : 0.0;
        const auto which = static_cast<Eigen::Index>(2 * end.which);
        moments.push_back(p[which + 1] + arm * p[which]);
    }
    return moments;
}

double section_moment(const End& end, double end_moment) { return end.which == 0 ? -end_moment : end_moment; }

} // namespace femoop::cross
