#include "femoop/analysis/linear_static.h"

#include <cmath>
#include <optional>
#include <stdexcept>
#include <utility>

#include "femoop/analysis/accuracy.h"
#include "femoop/analysis/equilibrium.h"
#include "femoop/analysis/mechanism_report.h"
#include "femoop/analysis/memory_fault.h"
#include "femoop/analysis/overflow_check.h"
#include "femoop/analysis/rigid_body.h"
#include "femoop/analysis/static_system.h"
#include "femoop/analysis/stopwatch.h"
#include "femoop/analysis/unstressed_cases.h"
#include "femoop/model/check/check.h"
#include "femoop/solver/available_memory.h"

namespace femoop {

namespace {

constexpr double doubtful_pivot = 1e-11;   // of the diagonal: a smaller one may be rounding alone
constexpr double harmless_pivot = 1e-6;    // of the diagonal: above it no condition was seen that costs digits
constexpr double poor_condition = 1e10;    // leaves some six correct digits
constexpr double unmeant_motion = 1e5;     // of the structure's size; exercises with E I = 1 stay well below
constexpr double unmeant_soft_motion = 10; // where a pivot is so small that something is soft beside the rest

} // namespace

/// The equations, and what was found of them when they were factored.
struct LinearStatic::Parts {
    Parts(const Model& model, std::shared_ptr<const Discretisation> structure, const AnalysisOptions& chosen)
        : options(chosen), system(std::move(structure), chosen.solver.kind)
    {
        statistics.order = watch.lap();
        prepare();
        factorize(model);
    }

    void prepare()
    {
        try {
            system.prepare(options, statistics);
        } catch (const InsufficientMemory& refusal) {
            throw ModelError({insufficient_memory(refusal, system.reduced().matrix().rows())});
        }
        watch.lap();
    }

    void factorize(const Model& model)
    {
        const MechanismReport report(model, system);
        const Pivots pivots = system.factorize();
        system.note_size(statistics);
        smallest_pivot = pivots.smallest_ratio;
        const bool is_doubtful = !pivots.is_complete || pivots.smallest_ratio <= doubtful_pivot ||
                                 (is_soft() && system.reduced().condition() >= poor_condition);
        if (is_doubtful || system.has_unrestrained_unknown() || report.has_too_few_members())
            report.require_geometric_stability();
        if (is_doubtful) soft_parts = report.soft_parts();
        is_beyond_doubles = !pivots.is_complete;
        report.require_held_members();
        statistics.factor = watch.lap();
    }

    void update(const Model& model, std::shared_ptr<const Discretisation> structure)
    {
        watch.lap();
        soft_parts.reset();
        system.update(std::move(structure));
        statistics.assemble = watch.lap();
        factorize(model);
    }

    bool is_soft() const { return smallest_pivot < harmless_pivot; }

    std::vector<detail::CaseSolution> solve(const Model& model, const std::vector<CaseLoads>& loads)
    {
        const MechanismReport report(model, system);
        watch.lap();
        const Eigen::MatrixXd F = system.load_vectors(loads);
        statistics.assemble += watch.lap();
        report.require_undriven(loads, F);
        if (is_beyond_doubles) return solve_precisely(model, loads);
        const Elimination imposed = system.imposed(loads);
        report.require_compatible(imposed);
        const ReducedSystem::Displacements u = system.solve(F, imposed.x0);
        statistics.backward_error = system.reduced().backward_error();
        statistics.refinements = system.reduced().refinements();
        report.require_finite(F);
        report.require_finite(u.all);
        auto solutions = system.solutions(loads, F, u);
        statistics.solve = watch.lap();
        return solutions;
    }

    /// To 32 digits; nothing where even they are too few.
    std::vector<detail::CaseSolution> solve_precisely(const Model& model, const std::vector<CaseLoads>& loads)
    {
        watch.lap();
        const Elimination imposed = system.imposed(loads);
        MechanismReport(model, system).require_compatible(imposed);
        auto solutions = system.solve_precisely(loads, imposed.x0);
        statistics.solve += watch.lap();
        return solutions;
    }

    AnalysisOptions options;
    Stopwatch watch;
    StaticSystem system;
    AnalysisStatistics statistics;
    double smallest_pivot = 1.0;    ///< of its diagonal entry
    bool is_beyond_doubles = false; ///< it holds, but not in doubles: no pivots are left to solve with
    std::optional<MechanismReport::SoftParts> soft_parts;
};

namespace {

/// Digits do not tell a mechanism from a structure that holds only just; its supports do, as far as they hold it as a
/// rigid body.
[[noreturn]] void refuse_cases(const Model& model, const Discretisation& structure, std::vector<Fault> faults)
{
    if (auto causes = unheld_parts(model, structure); !causes.empty()) throw ModelError(std::move(causes));
    throw ModelError(std::move(faults));
}

} // namespace

LinearStatic::LinearStatic(const Model& model, const AnalysisOptions& options)
{
    require_sound(model);
    parts_ = std::make_unique<Parts>(model, std::make_shared<const Discretisation>(discretise(model)), options);
}

void LinearStatic::update(const Model& model)
{
    require_sound(model);
    auto structure = std::make_shared<const Discretisation>(discretise(model));
    if (have_same_equations(*parts_->system.structure(), *structure)) parts_->update(model, std::move(structure));
    else parts_ = std::make_unique<Parts>(model, std::move(structure), parts_->options);
}

LinearStatic::~LinearStatic() = default;
LinearStatic::LinearStatic(LinearStatic&&) noexcept = default;
LinearStatic& LinearStatic::operator=(LinearStatic&&) noexcept = default;

Results LinearStatic::solve(const Model& model)
{
    const Discretisation& structure = *parts_->system.structure();
    if (model.nodes.size() != structure.positions.size() || model.members.size() != structure.members.size())
        throw std::invalid_argument("LinearStatic::solve: the model has another structure than the one factored");
    auto solution = std::make_shared<detail::Solution>();
    solution->structure = parts_->system.structure();
    solution->loads = loads_of(model, structure);
    solution->cases = cases_of(model);
    solution->member_end_dofs_of = parts_->system.equations().member_end_dofs_of();
    solution->solutions = parts_->solve(model, solution->loads);
    if (solution->solutions.empty() && !solution->loads.empty())
        refuse_cases(model, structure, unsolved_cases(*solution));
    add_reactions(*solution);
    bool is_precise = parts_->is_beyond_doubles;
    if (needs_precision(*solution))
        if (auto precise = parts_->solve_precisely(model, solution->loads); !precise.empty()) {
            solution->solutions = std::move(precise);
            add_reactions(*solution);
            is_precise = true;
        }
    if (auto faults = ill_conditioned_cases(*solution); !faults.empty())
        refuse_cases(model, structure, std::move(faults));
    solution->indeterminacy = count_indeterminacy(structure, parts_->system.restraints().rotations.size());
    if (const auto& soft = parts_->soft_parts; soft && (!is_precise || soft->is_nearly_loose))
        solution->warnings.push_back(soft->warning);
    for (Fault& warning : inaccurate_cases(*solution)) solution->warnings.push_back(std::move(warning));
    mark_unstressed_cases(*solution);
    const Results results(solution);
    if (auto faults = overflowing_cases(*solution, results); !faults.empty()) throw ModelError(std::move(faults));
    const double most = parts_->is_soft() ? unmeant_soft_motion : unmeant_motion;
    if (auto warning = huge_displacement(model, structure, results, most))
        solution->warnings.push_back(std::move(*warning));
    return results;
}

const AnalysisStatistics& LinearStatic::statistics() const { return parts_->statistics; }

Results analyse(const Model& model, const AnalysisOptions& options)
{
    return LinearStatic(model, options).solve(model);
}

} // namespace femoop
