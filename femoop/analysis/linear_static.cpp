#include "femoop/analysis/linear_static.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <type_traits>
#include <utility>

#include "femoop/analysis/accuracy.h"
#include "femoop/analysis/assembly.h"
#include "femoop/analysis/compatibility.h"
#include "femoop/analysis/constraints.h"
#include "femoop/analysis/equilibrium.h"
#include "femoop/analysis/idle_rotation.h"
#include "femoop/analysis/loose_members.h"
#include "femoop/analysis/mechanism_words.h"
#include "femoop/analysis/number_range.h"
#include "femoop/analysis/reduced_system.h"
#include "femoop/analysis/rigid_body.h"
#include "femoop/analysis/stopwatch.h"
#include "femoop/model/check/check.h"
#include "femoop/model/quantity/number_text.h"
#include "femoop/result/solution.h"
#include "femoop/solver/available_memory.h"

namespace femoop {

namespace {

constexpr double doubtful_pivot = 1e-11;    // of the diagonal: a smaller one may be rounding alone
constexpr double harmless_pivot = 1e-6;     // of the diagonal: above it no condition was seen that costs digits
constexpr double poor_condition = 1e10;     // leaves some six correct digits
constexpr double unmeant_motion = 1e5;      // of the structure's size; exercises with E I = 1 stay well below
constexpr double unmeant_soft_motion = 10;  // where a pivot is so small that something is soft beside the rest
constexpr Eigen::Index most_modes = 64;     // to look for in a structure that moves in many ways
constexpr Eigen::Index most_described = 12; // of them: who reads more sentences than that?

detail::Motions<double> rounded_motions(const detail::Motions<DoubleDouble>& motions)
{
    const auto round = [](const std::vector<DoubleDouble>& values) {
        std::vector<double> rounded;
        std::ranges::transform(values, std::back_inserter(rounded), &DoubleDouble::hi);
        return rounded;
    };
    return {.displacements = round(motions.displacements),
            .constraint_displacements = round(motions.constraint_displacements),
            .own_ends = round(motions.own_ends),
            .constraint_own_ends = round(motions.constraint_own_ends)};
}

} // namespace

/// The analysis of one structure, whatever the model.
struct LinearStatic::Parts {
    Parts(std::shared_ptr<const Structure> s, SolverKind solver)
        : structure(std::move(s)), equations(*structure, solver)
    {
        statistics.order = watch.lap();
    }
    virtual ~Parts() = default;
    Parts(const Parts&) = delete;
    Parts& operator=(const Parts&) = delete;
    virtual std::vector<detail::CaseSolution> solve(const Model& model, const std::vector<CaseLoads>& loads) = 0;
    /// To 32 digits; nothing where even they are too few.
    virtual std::vector<detail::CaseSolution> solve_precisely(const Model& model,
                                                              const std::vector<CaseLoads>& loads) = 0;
    virtual std::size_t n_held() const = 0; ///< rotations that no member takes part in
    bool is_soft() const { return smallest_pivot < harmless_pivot; }

    Stopwatch watch;
    std::shared_ptr<const Structure> structure;
    Equations equations;
    AnalysisStatistics statistics;
    double smallest_pivot = 1.0; ///< of its diagonal entry
    std::vector<Fault> warnings;
};

namespace {

template <AnalysisKind kind> class System final : public LinearStatic::Parts {
public:
    System(const Model& model, std::shared_ptr<const Structure> s, const AnalysisOptions& options)
        : Parts(std::move(s), options.solver.kind),
          assembly_(*structure, equations),
          precise_assembly_(*structure, equations),
          system_(assembled())
    {
        analyse(options);
        factor(model);
        if (!loose_members(model, *structure, assembly_).empty()) refuse(model, {});
        statistics.factor += watch.lap();
    }

    std::vector<detail::CaseSolution> solve(const Model& model, const std::vector<CaseLoads>& loads) override
    {
        watch.lap();
        const Eigen::MatrixXd F = load_vectors(assembly_, loads);
        statistics.assemble += watch.lap();
        refuse(driven(model, loads, F));
        if (is_beyond_doubles_) return solve_precisely(model, loads);
        const Displacements u = displacements(model, loads, F);
        statistics.backward_error = system_.backward_error();
        statistics.refinements = system_.refinements();
        require_finite(model, F);
        require_finite(model, u.all);
        const Eigen::VectorXd residuals = system_.out_of_balance(F, u);
        statistics.solve = watch.lap();

        std::vector<detail::CaseSolution> solutions;
        for (std::size_t c = 0; c < loads.size(); ++c) {
            const auto column = static_cast<Eigen::Index>(c);
            solutions.push_back({motions(assembly_, loads[c], {u.all, u.constraint}, column)});
            balance(solutions.back(), F.col(column), residuals[column]);
        }
        return solutions;
    }

    std::vector<detail::CaseSolution> solve_precisely(const Model& model, const std::vector<CaseLoads>& loads) override
    {
        watch.lap();
        const PreciseMatrix F = load_vectors(precise_assembly_, loads);
        const Eigen::MatrixXd x0 = structure->has_constraints ? imposed(model, loads) : Eigen::MatrixXd();
        const auto u = precise().solve(F, x0);
        std::vector<detail::CaseSolution> solutions;
        for (std::size_t c = 0; u && c < loads.size(); ++c) {
            const auto column = static_cast<Eigen::Index>(c);
            auto to_32_digits = motions(precise_assembly_, loads[c], {u->all, u->constraint}, column);
            solutions.push_back({rounded_motions(to_32_digits)});
            solutions.back().precise = std::move(to_32_digits);
            balance(solutions.back(), rounded(F.col(column)), u->out_of_balance[column]);
        }
        statistics.solve += watch.lap();
        return solutions;
    }

    std::size_t n_held() const override { return holds_.rotations.size(); }

private:
    static constexpr int n = Assembly<kind>::n;
    using Displacements = ReducedSystem::Displacements;

    ReducedSystem assembled()
    {
        watch.lap();
        SparseMatrix K = equations.pattern().matrix();
        assembly_.add_stiffness(K);
        std::optional<SparseMatrix> resisting;
        if (structure->has_constraints) resisting = resistance<kind>(*structure, equations, assembly_);
        holds_.rotations = hold_idle_rotations(*structure, equations, K, std::move(resisting));
        holds_.own_ends = hold_loose_own_ends<kind>(*structure, equations, assembly_, K);
        ReducedSystem system(equations, std::move(K));
        if (structure->has_constraints)
            system.constrain(eliminate_constraints<kind>(*structure, equations, assembly_, {}),
                             assembly_.constrained_stiffness());
        statistics.assemble = watch.lap();
        return system;
    }

    void analyse(const AnalysisOptions& options)
    {
        try {
            system_.analyse(options);
        } catch (const InsufficientMemory& refusal) {
            const auto gigabytes = [](double bytes) { return number_text(std::round(1e-7 * bytes) / 100.0); };
            throw ModelError({{FaultKind::MemoryInsufficient,
                               {std::to_string(system_.matrix().rows()), gigabytes(refusal.needed()),
                                gigabytes(refusal.available())}}});
        }
        statistics.order += watch.lap();
    }

    void factor(const Model& model)
    {
        const Pivots pivots = system_.factorize();
        note_size();
        smallest_pivot = pivots.smallest_ratio;
        const bool is_doubtful = !pivots.is_complete || pivots.smallest_ratio <= doubtful_pivot ||
                                 (is_soft() && system_.condition() >= poor_condition);
        if (is_doubtful || system_.has_idle_unknown() || has_too_few_members()) refuse_mechanism(model);
        if (is_doubtful) warn_of_soft_parts(model);
        is_beyond_doubles_ = !pivots.is_complete;
    }

    /// Fewer forces than equations: something moves, whatever the pivots say.
    bool has_too_few_members() const
    {
        const Indeterminacy count = count_indeterminacy(*structure, n_held());
        return !count.has_foundation && count.total() < 0;
    }

    void note_size()
    {
        const SymmetricSolver* solver = system_.solver();
        if (solver == nullptr) return;
        statistics.dofs = static_cast<std::size_t>(system_.matrix().rows());
        statistics.nonzeros = static_cast<std::size_t>(system_.matrix().nonZeros());
        statistics.factor_nonzeros = solver->factor_nonzeros();
        statistics.factor_operations = solver->predicted_operations();
        statistics.factor_bytes = solver->predicted_bytes();
        statistics.solver = solver->name();
    }

    /// Small pivots may come from a mechanism or from soft parts: the geometry alone decides.
    void refuse_mechanism(const Model& model)
    {
        require_finite_stiffness(model);
        const auto compatibility = Compatibility::of<kind>(*structure, equations, assembly_, holds_);
        const NullModes free = compatibility.free_motions(most_modes);
        if (free.is_singular()) refuse(model, free.modes);
    }

    void warn_of_soft_parts(const Model& model)
    {
        const ReducedSystem::SoftMotion soft = system_.softest_motion();
        if (std::isfinite(soft.condition)) warn(model, soft.condition, soft.x);
    }

    void warn(const Model& model, double condition, const Eigen::VectorXd& softest)
    {
        warnings.push_back(
            nearly_singular_fault(model, condition, node_displacements<double>(assembly_, softest, {}), n));
    }

    void require_finite_stiffness(const Model& model) const
    {
        std::vector<NodeId> nodes;
        for (std::size_t node = 0; node < structure->positions.size(); ++node)
            if (!has_finite_stiffness(NodeId(node))) nodes.emplace_back(node);
        if (!nodes.empty()) throw ModelError({beyond_range_fault(model, nodes)});
    }

    bool has_finite_stiffness(NodeId node) const
    {
        for (std::size_t i = 0; i < n; ++i) {
            const std::int32_t row = equations.of(node, i);
            if (row == Equations::none) continue;
            if (!(std::abs(system_.stiffness().coeff(row, row)) < largest_number)) return false;
        }
        return true;
    }

    static void require_finite(const Model& model, const Eigen::MatrixXd& values)
    {
        if (values.rows() == 0) return;
        for (Eigen::Index c = 0; c < values.cols(); ++c)
            if (!(values.col(c).cwiseAbs().template maxCoeff<Eigen::PropagateNaN>() < largest_number))
                throw ModelError({{FaultKind::ResultsBeyondRange, {model.load_cases[static_cast<std::size_t>(c)].id}}});
    }

    /// One column per load case, a row per unknown.
    template <class Scalar>
    auto load_vectors(const Assembly<kind, Scalar>& assembly, const std::vector<CaseLoads>& loads) const
    {
        Dense<Scalar> F(static_cast<Eigen::Index>(equations.n_unknowns()), static_cast<Eigen::Index>(loads.size()));
        for (std::size_t c = 0; c < loads.size(); ++c)
            F.col(static_cast<Eigen::Index>(c)) = assembly.load_vector(loads[c]);
        return F;
    }

    Displacements displacements(const Model& model, const std::vector<CaseLoads>& loads, const Eigen::MatrixXd& F)
    {
        return structure->has_constraints ? system_.solve(F, imposed(model, loads)) : system_.solve(F);
    }

    /// What constraints, settlements and heat impose on the unknowns.
    Eigen::MatrixXd imposed(const Model& model, const std::vector<CaseLoads>& loads) const
    {
        Elimination elimination = eliminate_constraints<kind>(*structure, equations, assembly_, loads);
        if (!elimination.conflicts.empty()) throw ModelError(conflict_faults(model, elimination.conflicts));
        return std::move(elimination.x0);
    }

    /// The system to 32 digits, made when it is first asked for.
    PreciseSystem& precise()
    {
        if (precise_) return *precise_;
        PreciseSparseMatrix K = equations.pattern().matrix().template cast<DoubleDouble>();
        precise_assembly_.add_stiffness(K);
        for (const HeldRotation& rotation : holds_.rotations) hold(rotation, K);
        for (const HeldEnd& end : holds_.own_ends) equations.pattern().add_to_diagonal(K, end.equation, end.stiffness);
        PreciseSparseMatrix own;
        if (structure->has_constraints) own = precise_assembly_.constrained_stiffness();
        return precise_.emplace(system_.precise(std::move(K), std::move(own)));
    }

    template <class Scalar> using Dense = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;
    template <class Scalar> using Column = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;
    template <class Scalar> struct Solved {
        const Dense<Scalar>& all;
        const Dense<Scalar>& constraint;
    };

    template <class Scalar>
    detail::Motions<Scalar> motions(const Assembly<kind, Scalar>& assembly, const CaseLoads& loads,
                                    const Solved<std::type_identity_t<Scalar>>& u, Eigen::Index c) const
    {
        detail::Motions<Scalar> found;
        found.displacements = node_displacements<Scalar>(assembly, u.all.col(c), assembly.settlements(loads));
        found.own_ends = own_ends<Scalar>(u.all.col(c));
        if (!structure->has_constraints) return found;
        found.constraint_displacements = node_displacements<Scalar>(assembly, u.constraint.col(c), {});
        found.constraint_own_ends = own_ends<Scalar>(u.constraint.col(c));
        return found;
    }

    static void balance(detail::CaseSolution& solution, const Eigen::VectorXd& F, double out_of_balance)
    {
        const double largest = F.size() > 0 ? F.cwiseAbs().maxCoeff() : 0.0;
        solution.balance = {.out_of_balance = out_of_balance, .imposed = largest};
        solution.equilibrium.residual = largest > 0.0 ? out_of_balance / largest : 0.0;
    }

    template <class Scalar>
    std::vector<Scalar> node_displacements(const Assembly<kind, Scalar>& assembly, const Column<Scalar>& x,
                                           const std::vector<double>& settlements) const
    {
        std::vector<Scalar> u(structure->positions.size() * n, 0.0);
        for (std::size_t node = 0; node < structure->positions.size(); ++node)
            for (std::size_t i = 0; i < n; ++i) {
                const std::int32_t row = equations.of(NodeId(node), i);
                if (row != Equations::none) u[node * n + i] = x[row];
                else if (!settlements.empty()) u[node * n + i] = settlements[node * n + i];
            }
        assembly.to_global(u);
        return u;
    }

    template <class Scalar> std::vector<Scalar> own_ends(const Column<Scalar>& x) const
    {
        std::vector<Scalar> ends(equations.n_own_ends(), 0.0);
        for (std::size_t i = 0; i < ends.size(); ++i)
            if (const std::int32_t row = equations.own_end(i); row != Equations::none) ends[i] = x[row];
        return ends;
    }

    /// Free motions of the system, and what it does not see: loose members, rotations held that a load drives.
    void refuse(const Model& model, const Eigen::MatrixXd& modes) const
    {
        const Eigen::Index n_described = std::min(modes.cols(), most_described);
        std::vector<Mechanism> mechanisms = loose_members(model, *structure, assembly_);
        append(mechanisms, mechanisms_of(model, structure, equations, motions(modes.leftCols(n_described))));
        const std::vector<CaseLoads> loads = loads_of(model, *structure);
        append(mechanisms, driven(model, loads, load_vectors(assembly_, loads)));
        std::vector<Fault> causes;
        if (modes.cols() > 0) causes = unheld_parts(model, *structure);
        causes.resize(std::min<std::size_t>(causes.size(), most_described));
        throw MechanismError(std::move(mechanisms), static_cast<std::size_t>(modes.cols() - n_described),
                             std::move(causes));
    }

    static void refuse(std::vector<Mechanism> mechanisms)
    {
        if (!mechanisms.empty()) throw MechanismError(std::move(mechanisms));
    }

    /// Motions of all nodes, and of members' own ends.
    std::vector<detail::CaseSolution> motions(const Eigen::MatrixXd& modes) const
    {
        std::vector<detail::CaseSolution> found;
        for (const auto mode : modes.colwise()) {
            detail::CaseSolution motion;
            motion.displacements = node_displacements<double>(assembly_, mode, {});
            motion.own_ends = own_ends<double>(mode);
            found.push_back(std::move(motion));
        }
        return found;
    }

    /// Rotations that are held because nothing takes part in them, but that loads drive.
    std::vector<Mechanism> driven(const Model& model, const std::vector<CaseLoads>& loads,
                                  const Eigen::MatrixXd& F) const
    {
        std::vector<Mechanism> mechanisms = driven_spins(model, *structure, F, holds_.rotations);
        append(mechanisms, driven_twists(model, *structure, assembly_, loads));
        return mechanisms;
    }

    static void append(std::vector<Mechanism>& mechanisms, std::vector<Mechanism> more)
    {
        std::move(more.begin(), more.end(), std::back_inserter(mechanisms));
    }

    Assembly<kind> assembly_;
    Assembly<kind, DoubleDouble> precise_assembly_;
    Holds holds_;
    ReducedSystem system_;
    std::optional<PreciseSystem> precise_;
    bool is_beyond_doubles_ = false; ///< it holds, but not in doubles: no pivots are left to solve with
};

std::unique_ptr<LinearStatic::Parts> make_system(const Model& model, const AnalysisOptions& options)
{
    auto structure = std::make_shared<const Structure>(structure_of(model));
    return with_model(model.analysis, [&](auto kind) -> std::unique_ptr<LinearStatic::Parts> {
        return std::make_unique<System<decltype(kind)::value>>(model, std::move(structure), options);
    });
}

/// Digits do not tell a mechanism from a structure that holds only just; its supports do, as far as they hold it as a
/// rigid body.
[[noreturn]] void refuse_cases(const Model& model, const Structure& structure, std::vector<Fault> faults)
{
    if (auto causes = unheld_parts(model, structure); !causes.empty()) throw ModelError(std::move(causes));
    throw ModelError(std::move(faults));
}

} // namespace

LinearStatic::LinearStatic(const Model& model, const AnalysisOptions& options)
{
    require_sound(model);
    parts_ = make_system(model, options);
}

LinearStatic::~LinearStatic() = default;
LinearStatic::LinearStatic(LinearStatic&&) noexcept = default;
LinearStatic& LinearStatic::operator=(LinearStatic&&) noexcept = default;

Results LinearStatic::solve(const Model& model)
{
    const Structure& structure = *parts_->structure;
    if (model.nodes.size() != structure.positions.size() || model.members.size() != structure.members.size())
        throw std::invalid_argument("LinearStatic::solve: the model has another structure than the one factored");
    auto solution = std::make_shared<detail::Solution>();
    solution->structure = parts_->structure;
    solution->loads = loads_of(model, structure);
    solution->cases = cases_of(model);
    solution->own_end_of = parts_->equations.own_end_of();
    solution->solutions = parts_->solve(model, solution->loads);
    if (solution->solutions.empty() && !solution->loads.empty())
        refuse_cases(model, structure, unsolved_cases(*solution));
    add_reactions(*solution);
    if (needs_precision(*solution))
        if (auto precise = parts_->solve_precisely(model, solution->loads); !precise.empty()) {
            solution->solutions = std::move(precise);
            add_reactions(*solution);
        }
    if (auto faults = ill_conditioned_cases(*solution); !faults.empty())
        refuse_cases(model, structure, std::move(faults));
    solution->indeterminacy = count_indeterminacy(structure, parts_->n_held());
    solution->warnings = parts_->warnings;
    for (Fault& warning : inaccurate_cases(*solution)) solution->warnings.push_back(std::move(warning));
    const Results results(solution);
    if (auto faults = cases_beyond_range(*solution, results); !faults.empty()) throw ModelError(std::move(faults));
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
