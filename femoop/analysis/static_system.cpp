#include "femoop/analysis/static_system.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "femoop/analysis/constraints.h"
#include "femoop/analysis/member_mechanism.h"
#include "femoop/analysis/settlement_force.h"
#include "femoop/analysis/stopwatch.h"
#include "femoop/element/analysis_model.h"
#include "femoop/solver/at_once.h"
#include "femoop/solver/available_memory.h"

namespace femoop {

namespace {

constexpr std::size_t unknowns_worth_two_threads = 20000; // unknowns

detail::Motions<double> rounded_motions(const detail::Motions<DoubleDouble>& motions)
{
    const auto round = [](const std::vector<DoubleDouble>& values) {
        std::vector<double> rounded;
        std::ranges::transform(values, std::back_inserter(rounded), &DoubleDouble::hi);
        return rounded;
    };
    return {.displacements = round(motions.displacements),
            .constraint_displacements = round(motions.constraint_displacements),
            .member_ends = round(motions.member_ends),
            .constraint_member_ends = round(motions.constraint_member_ends)};
}

void balance(detail::CaseSolution& solution, const Eigen::VectorXd& F, double out_of_balance)
{
    const double largest = F.size() > 0 ? F.cwiseAbs().maxCoeff() : 0.0;
    solution.balance = {.out_of_balance = out_of_balance, .imposed = largest};
    solution.equilibrium.residual = largest > 0.0 ? out_of_balance / largest : 0.0;
}

/// Column c of the constraint displacements; empty without constraints.
auto column_of(const auto& constraint, Eigen::Index c)
{
    using Column = Eigen::Matrix<typename std::decay_t<decltype(constraint)>::Scalar, Eigen::Dynamic, 1>;
    return constraint.cols() > 0 ? Column(constraint.col(c)) : Column();
}

} // namespace

StaticSystem::StaticSystem(std::shared_ptr<const Discretisation> structure, SolverKind wanted)
    : structure_(std::move(structure)),
      elements_(std::in_place, *structure_),
      equations_(*structure_, *elements_, wanted),
      assembler_(std::in_place, *structure_, *elements_, equations_)
{}

void StaticSystem::assemble()
{
    reduced_.emplace(equations_, stiffness());
    if (structure_->has_constraints)
        reduced_->constrain(eliminate_constraints(*assembler_, {}), assembler_->constrained_stiffness<double>());
}

void StaticSystem::prepare(const AnalysisOptions& options, AnalysisStatistics& statistics)
{
    Stopwatch watch;
    if (structure_->has_constraints || equations_.n_unknowns() < unknowns_worth_two_threads) {
        assemble();
        statistics.assemble += watch.lap();
        reduced_->analyse(options);
        statistics.order += watch.lap();
        return;
    }
    reduced_.emplace(equations_);
    SparseMatrix K;
    double assembled = 0.0;
    std::optional<InsufficientMemory> refusal;
    at_once(
        [&] {
            try {
                reduced_->analyse(options);
            } catch (const InsufficientMemory& found) {
                refusal = found;
            }
        },
        [&] {
            stiffness().swap(K);
            Stopwatch own = watch;
            assembled = own.lap();
        });
    reduced_->update(std::move(K));
    statistics.assemble += assembled;
    statistics.order += std::max(0.0, watch.lap() - assembled); // what of it the assembly did not cover
    if (refusal) throw *refusal;
}

void StaticSystem::update(std::shared_ptr<const Discretisation> structure)
{
    precise_.reset();
    assembler_.reset();
    elements_.emplace(*structure);
    structure_ = std::move(structure);
    assembler_.emplace(*structure_, *elements_, equations_);
    reduced_->update(stiffness());
}

SparseMatrix StaticSystem::stiffness()
{
    SparseMatrix K = equations_.pattern().matrix();
    largest_stiffness_ = assembler_->add_stiffness(K);
    std::optional<SparseMatrix> resisting;
    if (structure_->has_constraints) resisting = assembler_->resistance();
    restraints_.rotations = restrain_rotations(*structure_, equations_, K, std::move(resisting));
    restraints_.member_ends = restrain_member_ends(*assembler_, K);
    return K;
}

template <class Scalar> auto StaticSystem::load_vectors_of(const std::vector<CaseLoads>& loads) const -> Dense<Scalar>
{
    Dense<Scalar> F(static_cast<Eigen::Index>(equations_.n_unknowns()), static_cast<Eigen::Index>(loads.size()));
    for (std::size_t c = 0; c < loads.size(); ++c)
        F.col(static_cast<Eigen::Index>(c)) = assembler_->load_vector<Scalar>(loads[c]);
    return F;
}

void StaticSystem::note_size(AnalysisStatistics& statistics) const
{
    const SymmetricSolver* solver = reduced_->solver();
    if (solver == nullptr) return;
    statistics.dofs = static_cast<std::size_t>(reduced_->matrix().rows());
    statistics.nonzeros = static_cast<std::size_t>(reduced_->matrix().nonZeros());
    statistics.factor_nonzeros = solver->factor_nonzeros();
    statistics.factor_operations = solver->predicted_operations();
    statistics.factor_bytes = solver->predicted_bytes();
    statistics.solver = solver->name();
}

Eigen::MatrixXd StaticSystem::load_vectors(const std::vector<CaseLoads>& loads) const
{
    return load_vectors_of<double>(loads);
}

Elimination StaticSystem::imposed(const std::vector<CaseLoads>& loads) const
{
    return structure_->has_constraints ? eliminate_constraints(*assembler_, loads) : Elimination{};
}

ReducedSystem::Displacements StaticSystem::solve(const Eigen::MatrixXd& F, const Eigen::MatrixXd& x0)
{
    return structure_->has_constraints ? reduced_->solve(F, x0) : reduced_->solve(F);
}

std::vector<detail::CaseSolution> StaticSystem::solutions(const std::vector<CaseLoads>& loads, const Eigen::MatrixXd& F,
                                                          const ReducedSystem::Displacements& u) const
{
    const Eigen::VectorXd residuals = reduced_->out_of_balance(F, u);
    std::vector<detail::CaseSolution> found;
    for (std::size_t c = 0; c < loads.size(); ++c) {
        const auto column = static_cast<Eigen::Index>(c);
        detail::CaseSolution& solution = found.emplace_back();
        static_cast<detail::Motions<double>&>(solution) = motions<double>(loads[c], u.all.col(column),
                                                                          column_of(u.constraint, column));
        balance(solution, F.col(column), residuals[column]);
    }
    return found;
}

std::vector<detail::CaseSolution> StaticSystem::solve_precisely(const std::vector<CaseLoads>& loads,
                                                                const Eigen::MatrixXd& x0)
{
    const PreciseMatrix F = load_vectors_of<DoubleDouble>(loads);
    const auto u = precise().solve(F, x0);
    std::vector<detail::CaseSolution> found;
    for (std::size_t c = 0; u && c < loads.size(); ++c) {
        const auto column = static_cast<Eigen::Index>(c);
        detail::CaseSolution& solution = found.emplace_back();
        solution.precise = motions<DoubleDouble>(loads[c], u->all.col(column), column_of(u->constraint, column));
        static_cast<detail::Motions<double>&>(solution) = rounded_motions(solution.precise);
        balance(solution, rounded(F.col(column)), u->out_of_balance[column]);
        if (!loads[c].settlements.empty()) solution.balance.imposed = imposed_force(loads[c]);
    }
    return found;
}

/// Of loads, or of settlements alone. What a settlement brings to a very short or stiff member beside it is no measure:
/// in 32 digits little is left of that, and it may be any number of times what the structure makes of the settlement.
double StaticSystem::imposed_force(CaseLoads loads) const
{
    const double by_settlements = settlement_force(*structure_, loads);
    loads.settlements.clear();
    const Eigen::VectorXd f = assembler_->load_vector<double>(loads);
    const double by_loads = f.size() > 0 ? f.cwiseAbs().maxCoeff() : 0.0;
    return by_loads > 0.0 ? by_loads : by_settlements;
}

PreciseSystem& StaticSystem::precise()
{
    if (precise_) return *precise_;
    PreciseSparseMatrix K = equations_.pattern().matrix().cast<DoubleDouble>();
    assembler_->add_stiffness(K);
    for (const ArtificialRestraint& rotation : restraints_.rotations) add_restraint(rotation, K);
    for (const MemberEndRestraint& end : restraints_.member_ends)
        equations_.pattern().add_to_diagonal(K, end.equation, end.stiffness);
    PreciseSparseMatrix own;
    if (structure_->has_constraints) own = assembler_->constrained_stiffness<DoubleDouble>();
    return precise_.emplace(reduced_->precise(std::move(K), std::move(own)));
}

detail::CaseSolution StaticSystem::motion(const Eigen::VectorXd& x) const
{
    detail::CaseSolution motion;
    motion.displacements = node_displacements<double>(x, {});
    motion.member_ends = member_ends<double>(x);
    return motion;
}

template <class Scalar>
detail::Motions<Scalar> StaticSystem::motions(const CaseLoads& loads, const Column<Scalar>& all,
                                              const Column<Scalar>& constraint) const
{
    detail::Motions<Scalar> found;
    found.displacements = node_displacements<Scalar>(all, assembler_->settlements(loads));
    found.member_ends = member_ends<Scalar>(all);
    if (!structure_->has_constraints) return found;
    found.constraint_displacements = node_displacements<Scalar>(constraint, {});
    found.constraint_member_ends = member_ends<Scalar>(constraint);
    return found;
}

template <class Scalar>
std::vector<Scalar> StaticSystem::node_displacements(const Column<Scalar>& x,
                                                     const std::vector<double>& settlements) const
{
    const std::size_t n = model_dofs(structure_->kind).size();
    std::vector<Scalar> u(structure_->positions.size() * n, 0.0);
    for (std::size_t node = 0; node < structure_->positions.size(); ++node)
        for (std::size_t i = 0; i < n; ++i) {
            const std::int32_t row = equations_.of(NodeId(node), i);
            if (row != Equations::none) u[node * n + i] = x[row];
            else if (!settlements.empty()) u[node * n + i] = settlements[node * n + i];
        }
    assembler_->to_global(u);
    return u;
}

template <class Scalar> std::vector<Scalar> StaticSystem::member_ends(const Column<Scalar>& x) const
{
    std::vector<Scalar> ends(equations_.n_member_end_dofs(), 0.0);
    for (std::size_t i = 0; i < ends.size(); ++i)
        if (const std::int32_t row = equations_.member_end(i); row != Equations::none) ends[i] = x[row];
    return ends;
}

} // namespace femoop
