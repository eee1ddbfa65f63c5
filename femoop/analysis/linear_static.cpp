#include "femoop/analysis/linear_static.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <iomanip>
#include <iterator>
#include <optional>
#include <span>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "femoop/analysis/assembly.h"
#include "femoop/analysis/constraints.h"
#include "femoop/analysis/equilibrium.h"
#include "femoop/analysis/idle_rotation.h"
#include "femoop/analysis/mechanism_words.h"
#include "femoop/analysis/number_range.h"
#include "femoop/analysis/rigid_body.h"
#include "femoop/model/check/check.h"
#include "femoop/result/solution.h"
#include "femoop/solver/null_modes.h"
#include "femoop/solver/symmetric_solver.h"

namespace femoop {

namespace {

constexpr double doubtful_pivot = 1e-11;    // of the diagonal: a smaller one may be rounding alone
constexpr double harmless_pivot = 1e-6;     // of the diagonal: above it no condition was seen that costs digits
constexpr double poor_condition = 1e10;     // leaves some six correct digits
constexpr double zero_eigenvalue = 1e-14;   // of the scaled K: a free motion leaves less
constexpr Eigen::Index most_modes = 100;    // to look for in a structure that moves in many ways
constexpr Eigen::Index most_described = 12; // of them: who reads more sentences than that?

/// Seconds since it was last asked.
class Stopwatch {
public:
    double lap()
    {
        const auto now = std::chrono::steady_clock::now();
        const std::chrono::duration<double> passed = now - last_;
        last_ = now;
        return passed.count();
    }

private:
    std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

} // namespace

/// The analysis of one structure, whatever the model.
struct LinearStatic::Parts {
    Parts(std::shared_ptr<const Structure> s, SolverKind solver)
        : structure(std::move(s)), kind_of_solver(solver), equations(*structure, solver)
    {
        statistics.order = watch.lap();
    }
    virtual ~Parts() = default;
    Parts(const Parts&) = delete;
    Parts& operator=(const Parts&) = delete;
    virtual std::vector<detail::CaseSolution> solve(const Model& model, const std::vector<CaseLoads>& loads) = 0;
    virtual std::size_t n_held() const = 0; ///< rotations that no member takes part in

    Stopwatch watch;
    std::shared_ptr<const Structure> structure;
    SolverKind kind_of_solver;
    Equations equations;
    AnalysisStatistics statistics;
    std::vector<Fault> warnings;
};

namespace {

template <AnalysisKind kind> class System final : public LinearStatic::Parts {
public:
    System(const Model& model, std::shared_ptr<const Structure> s, SolverKind solver)
        : Parts(std::move(s), solver), assembly_(*structure, equations)
    {
        watch.lap();
        assemble();
        statistics.assemble = watch.lap();
        factor(model);
        if (!loose_members(model).empty()) refuse(model, Eigen::MatrixXd(K_.rows(), 0));
        statistics.factor += watch.lap();
    }

    std::vector<detail::CaseSolution> solve(const Model& model, const std::vector<CaseLoads>& loads) override
    {
        watch.lap();
        const Eigen::MatrixXd F = load_vectors(loads);
        statistics.assemble += watch.lap();
        refuse(driven(model, loads, F));
        const Displacements u = structure->has_constraints ? solve_constrained(model, loads, F)
                                                           : Displacements{.all = solver_ ? solver_->solve(F) : F};
        require_finite(model, F);
        require_finite(model, u.all);
        const Eigen::VectorXd residuals = relative_residuals(F, u);
        statistics.solve = watch.lap();

        std::vector<detail::CaseSolution> solutions;
        for (std::size_t c = 0; c < loads.size(); ++c) {
            solutions.push_back(case_solution(static_cast<Eigen::Index>(c), loads[c], u));
            solutions.back().equilibrium.residual = residuals[static_cast<Eigen::Index>(c)];
        }
        return solutions;
    }

    std::size_t n_held() const override { return held_.size(); }

private:
    static constexpr int n = Assembly<kind>::n;

    /// One column per load case, a row per unknown.
    struct Displacements {
        Eigen::MatrixXd all;
        Eigen::MatrixXd constraint; ///< what forces in constrained members follow from; empty where there are none
    };

    Eigen::MatrixXd load_vectors(const std::vector<CaseLoads>& loads) const
    {
        Eigen::MatrixXd F(static_cast<Eigen::Index>(equations.n_unknowns()), static_cast<Eigen::Index>(loads.size()));
        for (std::size_t c = 0; c < loads.size(); ++c)
            F.col(static_cast<Eigen::Index>(c)) = assembly_.load_vector(loads[c]);
        return F;
    }

    /// The largest force out of balance over the largest load, of every load case.
    Eigen::VectorXd relative_residuals(const Eigen::MatrixXd& F, const Displacements& u) const
    {
        Eigen::VectorXd ratios = Eigen::VectorXd::Zero(F.cols());
        if (F.rows() == 0) return ratios;
        Eigen::MatrixXd residual = F - K_.selfadjointView<Eigen::Lower>() * u.all;
        if (structure->has_constraints) residual -= K_constrained_.selfadjointView<Eigen::Lower>() * u.constraint;
        for (Eigen::Index c = 0; c < F.cols(); ++c)
            if (const double largest = F.col(c).cwiseAbs().maxCoeff(); largest > 0.0)
                ratios[c] = residual.col(c).cwiseAbs().maxCoeff() / largest;
        return ratios;
    }

    detail::CaseSolution case_solution(Eigen::Index c, const CaseLoads& loads, const Displacements& u) const
    {
        detail::CaseSolution solution;
        solution.displacements = node_displacements(u.all.col(c), assembly_.settlements(loads));
        solution.own_ends = own_ends(u.all.col(c));
        if (!structure->has_constraints) return solution;
        solution.constraint_displacements = node_displacements(u.constraint.col(c), {});
        solution.constraint_own_ends = own_ends(u.constraint.col(c));
        return solution;
    }

    void assemble()
    {
        K_ = equations.pattern().matrix();
        assembly_.add_stiffness(K_);
        held_ = hold_idle_rotations(*structure, equations, K_);
        if (!structure->has_constraints) return;
        const std::vector<ConstraintRow> rows = constraint_rows<kind>(*structure, assembly_, {});
        const Elimination elimination = eliminate(rows, equations.n_unknowns(), 0, row_scale());
        T_ = elimination.T;
        dependent_ = elimination.dependent;
        K_constrained_ = assembly_.constrained_stiffness();
    }

    /// A rotation counts as the displacement that it gives over a typical member.
    Eigen::VectorXd row_scale() const
    {
        Eigen::VectorXd scale = Eigen::VectorXd::Ones(static_cast<Eigen::Index>(equations.n_unknowns()));
        double length = 0.0;
        for (std::size_t i = 0; i < structure->members.size(); ++i) length += structure->frame(MemberId(i)).length;
        const double rotation_scale = static_cast<double>(structure->members.size()) / length;
        for (std::size_t node = 0; node < structure->positions.size(); ++node)
            for (std::size_t i = 0; i < n; ++i)
                if (index(AnalysisModel<kind>::global[i]) >= 3)
                    if (const std::int32_t row = equations.of(NodeId(node), i); row != Equations::none)
                        scale[row] = rotation_scale;
        for (std::size_t i = 0; i < equations.n_own_ends(); ++i)
            if (i % n_local_axes >= 3 && equations.own_end(i) != Equations::none)
                scale[equations.own_end(i)] = rotation_scale;
        return scale;
    }

    void factor(const Model& model)
    {
        if (structure->has_constraints) factor_constrained(model);
        else if (K_.rows() > 0) {
            solver_ = make_solver(equations.pattern().solver());
            solver_->analyse(equations.pattern());
            statistics.order += watch.lap();
            factorize(model, K_);
        }
    }

    void factor_constrained(const Model& model)
    {
        const SparseMatrix elastic = K_.template selfadjointView<Eigen::Lower>();
        const SparseMatrix reduced =
            SparseMatrix(T_.transpose() * elastic * T_).template triangularView<Eigen::Lower>();
        if (reduced.rows() > 0) {
            solver_ = solver_for(reduced, kind_of_solver);
            statistics.order += watch.lap();
            factorize(model, reduced);
        }
        if (dependent_.empty()) return;
        std::vector<Eigen::Triplet<double>> pick;
        for (std::size_t i = 0; i < dependent_.size(); ++i) pick.emplace_back(dependent_[i], static_cast<int>(i), 1.0);
        S_.resize(K_.rows(), static_cast<Eigen::Index>(dependent_.size()));
        S_.setFromTriplets(pick.begin(), pick.end());
        const SparseMatrix own = K_constrained_.template selfadjointView<Eigen::Lower>();
        const SparseMatrix picked = SparseMatrix(S_.transpose() * own * S_).template triangularView<Eigen::Lower>();
        constraint_solver_ = solver_for(picked, kind_of_solver);
        constraint_solver_->factorize(picked);
    }

    void factorize(const Model& model, const SparseMatrix& K)
    {
        statistics.dofs = static_cast<std::size_t>(K.rows());
        statistics.nonzeros = static_cast<std::size_t>(K.nonZeros());
        statistics.solver = solver_->name();
        const Pivots pivots = solver_->factorize(K);
        statistics.factor_nonzeros = solver_->factor_nonzeros();
        if (!pivots.is_positive_definite || pivots.smallest_ratio <= doubtful_pivot) refuse_mechanism(model, K);
        else if (pivots.smallest_ratio < harmless_pivot) warn_of_condition(model, K);
    }

    /// Refuses what can move freely, and warns of what nearly can.
    void refuse_mechanism(const Model& model, const SparseMatrix& K)
    {
        require_finite(model);
        const NullModes free = null_modes(K, zero_eigenvalue, most_modes);
        if (free.is_singular()) refuse(model, free.modes);
        warn(model, free.condition, free.softest);
    }

    /// Pivots stood, but many small ones after one another lose digits too.
    void warn_of_condition(const Model& model, const SparseMatrix& K)
    {
        const double condition = condition_estimate(*solver_, K);
        if (condition < poor_condition) return;
        const NullModes free = null_modes(K, zero_eigenvalue, most_modes);
        warn(model, condition, free.is_singular() ? free.modes.col(0) : free.softest);
    }

    void warn(const Model& model, double condition, const Eigen::VectorXd& softest)
    {
        const std::vector<double> motion = node_displacements(all_unknowns(softest), {});
        warnings.push_back(nearly_singular_fault(model, condition, motion, n));
    }

    void require_finite(const Model& model) const
    {
        std::vector<NodeId> nodes;
        for (std::size_t node = 0; node < structure->positions.size(); ++node)
            for (std::size_t i = 0; i < n; ++i) {
                const std::int32_t row = equations.of(NodeId(node), i);
                const bool is_new = nodes.empty() || nodes.back() != NodeId(node);
                if (row != Equations::none && is_new && !(std::abs(K_.coeff(row, row)) < largest_number))
                    nodes.emplace_back(node);
            }
        if (!nodes.empty()) throw ModelError({beyond_range_fault(model, nodes)});
    }

    static void require_finite(const Model& model, const Eigen::MatrixXd& values)
    {
        if (values.rows() == 0) return;
        for (Eigen::Index c = 0; c < values.cols(); ++c)
            if (!(values.col(c).cwiseAbs().template maxCoeff<Eigen::PropagateNaN>() < largest_number))
                throw ModelError({{FaultKind::ResultsBeyondRange, {model.load_cases[static_cast<std::size_t>(c)].id}}});
    }

    /// From the unknowns that constraints leave independent.
    Eigen::VectorXd all_unknowns(const Eigen::VectorXd& independent) const
    {
        return structure->has_constraints ? Eigen::VectorXd(T_ * independent) : independent;
    }

    Displacements solve_constrained(const Model& model, const std::vector<CaseLoads>& loads, const Eigen::MatrixXd& F)
    {
        const std::vector<ConstraintRow> rows = constraint_rows<kind>(*structure, assembly_, loads);
        const Elimination elimination = eliminate(rows, equations.n_unknowns(), loads.size(), row_scale());
        refuse(model, elimination.conflicts);
        const auto K = K_.template selfadjointView<Eigen::Lower>();
        const Eigen::MatrixXd load = T_.transpose() * (F - K * elimination.x0);
        Displacements u{.all = elimination.x0, .constraint = Eigen::MatrixXd::Zero(F.rows(), F.cols())};
        if (T_.cols() > 0) u.all += T_ * solver_->solve(load);
        if (dependent_.empty()) return u;
        const Eigen::MatrixXd out_of_balance = F - K * u.all;
        u.constraint = S_ * constraint_solver_->solve(S_.transpose() * out_of_balance);
        return u;
    }

    std::vector<double> node_displacements(const Eigen::VectorXd& x, const std::vector<double>& settlements) const
    {
        std::vector<double> u(structure->positions.size() * n, 0.0);
        for (std::size_t node = 0; node < structure->positions.size(); ++node)
            for (std::size_t i = 0; i < n; ++i) {
                const std::int32_t row = equations.of(NodeId(node), i);
                if (row != Equations::none) u[node * n + i] = x[row];
                else if (!settlements.empty()) u[node * n + i] = settlements[node * n + i];
            }
        assembly_.to_global(u);
        return u;
    }

    std::vector<double> own_ends(const Eigen::VectorXd& x) const
    {
        std::vector<double> ends(equations.n_own_ends(), 0.0);
        for (std::size_t i = 0; i < ends.size(); ++i)
            if (const std::int32_t row = equations.own_end(i); row != Equations::none) ends[i] = x[row];
        return ends;
    }

    /// Modes of the reduced system, and what it does not see: loose members, rotations held that a load drives.
    void refuse(const Model& model, const Eigen::MatrixXd& modes) const
    {
        const Eigen::Index n_described = std::min(modes.cols(), most_described);
        std::vector<Mechanism> mechanisms = loose_members(model);
        append(mechanisms, mechanisms_of(model, structure, equations, motions(modes.leftCols(n_described))));
        const std::vector<CaseLoads> loads = loads_of(model, *structure);
        append(mechanisms, driven(model, loads, load_vectors(loads)));
        std::vector<Fault> causes;
        if (modes.cols() > 0) causes = unheld_parts(model, *structure);
        causes.resize(std::min<std::size_t>(causes.size(), most_described));
        throw MechanismError(std::move(mechanisms), static_cast<std::size_t>(modes.cols() - n_described),
                             std::move(causes));
    }

    static void append(std::vector<Mechanism>& mechanisms, std::vector<Mechanism> more)
    {
        std::move(more.begin(), more.end(), std::back_inserter(mechanisms));
    }

    /// Modes of the reduced system as motions of all nodes, and of members' own ends.
    std::vector<detail::CaseSolution> motions(const Eigen::MatrixXd& modes) const
    {
        std::vector<detail::CaseSolution> found;
        for (const auto mode : modes.colwise()) {
            const Eigen::VectorXd x = all_unknowns(mode);
            detail::CaseSolution motion;
            motion.displacements = node_displacements(x, {});
            motion.own_ends = own_ends(x);
            found.push_back(std::move(motion));
        }
        return found;
    }

    void refuse(const Model& model, const std::vector<Elimination::Conflict>& conflicts) const
    {
        if (!conflicts.empty()) throw ModelError(conflict_faults(model, conflicts));
    }

    /// What members do between their releases stands in no equation: the releases are condensed.
    std::vector<Mechanism> loose_members(const Model& model) const
    {
        std::vector<Mechanism> mechanisms;
        visit_jointed_members([&](MemberId member, const MemberFrame&, const auto& element) {
            for (const LooseEnd& loose : element.loose_ends())
                if (loose.axis != LocalAxis::rx) mechanisms.push_back(flying_member(model, *structure, member, loose));
        });
        return mechanisms;
    }

    /// Rotations that are held because nothing takes part in them, but that loads drive.
    std::vector<Mechanism> driven(const Model& model, const std::vector<CaseLoads>& loads,
                                  const Eigen::MatrixXd& F) const
    {
        std::vector<Mechanism> mechanisms = driven_spins(model, *structure, F, held_);
        append(mechanisms, driven_twists(model, loads));
        return mechanisms;
    }

    /// A member released against torsion at both ends is held, unless a torque on it drives the twist.
    std::vector<Mechanism> driven_twists(const Model& model, const std::vector<CaseLoads>& loads) const
    {
        std::vector<Mechanism> mechanisms;
        visit_jointed_members([&](MemberId member, const MemberFrame& frame, const auto& element) {
            for (const CaseLoads& each : loads)
                if (const auto twist = driven_twist(member, frame, element, each.of(member))) {
                    mechanisms.push_back(flying_member(model, *structure, member, *twist));
                    return; // the same for every case
                }
        });
        return mechanisms;
    }

    template <class Element>
    std::optional<LooseEnd> driven_twist(MemberId member, const MemberFrame& frame, const Element& element,
                                         std::span<const SpanLoad> loads) const
    {
        if (loads.empty()) return std::nullopt;
        SpanLoading loading;
        const std::array<SpanLoading::Scaled, 1> terms{{{.loads = loads}}};
        loading.assign(frame.length, terms, structure->properties_of(member).xy.longest_piece(),
                       structure->properties_of(member).xy.settling());
        const auto forces = element.rigid_joint_forces(loading);
        for (const LooseEnd& loose : element.loose_ends(forces))
            if (loose.axis == LocalAxis::rx && std::abs(loose.drive) > 1e-9 * forces.cwiseAbs().maxCoeff())
                return loose;
        return std::nullopt;
    }

    /// Calls visit(member, frame, element) for every member that hangs on a release or spring and that no constraint
    /// ties.
    template <class Visit> void visit_jointed_members(Visit&& visit) const
    {
        for (std::size_t i = 0; i < structure->members.size(); ++i) {
            const MemberExtras* extras = structure->extras_of(MemberId(i));
            if (extras == nullptr || !extras->has_flexible_joint || extras->constraint != Constraint::None) continue;
            const MemberFrame frame = structure->frame(MemberId(i));
            visit(MemberId(i), frame, assembly_.element(MemberId(i), frame));
        }
    }

    static void refuse(std::vector<Mechanism> mechanisms)
    {
        if (!mechanisms.empty()) throw MechanismError(std::move(mechanisms));
    }

    Assembly<kind> assembly_;
    SparseMatrix K_;             ///< elastic, lower triangle, over all unknowns
    SparseMatrix K_constrained_; ///< own stiffness of what constraints take away
    SparseMatrix T_, S_;         ///< all unknowns from the independent, from the dependent ones
    std::vector<std::int32_t> dependent_;
    std::vector<HeldRotation> held_;
    std::unique_ptr<SymmetricSolver> solver_, constraint_solver_;
};

std::unique_ptr<LinearStatic::Parts> make_system(const Model& model, SolverKind wanted)
{
    auto structure = std::make_shared<const Structure>(structure_of(model));
    return with_model(model.analysis, [&](auto kind) -> std::unique_ptr<LinearStatic::Parts> {
        return std::make_unique<System<decltype(kind)::value>>(model, std::move(structure), wanted);
    });
}

} // namespace

LinearStatic::LinearStatic(const Model& model, const AnalysisOptions& options)
{
    require_sound(model);
    parts_ = make_system(model, options.solver);
}

LinearStatic::~LinearStatic() = default;
LinearStatic::LinearStatic(LinearStatic&&) noexcept = default;
LinearStatic& LinearStatic::operator=(LinearStatic&&) noexcept = default;

namespace {

/// The first node that moves so far that nobody can mean it. Models for exercises with E I = 1 stay well below.
std::optional<Fault> huge_displacement(const Model& model, const Structure& structure, const Results& results)
{
    constexpr double huge = 1e5; // of the structure's size
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3d& position : structure.positions) box.extend(position);
    const double limit = huge * (box.isEmpty() ? 0.0 : box.diagonal().norm());
    for (std::size_t c = 0; c < model.load_cases.size(); ++c) {
        const CaseResult result = results[CaseId(c)];
        for (std::size_t i = 0; i < structure.positions.size(); ++i) {
            const NodeVector u = result.displacement(NodeId(i));
            const double distance = std::hypot(u[0], u[1], u[2]);
            if (distance <= limit) continue;
            std::ostringstream text;
            text << std::setprecision(3) << distance << ' ' << name(model.units.length);
            return Fault{.kind = FaultKind::HugeDisplacement,
                         .arguments = {model.nodes[i].id, text.str(), model.load_cases[c].id}};
        }
    }
    return std::nullopt;
}

} // namespace

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
    add_reactions(*solution);
    solution->indeterminacy = count_indeterminacy(structure, parts_->n_held());
    solution->warnings = parts_->warnings;
    const Results results(solution);
    if (auto faults = cases_beyond_range(*solution, results); !faults.empty()) throw ModelError(std::move(faults));
    if (auto warning = huge_displacement(model, structure, results)) solution->warnings.push_back(std::move(*warning));
    return results;
}

const AnalysisStatistics& LinearStatic::statistics() const { return parts_->statistics; }

Results analyse(const Model& model, const AnalysisOptions& options)
{
    return LinearStatic(model, options).solve(model);
}

} // namespace femoop
