#include "femoop/methods/derivation/member_steps.h"

#include <cmath>
#include <string_view>
#include <utility>

#include "femoop/element/analysis_model.h"
#include "femoop/result/curve_reader.h"

namespace femoop::derivation {

namespace {

struct NamedNumber {
    std::string name;
    double value;
};

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

/// The numbers of a beam's stiffness from EI and L, and from GAs where it shears too.
void add_bending(std::vector<NamedNumber>& numbers, const Beam& beam, double L, const std::string& EI)
{
    if (!is_stiff(beam.EI)) return;
    const bool shears = beam.shear_flexibility > 0.0;
    const double phi = 12.0 * beam.EI * beam.shear_flexibility / (L * L);
    const double stiffness = beam.EI / (1.0 + phi);
    if (shears) numbers.push_back({"phi = 12 " + EI + "/(GAs L^2)", phi});
    const std::string in_shear = shears ? " (1 + phi)" : "";
    const auto over = [&](std::string_view power) {
        const std::string L_text = "L" + std::string(power);
        return shears ? "/(" + L_text + in_shear + ")" : "/" + L_text;
    };
    numbers.push_back({"12 " + EI + over("^3"), 12.0 * stiffness / (L * L * L)});
    numbers.push_back({"6 " + EI + over("^2"), 6.0 * stiffness / (L * L)});
    numbers.push_back({(shears ? "(4 + phi) " : "4 ") + EI + over(""), (4.0 + phi) * stiffness / L});
    numbers.push_back({(shears ? "(2 - phi) " : "2 ") + EI + over(""), (2.0 - phi) * stiffness / L});
}

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
                                     {"EI(L)", beam.EI * (1.0 + L * (a1 + L * (a2 + L * a3)))}};
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
    if (!properties.xy.taper.is_prismatic()) return column("data", tapered_numbers(properties, trace_.length));
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
    return column("data", numbers);
}

/// The numbers that k' is made of; of joints, a foundation and a taper it is no such sum.
std::vector<NamedMatrix> MemberSteps::entries() const
{
    const MemberEndConditions* const ends = system_.structure().end_conditions_of(member_);
    const MemberProperties& properties = system_.structure().properties_of(member_);
    if ((ends != nullptr && ends->has_flexible_joint) || properties.xy.foundation > 0.0) return {};
    if (!properties.xy.taper.is_prismatic() || trace_.constraint == Constraint::Rigid) return {};
    const AnalysisKind kind = system_.structure().kind;
    const bool is_bar = ends != nullptr && ends->is_bar;
    const double L = trace_.length;
    std::vector<NamedNumber> numbers;
    if (kind != AnalysisKind::Grillage && !is_tied()) numbers.push_back({"EA/L", properties.axial.EA / L});
    if (!is_truss(kind) && !is_bar) {
        const bool twists = kind == AnalysisKind::Frame3d || kind == AnalysisKind::Grillage;
        if (twists && is_stiff(properties.torsion.EA)) numbers.push_back({"GJ/L", properties.torsion.EA / L});
        add_bending(numbers, properties.xy, L, is_3d(kind) ? "EIz" : "EI");
        if (is_3d(kind)) add_bending(numbers, properties.xz, L, "EIy");
    }
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
