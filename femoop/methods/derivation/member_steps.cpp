#include "femoop/methods/derivation/member_steps.h"

#include <cmath>
#include <utility>

#include "femoop/element/analysis_model.h"
#include "femoop/result/curve_reader.h"

namespace femoop::derivation {

namespace {

NamedMatrix column(std::string symbol, const std::vector<NamedNumber>& numbers)
{
    NamedMatrix matrix{.symbol = std::move(symbol), .rows = {}, .columns = {""}, .values = {}};
    matrix.values.resize(static_cast<Eigen::Index>(numbers.size()), 1);
    for (const NamedNumber& number : numbers) {
        matrix.values(static_cast<Eigen::Index>(matrix.rows.size()), 0) = number.value;
        matrix.rows.push_back(number.name);
    }
    return matrix;
}

bool is_stiff(double value) { return value > 0.0 && std::isfinite(value); }

/// What a tapered member is made of at its two ends.
std::vector<NamedNumber> tapered_numbers(const MemberProperties& properties, double L)
{
    const Beam& beam = properties.xy;
    const auto [a1, a2, a3] = beam.taper.inertia;
    std::vector<NamedNumber> numbers{{"L", L},
                                     {"h(0)", properties.depth},
                                     {"h(L)", properties.depth * (1.0 + beam.taper.depth * L)},
                                     {"EA(0)", properties.axial.EA},
                                     {"EA(L)", properties.axial.EA * (1.0 + properties.axial.taper * L)},
                                     {"EI(0)", beam.EI},
                                     {"EI(L)", beam.EI * (1.0 + L * (a1 + L * (a2 + L * a3)))},
                                     {"a1", a1},
                                     {"a2", a2},
                                     {"a3", a3}};
    if (beam.shear_flexibility > 0.0) {
        numbers.push_back({"GAs(0)", 1.0 / beam.shear_flexibility});
        numbers.push_back({"GAs(L)", (1.0 + beam.taper.shear_area * L) / beam.shear_flexibility});
    }
    return numbers;
}

} // namespace

MemberSteps::MemberSteps(const PaperSystem& system, MemberId member)
    : system_(system), member_(member), trace_(femoop::trace(system.model(), member))
{}

NamedMatrix MemberSteps::data() const
{
    const MemberProperties& properties = system_.structure().properties_of(member_);
    const AnalysisKind kind = system_.structure().kind;
    const bool is_space = is_3d(kind), twists = is_space || kind == AnalysisKind::Grillage;
    std::vector<NamedNumber> numbers{{"L", trace_.length}};
    const auto add = [&](const char* name, double value) {
        if (is_stiff(value)) numbers.push_back({name, value});
    };
    if (!properties.xy.taper.is_prismatic()) {
        numbers = tapered_numbers(properties, trace_.length);
        add_joints(numbers);
        return column("data", numbers);
    }
    if (kind != AnalysisKind::Grillage && !is_tied()) add("EA", properties.axial.EA);
    if (trace_.constraint == Constraint::Rigid) {
        add("foundation", properties.xy.foundation);
    } else if (!is_truss(kind)) {
        if (twists) add("GJ", properties.torsion.EA);
        add(is_space ? "EIz" : "EI", properties.xy.EI);
        add(is_space ? "GAsy" : "GAs", 1.0 / properties.xy.shear_flexibility);
        if (is_space) add("EIy", properties.xz.EI);
        if (is_space) add("GAsz", 1.0 / properties.xz.shear_flexibility);
        add("foundation", properties.xy.foundation);
    }
    add_joints(numbers);
    return column("data", numbers);
}

std::string MemberSteps::row_name(std::size_t end, LocalAxis axis) const
{
    return system_.model()[system_.model()[member_].nodes.at(end)].id + "." + std::string(name(all_dofs[index(axis)])) +
           "'";
}

/// Of the joints between the member's ends and its nodes that are not rigid: 0 where they are released.
void MemberSteps::add_joints(std::vector<NamedNumber>& numbers) const
{
    const MemberEndConditions* const ends = system_.structure().end_conditions_of(member_);
    if (ends == nullptr || !ends->has_flexible_joint) return;
    for (std::size_t end = 0; end < 2; ++end)
        for (const LocalAxis axis : member_axes_of(system_.structure().kind))
            if (const double k = ends->joints[end][index(axis)]; std::isfinite(k))
                numbers.push_back({"k(" + row_name(end, axis) + ")", k});
}

/// The numbers that k' is made of. That of a tied member has rigid joints: its springs stand in k.
std::vector<NamedMatrix> MemberSteps::entries() const
{
    const MemberEndConditions* const ends = system_.structure().end_conditions_of(member_);
    const AnalysisKind kind = system_.structure().kind;
    StiffMember member{.kind = kind,
                       .properties = &system_.structure().properties_of(member_),
                       .length = trace_.length,
                       .stretches = kind != AnalysisKind::Grillage && !is_tied(),
                       .bends = !is_truss(kind) && !(ends != nullptr && ends->is_bar),
                       .is_on_foundation_alone = trace_.constraint == Constraint::Rigid,
                       .row_name = [&](std::size_t end, LocalAxis axis) { return row_name(end, axis); }};
    if (ends != nullptr && !is_tied()) member.joints = ends->joints;
    const std::vector<NamedNumber> numbers = stiffness_entries(member);
    if (numbers.empty()) return {};
    return {column("entries", numbers)};
}

std::vector<Step> MemberSteps::stiffness() const
{
    std::vector<NamedMatrix> local = entries();
    local.push_back({"k'", trace_.own_dofs, trace_.own_dofs, trace_.local_stiffness});
    NamedMatrix places{"place", trace_.dofs, {""}, Eigen::MatrixXd(trace_.equations.size(), 1)};
    for (std::size_t i = 0; i < trace_.equations.size(); ++i)
        places.values(static_cast<Eigen::Index>(i), 0) = trace_.equations[i];
    return {{.kind = StepKind::Member, .member = member_, .matrices = {data()}},
            {.kind = StepKind::LocalStiffness, .member = member_, .matrices = local},
            {.kind = StepKind::Transformation,
             .member = member_,
             .matrices = {{"T", trace_.own_dofs, trace_.dofs, trace_.transformation}}},
            {.kind = StepKind::Stiffness,
             .member = member_,
             .matrices = {{"k", trace_.dofs, trace_.dofs, trace_.global_stiffness}, places},
             .rows = rows()}};
}

Step MemberSteps::fixed_end_forces(CaseId load_case) const
{
    const MemberTrace::FixedEnd& forces = trace_.fixed_end[load_case.index];
    return {.kind = StepKind::FixedEndForces,
            .member = member_,
            .load_case = load_case,
            .matrices = {{"f0'", trace_.own_dofs, {"f0'"}, forces.local}, {"f0", trace_.dofs, {"f0"}, forces.global}},
            .rows = rows()};
}

Eigen::Index MemberSteps::dofs_per_node() const
{
    return static_cast<Eigen::Index>(model_dofs(system_.structure().kind).size());
}

Eigen::VectorXd MemberSteps::node_displacements(const CaseResult& result) const
{
    Eigen::VectorXd u(static_cast<Eigen::Index>(trace_.dofs.size()));
    for (Eigen::Index end = 0; end < 2; ++end) {
        const NodeId node = system_.model()[member_].nodes[static_cast<std::size_t>(end)];
        u.segment(end * dofs_per_node(), dofs_per_node()) = system_.in_node_axes(node, result.displacement(node));
    }
    if (u.size() == 2 * dofs_per_node()) return u;
    const Eigen::VectorXd unknowns = system_.unknowns_in(result);
    for (Eigen::Index i = 2 * dofs_per_node(); i < u.size(); ++i)
        u[i] = unknowns[trace_.equations[static_cast<std::size_t>(i)] - 1];
    return u;
}

Eigen::MatrixXd MemberSteps::end_force_parts(CaseId load_case, const CaseResult& result) const
{
    Eigen::MatrixXd parts(trace_.local_stiffness.rows(), is_tied() ? 4 : 3);
    parts.col(0) = trace_.local_stiffness * (trace_.transformation * node_displacements(result));
    parts.col(1) = trace_.fixed_end[load_case.index].local;
    if (is_tied()) {
        const auto tying = CurveReader(result).end_forces(member_, CurvePart::Constraint);
        const Eigen::Index n = parts.rows() / 2;
        const AnalysisKind kind = system_.structure().kind;
        for (Eigen::Index end = 0; end < 2; ++end)
            for (Eigen::Index i = 0; i < n; ++i) {
                const auto place = static_cast<std::size_t>(i); // of a truss member x, y and z
                const std::size_t axis = is_truss(kind) ? place : index(member_axes_of(kind)[place]);
                parts(end * n + i, 2) = tying[static_cast<std::size_t>(end)][axis];
            }
    }
    const Eigen::Index last = parts.cols() - 1;
    parts.col(last) = parts.leftCols(last).rowwise().sum();
    return parts;
}

Step MemberSteps::end_displacements(CaseId load_case, const CaseResult& result) const
{
    const Eigen::VectorXd u = node_displacements(result);
    return {
        .kind = StepKind::EndDisplacements,
        .member = member_,
        .load_case = load_case,
        .matrices = {{"u", trace_.dofs, {"u"}, u}, {"u'", trace_.own_dofs, {"u' = T u"}, trace_.transformation * u}},
        .rows = rows()};
}

Step MemberSteps::end_forces(CaseId load_case, const CaseResult& result) const
{
    std::vector<std::string> columns{"k' u'", "f0'", "p'"};
    if (is_tied()) columns = {"k' u'", "f0'", "c'", "p'"};
    return {.kind = StepKind::EndForces,
            .member = member_,
            .load_case = load_case,
            .matrices = {{"p'", trace_.own_dofs, columns, end_force_parts(load_case, result)}}};
}

Eigen::Index MemberSteps::first_row(NodeId node) const
{
    return system_.model()[member_].nodes.front() == node ? 0 : dofs_per_node();
}

Step MemberSteps::node_forces(NodeId node, CaseId load_case, const CaseResult& result) const
{
    std::vector<std::string> forces, columns{"k u", "f0", "p"};
    Eigen::MatrixXd values(2 * dofs_per_node(), 3);
    if (is_tied()) {
        columns = {"k u", "f0", "c", "p"};
        values = trace_.to_nodes * end_force_parts(load_case, result);
    } else {
        const Eigen::VectorXd& loaded = trace_.fixed_end[load_case.index].global;
        const Eigen::VectorXd moved = trace_.global_stiffness * node_displacements(result);
        values << moved, loaded, moved + loaded;
    }
    const std::vector<std::string> rows(trace_.dofs.begin(), trace_.dofs.begin() + values.rows());
    const Eigen::VectorXd part = values.rightCols(1).middleRows(first_row(node), dofs_per_node());
    for (const Dof dof : model_dofs(system_.structure().kind)) forces.emplace_back(force_name(dof));
    return {.kind = StepKind::NodeForces,
            .member = member_,
            .node = node,
            .load_case = load_case,
            .matrices = {{"p", rows, columns, values},
                         {"p at the node", forces, {""}, system_.in_global_axes(node, part)}}};
}

std::vector<Eigen::Index> MemberSteps::rows() const
{
    std::vector<Eigen::Index> rows;
    for (const int equation : trace_.equations)
        if (equation > 0) rows.push_back(equation - 1);
    return rows;
}

} // namespace femoop::derivation
