#include "femoop/analysis/trace.h"

#include "femoop/analysis/assembly.h"
#include "femoop/model/check/check.h"

namespace femoop {

namespace {

/// The number of every equation as one counts on paper: node after node in the model's order, from 1.
std::vector<int> numbered_by_node(const Structure& structure, const Equations& equations)
{
    std::vector<int> place(equations.n_unknowns(), 0);
    int next = 1;
    for (std::size_t node = 0; node < structure.positions.size(); ++node)
        for (std::size_t i = 0; i < model_dofs(structure.kind).size(); ++i)
            if (const std::int32_t row = equations.of(NodeId(node), i); row != Equations::none) place[row] = next++;
    return place;
}

template <AnalysisKind kind> MemberTrace trace_of(const Model& model, const Structure& structure, MemberId member)
{
    constexpr int n = MemberElement<kind>::n;
    constexpr int m = MemberElement<kind>::m;
    const Equations equations(structure, SolverKind::Automatic);
    const Assembly<kind> assembly(structure, equations);
    const MemberFrame frame = structure.frame(member);
    const auto element = assembly.element(member, frame);

    MemberTrace trace;
    trace.member = model[member].id;
    trace.length = frame.length;
    for (const NodeId node : model[member].nodes)
        for (const Dof dof : AnalysisModel<kind>::global)
            trace.dofs.push_back(model[node].id + "." + std::string(name(dof)));
    trace.local_stiffness = element.local_stiffness();
    trace.transformation = Eigen::MatrixXd::Zero(2 * m, 2 * n);
    trace.transformation.topLeftCorner(m, n) = element.transformation(0);
    trace.transformation.bottomRightCorner(m, n) = element.transformation(1);
    trace.global_stiffness = element.stiffness();
    const std::vector<int> places = numbered_by_node(structure, equations);
    for (const std::int32_t row : assembly.node_equations(member))
        trace.equations.push_back(row == Equations::none ? 0 : places[row]);

    const std::vector<CaseLoads> loads = loads_of(model, structure);
    for (std::size_t c = 0; c < loads.size(); ++c) {
        SpanLoading loading;
        const std::array<SpanLoading::Scaled, 1> terms{{{.loads = loads[c].of(member)}}};
        loading.assign(frame.length, terms, structure.properties_of(member).xy.longest_piece(),
                       structure.properties_of(member).xy.settling());
        trace.fixed_end.push_back({.load_case = model.load_cases[c].id,
                                   .local = element.local_fixed_end_forces(loading),
                                   .global = element.fixed_end_forces(loading)});
    }
    return trace;
}

} // namespace

MemberTrace trace(const Model& model, MemberId member)
{
    require_sound(model);
    const Structure structure = structure_of(model);
    return with_model(model.analysis,
                      [&](auto kind) { return trace_of<decltype(kind)::value>(model, structure, member); });
}

} // namespace femoop
