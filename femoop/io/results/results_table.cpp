#include "femoop/io/results/results_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string_view>

#include "femoop/io/results/matrix_table.h"
#include "femoop/model/quantity/dimension.h"
#include "femoop/model/quantity/number_text.h"
#include "femoop/result/case_magnitudes.h"
#include "femoop/result/components.h"
#include "femoop/result/envelope.h"
#include "femoop/result/structure_words.h"
#include "femoop/tabular/plain_text.h"

namespace femoop {

namespace {

constexpr std::size_t indent = 2;

tabular::Column in_unit(std::string_view what, const PrintedUnit& unit) { return {std::string(what), unit.name}; }

tabular::Column displacement_header(Dof dof, const ResultUnits& units)
{
    return in_unit(name(dof), units.of_displacement(dof));
}

tabular::Column force_header(Dof dof, const ResultUnits& units)
{
    return in_unit(force_name(dof), units.of_force(dof));
}

tabular::Column component_header(MemberComponent component, AnalysisKind analysis, const ResultUnits& units)
{
    return in_unit(name(component, analysis), units.of(component));
}

/// In its unit, 0 where it is nothing but rounding beside numbers of this size.
tabular::Cell cell(double value, double size, const PrintedUnit& unit)
{
    return without_rounding(value, size) * unit.factor;
}

std::string section(const std::string& title, const tabular::Table& table, const Translator& tr)
{
    return table.is_empty() ? std::string()
                            : "\n" + title + "\n" + tabular::plain_text(table, {indent, decimal_mark(tr)});
}

std::string counts(const Model& model, const Translator& tr)
{
    std::string text = size_text(model, tr) + ", " +
                       counted(model.load_cases.size(), tr("{0} load case"), tr("{0} load cases"));
    if (!model.combinations.empty())
        text += ", " + counted(model.combinations.size(), tr("{0} combination"), tr("{0} combinations"));
    return text;
}

std::string indeterminacy_text(const Indeterminacy& degree, const Translator& tr)
{
    if (degree.has_foundation)
        return tr("Degree of static indeterminacy: infinite, since members stand on a continuous foundation");
    const std::vector<std::string> numbers{std::to_string(degree.total()), std::to_string(degree.external),
                                           std::to_string(degree.internal)};
    std::string text = fill(degree.internal >= 0
                                ? tr("Degree of static indeterminacy: {0} (external {1}, internal {2})")
                                : tr("Degree of static indeterminacy: {0}"),
                            numbers);
    if (degree.total() == 0) text += ": " + tr("statically determinate");
    return text;
}

/// "Combination ULS = 1.35 G + 1.5 Q"
std::string case_title(const Model& model, CaseId id, const Translator& tr)
{
    if (id.index < model.load_cases.size()) return fill(tr("Load case {0}"), {model.case_name(id)});
    const Combination& combination = model.combinations[id.index - model.load_cases.size()];
    std::string sum;
    for (const Combination::Term& term : combination.terms) {
        const bool is_minus = term.factor < 0.0;
        if (!sum.empty() || is_minus) sum += sum.empty() ? "-" : is_minus ? " - " : " + ";
        sum += localized(number_text(is_minus ? -term.factor : term.factor), tr) + " " + model.case_name(term.of);
    }
    return fill(tr("Combination {0} = {1}"), {combination.id, sum.empty() ? "0" : sum});
}

/// The section forces that are worth a column: in a truss without span loads N alone.
std::vector<MemberComponent> shown_forces(const Model& model, const std::vector<CaseResult>& results)
{
    std::vector<MemberComponent> all = section_force_components(model.analysis);
    if (!is_truss(model.analysis)) return all;
    for (const CaseResult& result : results)
        for (std::size_t i = 0; i < model.members.size(); ++i)
            for (const MemberComponent component : all) {
                const Extremes extremes = result.curve(MemberId(i)).extremes(component);
                const bool is_bent = component != MemberComponent::N;
                if (is_bent && (extremes.max.value != 0.0 || extremes.min.value != 0.0)) return all;
            }
    return {MemberComponent::N};
}

tabular::Table displacement_table(const Model& model, const CaseResult& result, const Magnitudes& most,
                                  const ResultUnits& units, const Translator& tr)
{
    const std::vector<Dof> dofs = dof_list(model.analysis);
    std::vector<tabular::Column> headers{tr("node")};
    for (const Dof dof : dofs) headers.push_back(displacement_header(dof, units));

    tabular::Table table(headers);
    for (std::size_t i = 0; i < model.nodes.size(); ++i) {
        const NodeVector u = result.displacement(NodeId(i));
        std::vector<tabular::Cell> row{model.nodes[i].id};
        for (const Dof dof : dofs)
            row.push_back(cell(u[index(dof)], most.displacement_of(dof), units.of_displacement(dof)));
        table.add_row(std::move(row));
    }
    return table;
}

tabular::Table reaction_table(const Model& model, const CaseResult& result, const Magnitudes& most,
                              const ResultUnits& units, const Translator& tr)
{
    const std::vector<Dof> dofs = dof_list(model.analysis);
    std::vector<tabular::Column> headers{tr("node")};
    for (const Dof dof : dofs) headers.push_back(force_header(dof, units));

    tabular::Table table(headers);
    for (std::size_t i = 0; i < model.nodes.size(); ++i) {
        if (!result.is_supported(NodeId(i))) continue;
        const NodeVector reaction = result.reaction(NodeId(i));
        std::vector<tabular::Cell> row{model.nodes[i].id};
        for (const Dof dof : dofs) row.push_back(cell(reaction[index(dof)], most.force_of(dof), units.of_force(dof)));
        table.add_row(std::move(row));
    }
    return table;
}

tabular::Table end_force_table(const Model& model, const CaseResult& result, const Magnitudes& most,
                               const ResultUnits& units, const Translator& tr)
{
    const std::vector<MemberComponent> components = shown_forces(model, {result});
    std::vector<tabular::Column> headers{tr("member"), tr("at node")};
    for (const MemberComponent component : components)
        headers.push_back(component_header(component, model.analysis, units));

    tabular::Table table(headers);
    for (std::size_t i = 0; i < model.members.size(); ++i) {
        const Curve curve = result.curve(MemberId(i));
        for (std::size_t end = 0; end < 2; ++end) {
            std::vector<tabular::Cell> row{end == 0 ? model.members[i].id : std::string(),
                                           model[model.members[i].nodes[end]].id};
            const double x = end == 0 ? 0.0 : curve.length();
            const Side side = end == 0 ? Side::After : Side::Before;
            for (const MemberComponent component : components)
                row.push_back(cell(curve.value(component, x, side), most.of(component), units.of(component)));
            table.add_row(std::move(row));
        }
    }
    return table;
}

tabular::Table extremes_table(const Model& model, const CaseResult& result,
                              const std::vector<MemberComponent>& components, const Magnitudes& most,
                              const ResultUnits& units, const Translator& tr)
{
    const tabular::Column at = in_unit(tr("at x"), units.length);
    tabular::Table table({tr("member"), "", tr("largest"), at, tr("smallest"), at});
    for (std::size_t i = 0; i < model.members.size(); ++i) {
        const Curve curve = result.curve(MemberId(i));
        for (const MemberComponent component : components) {
            const Extremes extremes = curve.extremes(component);
            const double size = most.of(component);
            table.add_row({component == components.front() ? model.members[i].id : std::string(),
                           component_header(component, model.analysis, units).label(),
                           cell(extremes.max.value, size, units.of(component)), extremes.max.x * units.length.factor,
                           cell(extremes.min.value, size, units.of(component)), extremes.min.x * units.length.factor},
                          static_cast<std::size_t>(component));
        }
    }
    return table;
}

std::string sign_legend(AnalysisKind kind, const Translator& tr)
{
    if (is_truss(kind)) return tr("N is positive in tension");
    if (kind == AnalysisKind::Grillage) return tr("M is positive when it stretches the lower fibre (-y'), V = dM/dx");
    if (is_3d(kind))
        return tr(
            "N is positive in tension, Mz when it stretches the -y' fibre, My the -z' fibre; Vy = dMz/dx, Vz = dMy/dx");
    return tr("N is positive in tension, M when it stretches the -y' fibre; V = dM/dx");
}

std::string equilibrium_text(const Model& model, const Equilibrium& equilibrium, const Magnitudes& most,
                             const ResultUnits& units, const Translator& tr)
{
    const std::vector<Dof> dofs = equilibrium_dofs(model.analysis);
    std::vector<tabular::Column> headers{""};
    for (const Dof dof : dofs) headers.push_back(force_header(dof, units));

    tabular::Table table(headers);
    std::vector<tabular::Cell> loads{tr("loads")}, reactions{tr("reactions")}, sums{tr("sum")};
    const Magnitudes largest = of_sums(most, model);
    for (const Dof dof : dofs) {
        const double size = largest.force_of(dof);
        const double load = equilibrium.sum_loads[index(dof)], reaction = equilibrium.sum_reactions[index(dof)];
        loads.push_back(cell(load, size, units.of_force(dof)));
        reactions.push_back(cell(reaction, size, units.of_force(dof)));
        sums.push_back(cell(load + reaction, size, units.of_force(dof)));
    }
    table.add_row(std::move(loads));
    table.add_row(std::move(reactions));
    table.add_row(std::move(sums));
    std::array<char, 32> residual{};
    static_cast<void>(std::snprintf(residual.data(), residual.size(), "%.1e", equilibrium.residual));
    return section(tr("Equilibrium (moments about the origin)"), table, tr) + "  " +
           fill(tr("largest force out of balance at a node: {0} of the largest load"),
                {localized(residual.data(), tr)}) +
           "\n";
}

/// Rows of "largest, in case, smallest, in case" under one heading.
class GoverningTable {
public:
    GoverningTable(const Model& model, std::string_view what, const Translator& tr)
        : model_(model), table_({std::string(what), "", tr("largest"), tr("case"), tr("smallest"), tr("case")})
    {}
    struct Row {
        std::string part;
        Dof dof;
        std::string_view name;
        const PrintedUnit& unit;
        double size; ///< of the numbers that these may be round-off of
    };
    void add(const Row& row, const GoverningRange& range)
    {
        table_.add_row({row.part, in_unit(row.name, row.unit).label(), cell(range.max.value, row.size, row.unit),
                        model_.case_name(range.max.load_case), cell(range.min.value, row.size, row.unit),
                        model_.case_name(range.min.load_case)},
                       index(row.dof));
    }
    const tabular::Table& table() const { return table_; }

private:
    const Model& model_;
    tabular::Table table_;
};

Magnitudes largest_of(const Results& results, const std::vector<CaseId>& cases)
{
    Magnitudes most;
    for (const CaseId id : cases) {
        const Magnitudes next = results[id].magnitudes();
        most = {.force = std::max(most.force, next.force),
                .moment = std::max(most.moment, next.moment),
                .displacement = std::max(most.displacement, next.displacement),
                .rotation = std::max(most.rotation, next.rotation)};
    }
    return most;
}

tabular::Table member_envelope(const Model& model, const Envelope& envelope,
                               const std::vector<MemberComponent>& components, const Magnitudes& most,
                               const ResultUnits& units, const Translator& tr)
{
    const tabular::Column at = in_unit(tr("at x"), units.length);
    tabular::Table table({tr("member"), "", tr("largest"), at, tr("case"), tr("smallest"), at, tr("case")});
    for (std::size_t i = 0; i < model.members.size(); ++i)
        for (const MemberComponent component : components) {
            const GoverningExtremes extremes = envelope.extremes(MemberId(i), component);
            const double size = most.of(component);
            table.add_row({component == components.front() ? model.members[i].id : std::string(),
                           component_header(component, model.analysis, units).label(),
                           cell(extremes.max.value, size, units.of(component)), extremes.max.x * units.length.factor,
                           model.case_name(extremes.max.load_case), cell(extremes.min.value, size, units.of(component)),
                           extremes.min.x * units.length.factor, model.case_name(extremes.min.load_case)},
                          static_cast<std::size_t>(component));
        }
    return table;
}

/// The rows of the member's axes beside those of the nodes.
tabular::Table fixed_end_table(const MemberTrace& trace, const MemberTrace::FixedEnd& forces, const Translator& tr)
{
    tabular::Table table({"", tr("own axes"), "", tr("axes of the nodes")});
    for (std::size_t i = 0; i < trace.dofs.size(); ++i) {
        const auto row = static_cast<Eigen::Index>(i);
        const bool has_own = i < trace.own_dofs.size(); // the ends of a tied member behind joints come after them
        table.add_row({has_own ? trace.own_dofs[i] : "", has_own ? tabular::Cell(forces.local[row]) : tabular::Cell(),
                       trace.dofs[i], forces.global[row]});
    }
    table.silence_round_off({1, 3});
    return table;
}

std::string constraint_text(Constraint constraint, const Translator& tr)
{
    return constraint == Constraint::Rigid
               ? tr("The member is rigid: a constraint ties its ends in place of its stiffness; its loads go to its ends "
                    "as that would send them.")
               : tr("The member is inextensible: a constraint ties its ends along its axis in place of its stiffness; "
                    "loads along it go to its ends as that would send them.");
}

std::string equations_text(const MemberTrace& trace, const Translator& tr)
{
    tabular::Table table({tr("row"), tr("place in the system matrix")});
    for (std::size_t i = 0; i < trace.dofs.size(); ++i)
        table.add_row({trace.dofs[i],
                       trace.equations[i] == 0 ? tr("none: held by a support") : std::to_string(trace.equations[i])});
    return section(tr("Where each row is added"), table, tr);
}

} // namespace

std::string heading_text(const Model& model, const Results& results, const Translator& tr)
{
    std::string text = model.title.empty() ? std::string() : printable(model.title) + "\n";
    text += fill(tr("Analysis: {0}, linear static; lengths in {1}, forces in {2}, rotations in rad"),
                 {kind_text(model.analysis, tr), std::string(name(model.units.length)),
                  std::string(name(model.units.force))}) +
            "\n";
    text += counts(model, tr) + "\n";
    if (!model.members.empty()) text += indeterminacy_text(results.indeterminacy(), tr) + "\n";
    for (const Fault& warning : results.warnings()) text += tr("warning") + ": " + message(warning, tr) + "\n";
    return text;
}

std::string case_text(const Model& model, const Results& results, CaseId id, const ResultUnits& units,
                      const Translator& tr)
{
    const CaseResult result = results[id];
    const Magnitudes most = result.magnitudes();
    const std::string title = case_title(model, id, tr);
    std::string text = "\n" + title + "\n" + std::string(tabular::shown_width(title), '=') + "\n";
    text += section(tr("Displacements of the nodes"), displacement_table(model, result, most, units, tr), tr);
    text += section(tr("Reactions of the supports on the structure"), reaction_table(model, result, most, units, tr),
                    tr);
    text += section(tr("Section forces at the ends of the members") + "\n  (" + sign_legend(model.analysis, tr) + ")",
                    end_force_table(model, result, most, units, tr), tr);
    text += section(tr("Extreme section forces along the members"),
                    extremes_table(model, result, shown_forces(model, {result}), most, units, tr), tr);
    text += section(tr("Extreme displacements along the members, in their own axes"),
                    extremes_table(model, result, local_displacement_components(model.analysis), most, units, tr), tr);
    return text + equilibrium_text(model, result.equilibrium(), most, units, tr);
}

std::string case_text(const Model& model, const Results& results, CaseId id, const Translator& tr)
{
    return case_text(model, results, id, result_units(model.units), tr);
}

std::string envelope_text(const Model& model, const Results& results, const std::vector<CaseId>& cases,
                          const Translator& tr)
{
    return envelope_text(model, results, cases, result_units(model.units), tr);
}

std::string envelope_text(const Model& model, const Results& results, const std::vector<CaseId>& cases,
                          const ResultUnits& units, const Translator& tr)
{
    const Envelope envelope(results, cases);
    const Magnitudes most = largest_of(results, cases);
    GoverningTable displacements(model, tr("node"), tr), reactions(model, tr("node"), tr);
    for (std::size_t i = 0; i < model.nodes.size(); ++i) {
        std::string id = model.nodes[i].id;
        for (const Dof dof : dof_list(model.analysis)) {
            displacements.add({id, dof, name(dof), units.of_displacement(dof), most.displacement_of(dof)},
                              envelope.displacement(NodeId(i), dof));
            if (results[cases.front()].is_supported(NodeId(i)))
                reactions.add({id, dof, force_name(dof), units.of_force(dof), most.force_of(dof)},
                              envelope.reaction(NodeId(i), dof));
            id.clear();
        }
    }
    std::vector<CaseResult> shown;
    for (const CaseId id : cases) shown.push_back(results[id]);
    std::string names;
    for (const CaseId id : cases) names += (names.empty() ? "" : ", ") + model.case_name(id);
    const std::string title = fill(tr("Envelope of {0}"), {names});
    return "\n" + title + "\n" + std::string(tabular::shown_width(title), '=') + "\n" +
           section(tr("Displacements of the nodes"), displacements.table(), tr) +
           section(tr("Reactions of the supports on the structure"), reactions.table(), tr) +
           section(tr("Extreme section forces along the members"),
                   member_envelope(model, envelope, shown_forces(model, shown), most, units, tr), tr) +
           section(tr("Extreme displacements along the members, in their own axes"),
                   member_envelope(model, envelope, local_displacement_components(model.analysis), most, units, tr),
                   tr);
}

std::string trace_text(const MemberTrace& trace, const Units& units, const Translator& tr)
{
    const std::vector<std::string>& local = trace.own_dofs;
    std::string text = fill(tr("Member {0}, length {1}: how it enters the system K u = f"),
                            {trace.member, localized(quantity_text(trace.length, dimension::length, units), tr)}) +
                       "\n";
    text += tr("The axes of a node are the global ones, and those of its support where that is turned.") + "\n";
    if (trace.constraint != Constraint::None) text += constraint_text(trace.constraint, tr) + "\n";
    text += section(tr("Stiffness k' in the member's own axes"), matrix_table(local, local, trace.local_stiffness), tr);
    text += section(tr("Transformation T, u' = T u"), matrix_table(local, trace.dofs, trace.transformation), tr);
    text += section(tr("Stiffness in the axes of the nodes, k = T^T k' T"),
                    matrix_table(trace.dofs, trace.dofs, trace.global_stiffness), tr);
    for (const MemberTrace::FixedEnd& forces : trace.fixed_end) {
        text += section(fill(tr("Fixed-end forces on the member, load case {0}"), {forces.load_case}),
                        fixed_end_table(trace, forces, tr), tr);
    }
    return text + equations_text(trace, tr);
}

} // namespace femoop
