#include "femoop/plane/analysis/natural_modes.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>

#include "femoop/analysis/memory_fault.h"
#include "femoop/analysis/static_system.h"
#include "femoop/analysis/stopwatch.h"
#include "femoop/plane/analysis/plate_mechanism.h"
#include "femoop/plane/check/plane_check.h"
#include "femoop/solver/available_memory.h"
#include "femoop/solver/eigenpairs.h"

namespace femoop::plane {

namespace {

bool has_mass(const PlaneModel& model, const PlaneRegion& region)
{
    return model[region.material].density && model[region.material].density->value() > 0.0;
}

/// Regions that only go along with others, though others have mass.
std::vector<Fault> massless_regions(const PlaneModel& model)
{
    std::vector<std::string> regions, materials;
    for (const PlaneRegion& region : model.regions) {
        if (has_mass(model, region)) continue;
        regions.push_back(region.id);
        const std::string& material = model[region.material].id;
        if (std::ranges::find(materials, material) == materials.end()) materials.push_back(material);
    }
    if (regions.size() == model.regions.size()) throw ModelError({{FaultKind::NothingHasMass, {}}});
    if (regions.empty()) return {};
    return {{.kind = FaultKind::RegionWithoutMass, .arguments = {listed(regions), listed(materials)}}};
}

Fault beyond_range(const PlaneModel& model)
{
    std::vector<std::string> regions;
    for (const PlaneRegion& region : model.regions) regions.push_back(region.id);
    return {.kind = FaultKind::StiffnessBeyondRange, .arguments = {listed(regions)}};
}

/// L D L' of an indefinite matrix: what CHOLMOD's roots of pivots cannot do.
std::unique_ptr<SymmetricSolver> indefinite_solver(const SystemPattern& pattern, const AnalysisOptions& options)
{
    SolverOptions chosen = options.solver;
    chosen.kind = pattern.solver() == SolverKind::Cholmod ? SolverKind::Multifrontal : pattern.solver();
    std::unique_ptr<SymmetricSolver> solver = make_solver(chosen);
    solver->analyse(pattern);
    return solver;
}

/// The equations of free vibration, and what makes modes of their solutions.
class Vibration {
public:
    Vibration(const PlaneStructure& structure, const AnalysisOptions& options)
        : structure_(structure), system_(structure.discretisation(), options.solver.kind)
    {
        Stopwatch watch;
        system_.assemble();
        mass_ = system_.equations().pattern().matrix();
        system_.assembler().add_mass(mass_);
        statistics_.assemble = watch.lap();
        try {
            solver_ = indefinite_solver(system_.equations().pattern(), options);
        } catch (const InsufficientMemory& refusal) {
            throw ModelError({insufficient_memory(refusal, mass_.rows())});
        }
        statistics_.order = watch.lap();
    }

    Eigenpairs solve(std::size_t wanted)
    {
        Stopwatch watch;
        try {
            Eigenpairs found = lowest_eigenpairs(system_.reduced().matrix(), mass_, wanted, *solver_);
            statistics_.solve = watch.lap();
            return found;
        } catch (const InsufficientMemory& refusal) {
            throw ModelError({insufficient_memory(refusal, mass_.rows())});
        } catch (const std::range_error&) {
            throw ModelError({beyond_range(structure_.model())});
        } catch (const std::domain_error&) {
            throw ModelError({{FaultKind::MasslessMotion, {}}});
        }
    }

    std::vector<double> displacements(const Eigen::VectorXd& x) const { return system_.motion(x).displacements; }
    AnalysisStatistics statistics() const
    {
        AnalysisStatistics all = statistics_;
        all.dofs = static_cast<std::size_t>(mass_.rows());
        all.nonzeros = static_cast<std::size_t>(mass_.nonZeros());
        all.factor_nonzeros = solver_->factor_nonzeros();
        all.factor_operations = solver_->predicted_operations();
        all.factor_bytes = solver_->predicted_bytes();
        all.solver = solver_->name();
        return all;
    }

private:
    const PlaneStructure& structure_;
    StaticSystem system_;
    SparseMatrix mass_;
    std::unique_ptr<SymmetricSolver> solver_;
    AnalysisStatistics statistics_;
};

/// The whole body's mass as its nodes have it, blocked ones too.
class NodeMasses {
public:
    explicit NodeMasses(const PlaneStructure& structure) : along_(structure.positions().size(), 0.0), total_(0.0)
    {
        ElementMatrix M;
        for (std::size_t e = 0; e < structure.model().elements.size(); ++e) {
            const ContinuumElement& element = structure.element(ElementId(e));
            element.mass(M);
            const std::span<const NodeId> nodes = element.dofs().nodes;
            for (std::size_t i = 0; i < nodes.size(); ++i)
                for (std::size_t j = 0; j < nodes.size(); ++j)
                    along_[nodes[i].index] += M(static_cast<Eigen::Index>(2 * i), static_cast<Eigen::Index>(2 * j));
        }
        for (const double mass : along_) total_ += mass;
    }

    double total() const { return total_; }
    /// phi' M r for r along x and along y.
    Eigen::Vector2d momentum(const std::vector<double>& displacements) const
    {
        Eigen::Vector2d sum = Eigen::Vector2d::Zero();
        for (std::size_t i = 0; i < along_.size(); ++i)
            sum += along_[i] * Eigen::Vector2d(displacements[2 * i], displacements[2 * i + 1]);
        return sum;
    }

private:
    std::vector<double> along_; ///< M r of each node, of the displacements along r
    double total_;
};

/// From displacements of M-norm 1.
NaturalMode mode_of(const std::vector<double>& displacements, const NodeMasses& masses, StressState analysis)
{
    Eigen::Vector2d momentum = masses.momentum(displacements);
    if (analysis == StressState::Axisymmetric) momentum.x() = 0.0;
    NaturalMode mode{.effective_mass = momentum.cwiseProduct(momentum)};
    for (std::size_t i = 0; i < displacements.size(); i += 2)
        mode.shape.emplace_back(displacements[i], displacements[i + 1]);
    Eigen::Vector2d largest = Eigen::Vector2d::Zero();
    constexpr double surely_larger = 1.0 + 1e-6; // of equal ones the first
    for (const Eigen::Vector2d& u : mode.shape)
        if (u.norm() > surely_larger * largest.norm()) largest = u;
    const double towards = std::abs(largest.x()) >= std::abs(largest.y()) ? largest.x() : largest.y();
    const double scale = std::copysign(1.0 / largest.norm(), towards);
    for (Eigen::Vector2d& u : mode.shape) u *= scale;
    mode.participation = momentum / scale;
    return mode;
}

/// Squares of frequencies as far as rounding lets them be told.
class Squares {
public:
    Squares(const Eigenpairs& pairs, std::size_t n_rigid) : pairs_(pairs), n_rigid_(n_rigid) {}

    bool is_small(std::size_t i) const { return value(i) <= lost * pairs_.rounding; }
    bool is_rigid(std::size_t i) const { return i < n_rigid_; }
    double value(std::size_t i) const { return pairs_.values[static_cast<Eigen::Index>(i)]; }
    double omega(std::size_t i) const { return is_rigid(i) || is_small(i) ? 0.0 : std::sqrt(value(i)); }
    int digits(std::size_t i) const // of the frequency
    {
        return static_cast<int>(std::floor(-std::log10(0.5 * pairs_.rounding / value(i))));
    }

private:
    static constexpr double lost = 100.0;
    const Eigenpairs& pairs_;
    std::size_t n_rigid_;
};

std::string number_of(std::size_t i) { return std::to_string(i + 1); }

} // namespace

double NaturalMode::frequency() const { return omega / (2.0 * std::numbers::pi); }

Eigen::Vector2d NaturalModes::displacement(const NaturalMode& mode, const Location& place) const
{
    const ContinuumElement& element = structure->element(place.element);
    const Shape::Values N = element.formulation().shape().values(place.at);
    Eigen::Vector2d u = Eigen::Vector2d::Zero();
    for (Eigen::Index i = 0; const NodeId node : element.dofs().nodes) u += N[i++] * mode.shape[node.index];
    return u;
}

NaturalModes natural_modes(const PlaneModel& model, std::optional<std::size_t> wanted, const AnalysisOptions& options)
{
    require_sound(model);
    auto structure = std::make_shared<const PlaneStructure>(model);
    NaturalModes found{.structure = structure, .warnings = massless_regions(model)};
    Vibration vibration(*structure, options);
    const Eigenpairs pairs = vibration.solve(wanted.value_or(usual_n_modes));
    found.statistics = vibration.statistics();
    const auto n_found = static_cast<std::size_t>(pairs.values.size());
    if (wanted && n_found < *wanted)
        throw ModelError({{FaultKind::TooFewModes, {std::to_string(*wanted), std::to_string(n_found)}}});

    const NodeMasses masses(*structure);
    found.total_mass = masses.total();
    const Squares squares(pairs, rigid_motions(*structure).size());
    constexpr int enough_digits = 6;
    constexpr double equal = 1e-7; // of a frequency
    for (std::size_t i = 0; i < std::min(n_found, wanted.value_or(usual_n_modes)); ++i) {
        const std::vector<double> u = vibration.displacements(pairs.vectors.col(static_cast<Eigen::Index>(i)));
        if (!squares.is_rigid(i) && squares.is_small(i) && strains(*structure, u))
            throw ModelError({{FaultKind::ModeLostInRounding, {number_of(i)}}});
        NaturalMode mode = mode_of(u, masses, model.analysis);
        mode.omega = squares.omega(i);
        while (mode.count < n_found && squares.omega(mode.count) <= mode.omega * (1.0 + equal)) ++mode.count;
        if (mode.omega > 0.0 && squares.digits(i) < enough_digits)
            found.warnings.push_back(
                {.kind = FaultKind::InaccurateMode, .arguments = {number_of(i), std::to_string(squares.digits(i))}});
        found.modes.push_back(std::move(mode));
    }
    if (!pairs.is_counted)
        found.warnings.push_back(
            {.kind = FaultKind::ModesNotCounted, .arguments = {std::to_string(found.modes.size())}});
    return found;
}

} // namespace femoop::plane
