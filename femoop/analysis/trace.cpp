#include "femoop/analysis/trace.h"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <utility>

#include "femoop/algebra/congruence.h"
#include "femoop/analysis/assembler.h"
#include "femoop/analysis/constraints.h"
#include "femoop/discretisation/case_loads.h"
#include "femoop/discretisation/equations.h"
#include "femoop/discretisation/node_axes.h"
#include "femoop/element/member_element.h"
#include "femoop/model/check/check.h"
#include "femoop/solver/symmetric_solver.h"

namespace femoop {

namespace {

/// Calls visit(end, axis, equation) for the ends of a member behind joints that are not rigid, where it is tied.
template <class Visit> void visit_own_ends(const Equations& equations, MemberId member, Visit&& visit)
{
    if (equations.member_end_dofs_of().empty() || equations.member_end_dofs_of()[member.index] < 0) return;
    for (std::size_t end = 0; end < 2; ++end)
        for (std::size_t axis = 0; axis < n_local_axes; ++axis)
            if (const auto row = equations.of_member_end(member, end, static_cast<LocalAxis>(axis));
                row != Equations::none)
                visit(end, static_cast<LocalAxis>(axis), row);
}

/// The number of every equation as one counts on paper: node after node in the model's order, from 1, then the ends of
/// tied members.
std::vector<int> numbered_by_node(const Discretisation& structure, const Equations& equations)
{
    std::vector<int> place(equations.n_unknowns(), 0);
    int next = 1;
    for (std::size_t node = 0; node < structure.positions.size(); ++node)
        for (std::size_t i = 0; i < model_dofs(structure.kind).size(); ++i)
            if (const std::int32_t row = equations.of(NodeId(node), i); row != Equations::none) place[row] = next++;
    for (std::size_t i = 0; i < structure.members.size(); ++i)
        visit_own_ends(equations, MemberId(i), [&](std::size_t, LocalAxis, std::int32_t row) { place[row] = next++; });
    return place;
}

/// The axes of a member that matter to a trace: those it works in, and for a truss member those across it too, along
/// which it carries loads as a simple beam.
template <AnalysisKind kind> std::vector<LocalAxis> traced_axes()
{
    if (kind == AnalysisKind::Truss2d) return {LocalAxis::x, LocalAxis::y};
    if (kind == AnalysisKind::Truss3d) return {LocalAxis::x, LocalAxis::y, LocalAxis::z};
    return {AnalysisModel<kind>::local.begin(), AnalysisModel<kind>::local.end()};
}

/// One member's numbers, over the traced axes of its two ends.
template <AnalysisKind kind> class Tracer {
public:
    using Element = MemberElement<kind>;

    Tracer(const Element& element, const MemberEndConditions* end_conditions) : element_(element)
    {
        const bool is_bar = end_conditions != nullptr && end_conditions->is_bar;
        spans_simply_ = is_truss(kind) || is_bar;
        is_tied_ = end_conditions != nullptr && end_conditions->constraint != Constraint::None;
    }

    std::vector<std::string> names(const Model& model, const std::array<NodeId, 2>& nodes) const
    {
        std::vector<std::string> list;
        for (const NodeId node : nodes)
            for (const LocalAxis axis : axes_)
                list.push_back(model[node].id + "." + std::string(name(all_dofs[index(axis)])) + "'");
        return list;
    }

    Eigen::MatrixXd stiffness() const
    {
        Eigen::MatrixXd K = Eigen::MatrixXd::Zero(size(), size());
        const auto worked = worked_rows();
        K(worked, worked) = is_tied_ ? element_.rigid_joint_stiffness() : element_.local_stiffness();
        return K;
    }

    Eigen::MatrixXd transformation() const
    {
        Eigen::MatrixXd T = Eigen::MatrixXd::Zero(size(), 2 * Element::n);
        for (Eigen::Index end = 0; end < 2; ++end)
            for (Eigen::Index i = 0; i < n_axes(); ++i)
                T.block<1, Element::n>(end * n_axes() + i, end * Element::n) = element_.transformation_row(
                    static_cast<std::size_t>(end), axes_[static_cast<std::size_t>(i)]);
        return T;
    }

    Eigen::VectorXd fixed_end_forces(const SpanLoading& loading) const
    {
        Eigen::VectorXd f = Eigen::VectorXd::Zero(size());
        f(worked_rows()) = is_tied_ ? element_.rigid_joint_forces(loading) : element_.local_fixed_end_forces(loading);
        if (!spans_simply_) return f;
        for (const BendingPlane plane : {BendingPlane::xy, BendingPlane::xz}) {
            const Eigen::Index row = place_of(force_axis(plane));
            if (row == n_axes()) continue;
            const Eigen::Vector2d reactions = Beam::simple_span_forces(loading, plane);
            f[row] += reactions[0];
            f[n_axes() + row] += reactions[1];
        }
        return f;
    }

    /// Loads along what a constraint takes from a member, as its own stiffness would hold them.
    Eigen::VectorXd tied_forces(const Element& tied, const SpanLoading& loading) const
    {
        Eigen::VectorXd f = Eigen::VectorXd::Zero(size());
        f(worked_rows()) = tied.rigid_joint_forces(loading.without_strain());
        return f;
    }

    Eigen::Index row_of(std::size_t end, LocalAxis axis) const
    {
        return static_cast<Eigen::Index>(end) * n_axes() + place_of(axis);
    }

private:
    Eigen::Index n_axes() const { return static_cast<Eigen::Index>(axes_.size()); }
    Eigen::Index size() const { return 2 * n_axes(); }
    Eigen::Index place_of(LocalAxis axis) const { return std::ranges::find(axes_, axis) - axes_.begin(); }

    /// Where the element's own rows stand among the traced ones.
    std::vector<Eigen::Index> worked_rows() const
    {
        std::vector<Eigen::Index> rows;
        for (Eigen::Index end = 0; end < 2; ++end)
            for (const LocalAxis axis : AnalysisModel<kind>::local) rows.push_back(end * n_axes() + place_of(axis));
        return rows;
    }

    const Element& element_;
    std::vector<LocalAxis> axes_ = traced_axes<kind>();
    bool spans_simply_;
    bool is_tied_;
};

/// Gives the ends of a tied member that hang on joints unknowns of their own, as the assembled element has them: T, k
/// and f0 of what is there for its nodes.
void separate_own_ends(MemberTrace& trace, const Equations& equations, MemberId member, const MemberEndConditions& ends,
                       const std::function<Eigen::Index(std::size_t, LocalAxis)>& row_of)
{
    const Eigen::Index n = trace.transformation.cols();
    Eigen::MatrixXd gaps;
    Eigen::VectorXd joints;
    visit_own_ends(equations, member, [&](std::size_t end, LocalAxis axis, std::int32_t) {
        const Eigen::Index row = row_of(end, axis), column = trace.transformation.cols(), i = joints.size();
        trace.transformation.conservativeResize(Eigen::NoChange, column + 1);
        trace.transformation.col(column).setZero();
        gaps.conservativeResizeLike(Eigen::MatrixXd::Zero(i + 1, column + 1));
        gaps.row(i).head(n) = -trace.transformation.row(row).head(n);
        gaps(i, column) = 1.0;
        trace.transformation.row(row).setZero();
        trace.transformation(row, column) = 1.0;
        joints.conservativeResize(i + 1);
        joints[i] = ends.joints[end][index(axis)];
        trace.dofs.push_back(trace.member + (end == 0 ? ".start." : ".end.") +
                             std::string(name(all_dofs[index(axis)])) + "'");
    });
    const Eigen::MatrixXd& T = trace.transformation;
    trace.global_stiffness = congruence(trace.local_stiffness, T);
    if (joints.size() > 0) trace.global_stiffness += congruence(joints.asDiagonal(), gaps);
    for (MemberTrace::FixedEnd& forces : trace.fixed_end) forces.global = T.transpose() * forces.local;
}

template <AnalysisKind kind> MemberTrace trace_of(const Model& model, const Discretisation& structure, MemberId member)
{
    const Elements elements(structure);
    const Equations equations(structure, elements, SolverKind::Automatic);
    const NodeAxes axes(structure);
    const ElementDofs dofs = elements[member].dofs();
    const MemberGeometry geometry = structure.geometry(member);
    const MemberEndConditions* const end_conditions = structure.end_conditions_of(member);
    const MemberElement<kind> element(structure.properties_of(member), geometry, end_conditions,
                                      end_conditions == nullptr ? all_actions : elastic_actions(*end_conditions));
    const Tracer<kind> tracer(element, end_conditions);
    const bool is_tied = end_conditions != nullptr && end_conditions->constraint != Constraint::None;

    MemberTrace trace;
    trace.member = model[member].id;
    trace.length = geometry.length;
    for (const NodeId node : model[member].nodes)
        for (const Dof dof : AnalysisModel<kind>::global)
            trace.dofs.push_back(model[node].id + "." + std::string(name(dof)));
    trace.own_dofs = tracer.names(model, model[member].nodes);
    if (end_conditions != nullptr) trace.constraint = end_conditions->constraint;
    trace.local_stiffness = tracer.stiffness();
    trace.transformation = tracer.transformation();
    axes.turn_columns(dofs, trace.transformation);
    trace.to_nodes = trace.transformation.transpose();
    trace.global_stiffness = element.stiffness();
    axes.turn(dofs, trace.global_stiffness);
    const std::vector<int> places = numbered_by_node(structure, equations);
    for (const std::int32_t row : equations.of_element(member.index))
        trace.equations.push_back(row == Equations::none ? 0 : places[row]);

    const std::vector<CaseLoads> loads = loads_of(model, structure);
    for (std::size_t c = 0; c < loads.size(); ++c) {
        SpanLoading loading;
        const std::array<SpanLoading::Scaled, 1> terms{{{.loads = loads[c].of(member)}}};
        structure.properties_of(member).xy.cut(loading, geometry.length, terms);
        trace.fixed_end.push_back({.load_case = model.load_cases[c].id,
                                   .local = tracer.fixed_end_forces(loading),
                                   .global = element.fixed_end_forces(loading)});
        axes.turn_rows(dofs, trace.fixed_end.back().global);
        if (!is_tied) continue;
        const MemberElement<kind> tied(structure.properties_of(member), geometry, end_conditions,
                                       constrained_actions(*end_conditions));
        trace.fixed_end.back().local += tracer.tied_forces(tied, loading);
    }
    if (is_tied)
        separate_own_ends(trace, equations, member, *end_conditions,
                          [&](std::size_t end, LocalAxis axis) { return tracer.row_of(end, axis); });
    return trace;
}

std::vector<SystemTrace::Unknown> unknowns_of(const Model& model, const Discretisation& structure,
                                              const Equations& equations)
{
    std::vector<SystemTrace::Unknown> unknowns;
    for (std::size_t node = 0; node < structure.positions.size(); ++node)
        for (std::size_t i = 0; i < model_dofs(structure.kind).size(); ++i)
            if (equations.of(NodeId(node), i) != Equations::none)
                unknowns.push_back({NodeId(node), model_dofs(structure.kind)[i]});
    for (std::size_t i = 0; i < structure.members.size(); ++i)
        visit_own_ends(equations, MemberId(i), [&](std::size_t end, LocalAxis axis, std::int32_t) {
            unknowns.push_back({model.members[i].nodes[end], all_dofs[index(axis)], MemberId(i)});
        });
    return unknowns;
}

using OnPaper = Eigen::PermutationMatrix<Eigen::Dynamic>;

/// The system of a structure, from the order of elimination to that of paper.
class SystemTracer {
public:
    explicit SystemTracer(const Model& model)
        : model_(model),
          structure_(discretise(model)),
          elements_(structure_),
          equations_(structure_, elements_, SolverKind::Automatic),
          assembler_(structure_, elements_, equations_),
          loads_(loads_of(model, structure_)),
          places_(numbered_by_node(structure_, equations_)),
          on_paper_(static_cast<Eigen::Index>(equations_.n_unknowns()))
    {
        for (std::size_t i = 0; i < places_.size(); ++i)
            on_paper_.indices()[static_cast<Eigen::Index>(i)] = places_[i] - 1;
        lower_ = equations_.pattern().matrix();
        static_cast<void>(assembler_.add_stiffness(lower_));
    }

    SystemTrace run()
    {
        SystemTrace trace{.unknowns = unknowns_of(model_, structure_, equations_), .K = {}, .f = {}};
        trace.K = lower_.selfadjointView<Eigen::Lower>().twistedBy(on_paper_);
        trace_loads(trace);
        if (structure_.has_constraints) trace_ties(trace);
        else trace_order(trace);
        return trace;
    }

private:
    Eigen::MatrixXd load_vectors(const std::vector<CaseLoads>& loads) const
    {
        Eigen::MatrixXd f(static_cast<Eigen::Index>(equations_.n_unknowns()), static_cast<Eigen::Index>(loads.size()));
        for (std::size_t c = 0; c < loads.size(); ++c)
            f.col(static_cast<Eigen::Index>(c)) = on_paper_ * assembler_.load_vector<double>(loads[c]);
        return f;
    }

    void trace_loads(SystemTrace& trace) const
    {
        std::vector<CaseLoads> of_nodes(loads_.size()), of_supports(loads_.size()), of_members = loads_;
        for (std::size_t c = 0; c < loads_.size(); ++c) {
            of_nodes[c].nodes = std::exchange(of_members[c].nodes, {});
            of_supports[c].settlements = std::exchange(of_members[c].settlements, {});
        }
        trace.f = load_vectors(loads_);
        trace.f_of_nodes = load_vectors(of_nodes);
        trace.f_of_members = load_vectors(of_members);
        trace.f_of_supports = load_vectors(of_supports);
    }

    void trace_order(SystemTrace& trace) const
    {
        const BlockGraph graph = block_graph(structure_, elements_);
        const EliminationPlan plan = plan_elimination(SolverKind::Automatic, graph, BlockAdjacency(graph));
        trace.solver = plan.solver;
        trace.ordering = plan.ordering;
        trace.place.resize(places_.size());
        for (std::size_t i = 0; i < places_.size(); ++i)
            trace.place[static_cast<std::size_t>(places_[i]) - 1] = static_cast<std::int32_t>(i);
    }

    void trace_ties(SystemTrace& trace) const
    {
        SystemTrace::Ties& ties = trace.ties.emplace();
        const std::vector<ConstraintRow> rows = constraint_rows(assembler_, loads_);
        ties.C = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(rows.size()), trace.K.cols());
        ties.c.resize(ties.C.rows(), static_cast<Eigen::Index>(loads_.size()));
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const auto row = static_cast<Eigen::Index>(i);
            ties.members.push_back(rows[i].member);
            for (const ConstraintRow::Term& term : rows[i].terms)
                ties.C(row, paper_row(term.unknown)) += term.coefficient;
            ties.c.row(row) = rows[i].value.transpose();
        }
        trace_independent(trace, eliminate_constraints(assembler_, loads_));
    }

    Eigen::Index paper_row(Eigen::Index equation) const { return on_paper_.indices()[equation]; }

    /// The unknowns that are left, in the order of paper, and where the solver puts them.
    void trace_independent(SystemTrace& trace, const Elimination& elimination) const
    {
        SystemTrace::Ties& ties = *trace.ties;
        std::vector<bool> is_dependent(places_.size());
        for (const std::int32_t unknown : elimination.dependent) is_dependent[static_cast<std::size_t>(unknown)] = true;
        std::vector<std::pair<Eigen::Index, Eigen::Index>> columns; // on paper, of elimination.T
        for (std::size_t i = 0; i < is_dependent.size(); ++i)
            if (!is_dependent[i])
                columns.emplace_back(paper_row(static_cast<Eigen::Index>(i)),
                                     static_cast<Eigen::Index>(columns.size()));
        const SparseMatrix whole = lower_.selfadjointView<Eigen::Lower>();
        const SparseMatrix K =
            SparseMatrix(elimination.T.transpose() * whole * elimination.T).triangularView<Eigen::Lower>();
        const EliminationPlan plan = plan_elimination(SolverKind::Automatic, K);
        trace.solver = plan.solver;
        trace.ordering = plan.ordering;
        std::vector<std::int32_t> place_of(columns.size());
        for (std::size_t i = 0; i < plan.order.size(); ++i)
            place_of[static_cast<std::size_t>(plan.order[i])] = static_cast<std::int32_t>(i);

        std::ranges::sort(columns);
        SparseMatrix G(trace.K.rows(), static_cast<Eigen::Index>(columns.size()));
        std::vector<Eigen::Triplet<double>> entries;
        for (std::size_t i = 0; i < columns.size(); ++i) {
            const auto [unknown, column] = columns[i];
            ties.independent.push_back(unknown);
            trace.place.push_back(place_of[static_cast<std::size_t>(column)]);
            for (SparseMatrix::InnerIterator entry(elimination.T, column); entry; ++entry)
                entries.emplace_back(static_cast<int>(paper_row(entry.row())), static_cast<int>(i), entry.value());
        }
        G.setFromTriplets(entries.begin(), entries.end());
        ties.G = G;
        ties.u0 = on_paper_ * elimination.x0;
    }

    const Model& model_;
    const Discretisation structure_;
    const Elements elements_;
    const Equations equations_;
    const Assembler assembler_;
    const std::vector<CaseLoads> loads_;
    const std::vector<int> places_;
    OnPaper on_paper_;
    SparseMatrix lower_;
};

} // namespace

MemberTrace trace(const Model& model, MemberId member)
{
    require_sound(model);
    const Discretisation structure = discretise(model);
    return with_model(model.analysis,
                      [&](auto kind) { return trace_of<decltype(kind)::value>(model, structure, member); });
}

std::string unknown_name(const Model& model, const SystemTrace::Unknown& unknown)
{
    const std::string dof(name(unknown.dof));
    if (!unknown.end_of) return model[unknown.node].id + "." + dof;
    const Member& member = model[*unknown.end_of];
    return member.id + (member.nodes.front() == unknown.node ? ".start." : ".end.") + dof + "'";
}

SystemTrace trace_system(const Model& model)
{
    require_sound(model);
    return SystemTracer(model).run();
}

} // namespace femoop
