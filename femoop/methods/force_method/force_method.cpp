#include "femoop/methods/force_method/force_method.h"

#include <Eigen/Cholesky>
#include <string>
#include <utility>

#include "femoop/analysis/linear_static.h"
#include "femoop/edit/naming.h"
#include "femoop/load/case_terms.h"
#include "femoop/load/place_along.h"
#include "femoop/methods/force_method/usual_redundants.h"
#include "femoop/methods/influence/effect_name.h"
#include "femoop/methods/influence/influence_line.h"

namespace femoop::force_method {

namespace {

using virtual_work::Work;
using virtual_work::work_between;

constexpr double least_pivot = 1e-12; ///< of delta, each row and column scaled to a diagonal of 1

/// With the node that its cut puts inside a member, as a motion of the primary structure names it: M(BC, 50%) [E].
std::string names_of(const Model& model, std::span<const Redundant> redundants, const PrimaryStructure& primary)
{
    std::vector<std::string> names;
    for (std::size_t i = 0; i < redundants.size(); ++i) {
        const NodeId node = primary.releases[i].node;
        const bool is_new = node.index >= model.nodes.size();
        names.push_back(influence::effect_name(model, redundants[i]) +
                        (is_new ? " [" + primary.model[node].id + "]" : ""));
    }
    return listed(names);
}

/// What the analysis of the whole has for redundants: reactions along the axes of their supports, section forces at a
/// member's end before what acts on that end.
class AnalysedForces {
public:
    explicit AnalysedForces(const virtual_work::Loading& whole) : whole_(whole) {}

    double of(const Redundant& asked) const { return asked.member ? section_force(asked) : reaction(asked); }

private:
    double reaction(const Redundant& asked) const
    {
        const Discretisation::SupportRow& support = *whole_.structure().support_of(*asked.node);
        return virtual_work::in_axes_of(support, whole_.result().reaction(*asked.node))[index(*asked.dof)];
    }

    double section_force(const Redundant& asked) const
    {
        const Curve curve = whole_.result().curve(*asked.member);
        const auto end = end_at(along(*asked.at, curve.length()), curve.length());
        if (!end) return influence::effect_in(asked, whole_.result());
        return virtual_work::force_in_joint(curve, whole_.span_loading(*asked.member), *end, *asked.component);
    }

    virtual_work::LoadedStructure whole_;
};

Combination state_0(const PrimaryStructure& primary, const CaseTerms& terms)
{
    Combination loads{.id = fresh_case_id(primary.model, "X = 0"), .terms = {}};
    for (const CaseTerms::Term& term : terms.terms) loads.terms.push_back({CaseId(term.load_case), term.factor});
    return loads;
}

/// Adds the states as cases: a unit load case for each redundant, and the loads as a combination.
std::vector<CaseId> add_states(PrimaryStructure& primary, const CaseTerms& terms)
{
    std::vector<CaseId> cases{CaseId()};
    for (const Release& release : primary.releases) {
        const std::string id = fresh_case_id(primary.model, "X" + std::to_string(cases.size()) + " = 1");
        cases.push_back(primary.model.add(unit_state(primary.model, release, id)));
    }
    cases[0] = CaseId(primary.model.n_cases());
    primary.model.combinations.push_back(state_0(primary, terms));
    return cases;
}

CaseId add_superposition(Model& primary, const std::vector<CaseId>& cases, const Eigen::VectorXd& X)
{
    Combination sum{.id = fresh_case_id(primary, "X"), .terms = {{cases[0], 1.0}}};
    for (Eigen::Index i = 0; i < X.size(); ++i) sum.terms.push_back({cases[static_cast<std::size_t>(i) + 1], X[i]});
    primary.combinations.push_back(std::move(sum));
    return CaseId(primary.n_cases() - 1);
}

Eigen::VectorXd imposed_on(const PrimaryStructure& primary, const CaseTerms& terms)
{
    Eigen::VectorXd c = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(primary.releases.size()));
    for (const CaseTerms::Term& term : terms.terms)
        c += term.factor * Eigen::Map<const Eigen::VectorXd>(primary.imposed[term.load_case].data(), c.size());
    return c;
}

/// What the coefficients are made of; those below the diagonal are those above it, by Maxwell and Betti.
struct Flexibility {
    std::vector<std::vector<Work>> work;
    Eigen::MatrixXd delta;
    Eigen::VectorXd delta_0;

    Flexibility(const PrimaryStructure& primary, const Results& states, const std::vector<CaseId>& cases)
        : work(primary.releases.size())
    {
        const auto n = static_cast<Eigen::Index>(work.size());
        delta.resize(n, n);
        delta_0.resize(n);
        for (std::size_t i = 0; i < work.size(); ++i)
            for (std::size_t j = 0; j < cases.size(); ++j) {
                const bool is_known = j > 0 && j <= i;
                work[i].push_back(
                    is_known ? work[j - 1][i + 1]
                             : work_between({primary.model, states, cases[j]}, {primary.model, states, cases[i + 1]}));
                const double gap = work[i][j].sum();
                const auto row = static_cast<Eigen::Index>(i);
                if (j == 0) delta_0[row] = gap;
                else delta(row, static_cast<Eigen::Index>(j) - 1) = gap;
            }
        for (Eigen::Index i = 0; i < n; ++i) delta(i, i) += primary.releases[static_cast<std::size_t>(i)].flexibility;
    }
};

/// Nothing where an equation follows from the others.
std::optional<Eigen::VectorXd> solution(const Eigen::MatrixXd& delta, const Eigen::VectorXd& gaps)
{
    if ((delta.diagonal().array() <= 0.0).any()) return std::nullopt;
    const Eigen::VectorXd scale = delta.diagonal().cwiseSqrt().cwiseInverse();
    const Eigen::LDLT<Eigen::MatrixXd> factors((scale.asDiagonal() * delta * scale.asDiagonal()).eval());
    if (factors.info() != Eigen::Success || factors.vectorD().minCoeff() < least_pivot) return std::nullopt;
    return scale.asDiagonal() * factors.solve(scale.asDiagonal() * gaps);
}

/// What an analysis gives. \throws MechanismError that says of which redundants the structure was deprived
template <class Step> auto without(const std::string& names, Step&& step)
try {
    return step();
} catch (const MechanismError& error) {
    throw MechanismError(error.mechanisms(), error.n_more(), {Fault{FaultKind::PrimaryMoves, {names}}});
}

ForceMethod solved(const Model& model, const Results& results, CaseId load_case, std::vector<Redundant> redundants)
{
    const CaseTerms terms = terms_of(model, load_case);
    PrimaryStructure primary = primary_structure(model, redundants);
    const std::string names = names_of(model, redundants, primary);
    const std::vector<CaseId> cases = add_states(primary, terms);
    LinearStatic analysis = without(names, [&] { return LinearStatic(primary.model); });
    const Results unsolved = without(names, [&] { return analysis.solve(primary.model); });
    const Flexibility flexibility(primary, unsolved, cases);
    const Eigen::VectorXd imposed = imposed_on(primary, terms);
    const auto X = solution(flexibility.delta, imposed - flexibility.delta_0);
    if (!X) throw ModelError({Fault{FaultKind::RedundantsUnstrained, {names}}});
    const CaseId superposition = add_superposition(primary.model, cases, *X);
    Eigen::VectorXd analysed(X->size());
    const AnalysedForces whole({model, results, load_case});
    for (Eigen::Index i = 0; i < X->size(); ++i) analysed[i] = whole.of(redundants[static_cast<std::size_t>(i)]);
    Results states = analysis.solve(primary.model);
    return {.load_case = load_case,
            .redundants = std::move(redundants),
            .degree = results.indeterminacy(),
            .primary = std::move(primary),
            .states = std::move(states),
            .cases = cases,
            .superposition = superposition,
            .delta = flexibility.delta,
            .delta_0 = flexibility.delta_0,
            .imposed = imposed,
            .X = *X,
            .analysed = std::move(analysed),
            .work = flexibility.work};
}

} // namespace

ForceMethod solve(const Model& model, const Results& results, CaseId load_case, std::span<const Redundant> redundants)
{
    std::vector<Redundant> released(redundants.begin(), redundants.end());
    if (released.empty()) released = usual_redundants(model, results.indeterminacy());
    if (released.empty()) throw ModelError({Fault{FaultKind::RedundantsNone, {}}});
    return solved(model, results, load_case, std::move(released));
}

} // namespace femoop::force_method
