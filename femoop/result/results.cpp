#include "femoop/result/results.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "femoop/discretisation/solution.h"
#include "femoop/element/analysis_model.h"
#include "femoop/result/curve_reader.h"

namespace femoop {

namespace {

void add(NodeVector& sum, double factor, const NodeVector& v)
{
    for (std::size_t i = 0; i < n_dofs; ++i) sum[i] += factor * v[i];
}

} // namespace

CaseResult::CaseResult(std::shared_ptr<const detail::Solution> solution, std::size_t index)
    : solution_(std::move(solution)), index_(index)
{}

const std::string& CaseResult::name() const { return solution_->cases[index_].name; }

NodeVector CaseResult::displacement(NodeId node) const
{
    const std::span<const Dof> dofs = model_dofs(solution_->structure->kind);
    NodeVector u{};
    for (const CaseTerms::Term& term : solution_->cases[index_].terms) {
        const std::vector<double>& displacements = solution_->solutions[term.load_case].displacements;
        for (std::size_t i = 0; i < dofs.size(); ++i)
            u[index(dofs[i])] += term.factor * displacements[node.index * dofs.size() + i];
    }
    return u;
}

bool CaseResult::is_supported(NodeId node) const { return solution_->structure->support_of(node) != nullptr; }

NodeVector CaseResult::reaction(NodeId node) const
{
    NodeVector sum{};
    const std::int32_t support = solution_->structure->support_of_node[node.index];
    if (support < 0) return sum;
    for (const CaseTerms::Term& term : solution_->cases[index_].terms)
        add(sum, term.factor, solution_->solutions[term.load_case].reactions[static_cast<std::size_t>(support)]);
    return sum;
}

Curve CaseResult::curve(MemberId member) const { return CurveReader(*this).read(member); }

Equilibrium CaseResult::equilibrium() const
{
    Equilibrium whole;
    for (const CaseTerms::Term& term : solution_->cases[index_].terms) {
        const Equilibrium& part = solution_->solutions[term.load_case].equilibrium;
        whole.residual = std::max(whole.residual, part.residual);
        add(whole.sum_loads, term.factor, part.sum_loads);
        add(whole.sum_reactions, term.factor, part.sum_reactions);
    }
    return whole;
}

Results::Results(std::shared_ptr<const detail::Solution> solution) : solution_(std::move(solution)) {}

AnalysisKind Results::analysis() const { return solution_->structure->kind; }
std::size_t Results::n_cases() const { return solution_->cases.size(); }
std::size_t Results::n_members() const { return solution_->structure->members.size(); }
std::size_t Results::n_nodes() const { return solution_->structure->positions.size(); }

CaseResult Results::operator[](CaseId id) const
{
    if (id.index >= n_cases()) throw std::out_of_range("Results: no such case");
    return {solution_, id.index};
}

CaseResult Results::at(std::string_view name) const
{
    std::string names;
    for (std::size_t i = 0; i < n_cases(); ++i) {
        if (solution_->cases[i].name == name) return {solution_, i};
        names += (i == 0 ? "" : ", ") + solution_->cases[i].name;
    }
    throw std::out_of_range("no case \"" + std::string(name) + "\"; there are: " + names);
}

MemberGeometry Results::geometry(MemberId member) const { return solution_->structure->geometry(member); }
const Indeterminacy& Results::indeterminacy() const { return solution_->indeterminacy; }
const std::vector<Fault>& Results::warnings() const { return solution_->warnings; }

} // namespace femoop
