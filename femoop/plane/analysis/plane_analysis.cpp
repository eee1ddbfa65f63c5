#include "femoop/plane/analysis/plane_analysis.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "femoop/analysis/accuracy.h"
#include "femoop/analysis/equilibrium.h"
#include "femoop/analysis/memory_fault.h"
#include "femoop/analysis/overflow_check.h"
#include "femoop/analysis/static_system.h"
#include "femoop/analysis/stopwatch.h"
#include "femoop/load/case_terms.h"
#include "femoop/plane/analysis/plate_mechanism.h"
#include "femoop/plane/check/plane_check.h"
#include "femoop/solver/at_once.h"
#include "femoop/solver/available_memory.h"

namespace femoop::plane {

namespace {

constexpr double no_pivot = 1e-13;                      // of the diagonal: nothing is left of a stiffness
constexpr std::size_t elements_numbered_at_once = 5000; // while motions are sought

std::vector<CaseTerms> cases_of(const PlaneModel& model)
{
    std::vector<std::string_view> names;
    for (const PlaneLoadCase& load_case : model.load_cases) names.push_back(load_case.id);
    return femoop::cases_of(names, model.combinations);
}

void refuse(std::vector<Mechanism> mechanisms)
{
    constexpr std::size_t most_described = 12;
    if (mechanisms.empty()) return;
    const std::size_t n_more = mechanisms.size() - std::min(mechanisms.size(), most_described);
    mechanisms.resize(mechanisms.size() - n_more);
    throw MechanismError(std::move(mechanisms), n_more);
}

/// Modes of elements that no integration point feels: told by the nodes that move the most.
void refuse_soft_motion(const PlaneStructure& structure, const StaticSystem& system)
{
    const PlaneModel& model = structure.model();
    const std::vector<double> u = system.motion(system.reduced().softest_motion().x).displacements;
    if (strains(structure, u)) return;
    double largest = 0.0;
    for (const double value : u) largest = std::max(largest, std::abs(value));
    constexpr std::size_t most_named = 6;
    std::vector<std::string> points, regions;
    std::vector<bool> moves(model.regions.size());
    for (const PlaneElement& element : model.elements)
        for (const NodeId node : element.points)
            if (std::abs(u[2 * node.index]) + std::abs(u[2 * node.index + 1]) > 0.5 * largest)
                moves[element.region.index] = true;
    for (std::size_t i = 0; i < model.regions.size(); ++i)
        if (moves[i]) regions.push_back(model.regions[i].id);
    Mechanism mechanism{.fault = {.kind = FaultKind::RegionDeforms, .arguments = {}}, .motion = {}, .member_ends = {}};
    for (std::size_t i = 0; i < model.points.size(); ++i) {
        mechanism.motion.push_back({u[2 * i] / largest, u[2 * i + 1] / largest});
        if (std::abs(u[2 * i]) + std::abs(u[2 * i + 1]) > 0.9 * largest && points.size() < most_named)
            points.push_back(model.points[i].id);
    }
    mechanism.fault.arguments = {listed(regions), listed(points)};
    throw MechanismError({std::move(mechanism)});
}

void require_finite(const PlaneModel& model, const Eigen::MatrixXd& values)
{
    if (values.rows() == 0) return;
    for (Eigen::Index c = 0; c < values.cols(); ++c)
        if (!(values.col(c).cwiseAbs().maxCoeff<Eigen::PropagateNaN>() < largest_number))
            throw ModelError({{FaultKind::ResultsBeyondRange, {model.load_cases[static_cast<std::size_t>(c)].id}}});
}

/// Modulus times thickness so small that digits are lost, though each is a number.
void require_no_vanishing_stiffness(const PlaneModel& model)
{
    std::vector<std::string> regions;
    for (std::size_t i = 0; i < model.regions.size(); ++i) {
        const PlaneRegion& region = model.regions[i];
        if (region.is_hole) continue;
        const double stiffness = model[region.material].E * model.thickness(RegionId(i));
        if (stiffness < std::numeric_limits<double>::min()) regions.push_back(region.id);
    }
    if (!regions.empty()) throw ModelError({{FaultKind::StiffnessBeyondRange, {listed(regions)}}});
}

/// Elements so stiff, or so small, that their stiffness is no number. The sums of the others would not be any either.
void require_finite_stiffness(const PlaneModel& model, const StaticSystem& system)
{
    const SparseMatrix& K = system.reduced().matrix();
    for (Eigen::Index i = 0; i < K.nonZeros(); ++i)
        if (!(std::abs(K.valuePtr()[i]) < largest_number)) {
            std::vector<std::string> regions;
            for (const PlaneRegion& region : model.regions) regions.push_back(region.id);
            throw ModelError({{FaultKind::StiffnessBeyondRange, {listed(regions)}}});
        }
}

std::vector<Fault> all_ill_conditioned(const PlaneModel& model)
{
    std::vector<Fault> faults;
    for (const PlaneLoadCase& load_case : model.load_cases)
        faults.push_back({.kind = FaultKind::IllConditionedBody, .arguments = {load_case.id}});
    return faults;
}

/// Numbers may be in range and their products not.
void require_finite_results(const PlaneResults& results, const detail::Solution& solution)
{
    constexpr double harmless_number = 1e40;
    double largest = 0.0;
    for (const detail::CaseSolution& each : solution.solutions)
        for (const double u : each.displacements) largest = std::max(largest, std::abs(u));
    for (const CaseTerms& terms : solution.cases)
        for (const CaseTerms::Term& term : terms.terms) largest = std::max(largest, std::abs(term.factor));
    for (const Material& material : results.model().materials) largest = std::max(largest, material.E.value());
    if (largest < harmless_number) return;
    for (std::size_t c = 0; c < solution.cases.size(); ++c)
        if (!(results[CaseId(c)].energy() < largest_number))
            throw ModelError({{FaultKind::ResultsBeyondRange, {solution.cases[c].name}}});
}

/// Around an axis radial forces balance one another, and no moment is left.
void keep_axial_sums(detail::Solution& solution)
{
    for (detail::CaseSolution& each : solution.solutions)
        for (NodeVector* sum : {&each.equilibrium.sum_loads, &each.equilibrium.sum_reactions})
            *sum = {0.0, (*sum)[1], 0.0, 0.0, 0.0, 0.0};
}

} // namespace

struct PlaneAnalysis::Solved {
    std::vector<detail::CaseSolution> cases;
    AnalysisStatistics statistics;
};

PlaneAnalysis::PlaneAnalysis(AnalysisOptions options) : options_(std::move(options)) {}
PlaneAnalysis::~PlaneAnalysis() = default;

/// A body that can move as a whole is refused, else its equations are numbered, unless those that there are fit: at the
/// same time where there are many.
std::unique_ptr<StaticSystem> PlaneAnalysis::numbered(const PlaneStructure& structure, Solved& done)
{
    std::unique_ptr<StaticSystem> system;
    const auto number = [&] {
        if (system_ && have_same_equations(*system_->structure(), *structure.discretisation())) return;
        system_.reset();
        Stopwatch watch;
        system = std::make_unique<StaticSystem>(structure.discretisation(), options_.solver.kind);
        done.statistics.order = watch.lap();
    };
    if (structure.model().elements.size() < elements_numbered_at_once) {
        refuse(rigid_motions(structure));
        number();
        return system;
    }
    std::vector<Mechanism> motions;
    at_once([&] { motions = rigid_motions(structure); }, number);
    refuse(std::move(motions));
    return system;
}

/// The equations, ready to be factored: of a system that was numbered, or of the last one.
void PlaneAnalysis::assemble(const std::shared_ptr<const PlaneStructure>& structure,
                             std::unique_ptr<StaticSystem> numbered, Solved& done)
{
    if (!numbered) {
        Stopwatch watch;
        system_->update(structure->discretisation());
        structure_ = structure;
        done.statistics.assemble = watch.lap();
        require_finite_stiffness(structure->model(), *system_);
        return;
    }
    structure_ = structure;
    try {
        numbered->prepare(options_, done.statistics);
    } catch (const InsufficientMemory& refusal) {
        throw ModelError({insufficient_memory(refusal, numbered->reduced().matrix().rows())});
    }
    require_finite_stiffness(structure->model(), *numbered);
    system_ = std::move(numbered);
}

PlaneAnalysis::Solved PlaneAnalysis::solved(const std::shared_ptr<const PlaneStructure>& structure,
                                            const std::vector<CaseLoads>& loads)
{
    Solved done;
    assemble(structure, numbered(*structure, done), done);
    Stopwatch watch;
    const Pivots pivots = system_->factorize();
    system_->note_size(done.statistics);
    if (!pivots.is_complete || pivots.smallest_ratio <= no_pivot || system_->has_unrestrained_unknown())
        refuse_soft_motion(*structure, *system_);
    if (!pivots.is_complete) throw ModelError(all_ill_conditioned(structure->model()));
    done.statistics.factor = watch.lap();
    const Eigen::MatrixXd F = system_->load_vectors(loads);
    require_finite(structure->model(), F);
    const ReducedSystem::Displacements u = system_->solve(F, {});
    require_finite(structure->model(), u.all);
    done.statistics.backward_error = system_->reduced().backward_error();
    done.statistics.refinements = system_->reduced().refinements();
    done.cases = system_->solutions(loads, F, u);
    done.statistics.solve = watch.lap();
    return done;
}

PlaneResults PlaneAnalysis::solve(PlaneModel model)
{
    require_sound(model);
    return solve_sound(std::move(model));
}

PlaneResults PlaneAnalysis::solve_sound(PlaneModel model)
{
    require_no_vanishing_stiffness(model);
    auto structure = std::make_shared<const PlaneStructure>(std::move(model));
    auto solution = std::make_shared<detail::Solution>();
    solution->structure = structure->discretisation();
    solution->loads = structure->loads();
    solution->cases = cases_of(structure->model());
    Solved done = solved(structure, solution->loads);
    solution->solutions = std::move(done.cases);
    add_reactions(*solution);
    if (structure->model().analysis == StressState::Axisymmetric) keep_axial_sums(*solution);
    if (auto faults = ill_conditioned_cases(*solution, LeastForce::OfBodies); !faults.empty())
        throw ModelError(std::move(faults));
    solution->warnings = inaccurate_cases(*solution, LeastForce::OfBodies);
    PlaneResults results(std::move(structure), solution, done.statistics);
    require_finite_results(results, *solution);
    return results;
}

PlaneResults analyse(PlaneModel model, const AnalysisOptions& options)
{
    return PlaneAnalysis(options).solve(std::move(model));
}

} // namespace femoop::plane
