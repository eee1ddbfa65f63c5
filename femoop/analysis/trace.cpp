#include "femoop/analysis/trace.h"

#include <algorithm>
#include <cstdint>

#include "femoop/analysis/assembler.h"
#include "femoop/discretisation/case_loads.h"
#include "femoop/discretisation/equations.h"
#include "femoop/discretisation/node_axes.h"
#include "femoop/element/member_element.h"
#include "femoop/model/check/check.h"

namespace femoop {

namespace {

/// The number of every equation as one counts on paper: node after node in the model's order, from 1.
std::vector<int> numbered_by_node(const Discretisation& structure, const Equations& equations)
{
    std::vector<int> place(equations.n_unknowns(), 0);
    int next = 1;
    for (std::size_t node = 0; node < structure.positions.size(); ++node)
        for (std::size_t i = 0; i < model_dofs(structure.kind).size(); ++i)
            if (const std::int32_t row = equations.of(NodeId(node), i); row != Equations::none) place[row] = next++;
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
        K(worked, worked) = element_.local_stiffness();
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
        f(worked_rows()) = element_.local_fixed_end_forces(loading);
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
};

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
    trace.global_stiffness = element.stiffness();
    axes.turn(dofs, trace.global_stiffness);
    const std::vector<int> places = numbered_by_node(structure, equations);
    for (const std::int32_t row : equations.of_element(member.index).first(dofs.n_of_nodes()))
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
    }
    return trace;
}

std::vector<SystemTrace::Unknown> unknowns_of(const Discretisation& structure, const Equations& equations)
{
    std::vector<SystemTrace::Unknown> unknowns;
    for (std::size_t node = 0; node < structure.positions.size(); ++node)
        for (std::size_t i = 0; i < model_dofs(structure.kind).size(); ++i)
            if (equations.of(NodeId(node), i) != Equations::none)
                unknowns.push_back({NodeId(node), model_dofs(structure.kind)[i]});
    return unknowns;
}

} // namespace

MemberTrace trace(const Model& model, MemberId member)
{
    require_sound(model);
    const Discretisation structure = discretise(model);
    return with_model(model.analysis,
                      [&](auto kind) { return trace_of<decltype(kind)::value>(model, structure, member); });
}

SystemTrace trace_system(const Model& model)
{
    require_sound(model);
    const Discretisation structure = discretise(model);
    const Elements elements(structure);
    const Equations equations(structure, elements, SolverKind::Automatic);
    const Assembler assembler(structure, elements, equations);

    Eigen::PermutationMatrix<Eigen::Dynamic> on_paper(static_cast<Eigen::Index>(equations.n_unknowns()));
    const std::vector<int> places = numbered_by_node(structure, equations);
    for (std::size_t i = 0; i < places.size(); ++i) on_paper.indices()[static_cast<Eigen::Index>(i)] = places[i] - 1;

    SparseMatrix lower = equations.pattern().matrix();
    static_cast<void>(assembler.add_stiffness(lower));
    SystemTrace trace{.unknowns = unknowns_of(structure, equations), .K = {}, .f = {}};
    trace.K = lower.selfadjointView<Eigen::Lower>().twistedBy(on_paper);
    const std::vector<CaseLoads> loads = loads_of(model, structure);
    trace.f.resize(static_cast<Eigen::Index>(equations.n_unknowns()), static_cast<Eigen::Index>(loads.size()));
    for (std::size_t c = 0; c < loads.size(); ++c)
        trace.f.col(static_cast<Eigen::Index>(c)) = on_paper * assembler.load_vector<double>(loads[c]);
    return trace;
}

} // namespace femoop
