#include "femoop/io/results/results_csv.h"

#include <string_view>

#include "femoop/io/results/range_columns.h"
#include "femoop/model/quantity/dimension.h"
#include "femoop/result/case_magnitudes.h"
#include "femoop/result/components.h"
#include "femoop/result/envelope.h"
#include "femoop/tabular/separated.h"

namespace femoop {

using tabular::SeparatedText;

namespace {

std::string unit(Dof dof, const Units& units) { return is_rotation(dof) ? "rad" : unit_text(dimension::length, units); }

std::string force_unit(Dof dof, const Units& units)
{
    return unit_text(is_rotation(dof) ? dimension::moment : dimension::force, units);
}

std::string unit(MemberComponent component, const Units& units)
{
    if (is_displacement(component)) return unit_text(dimension::length, units);
    return unit_text(is_moment(component) ? dimension::moment : dimension::force, units);
}

std::string header(std::string_view what, const std::string& unit)
{
    return tabular::Column(std::string(what), unit).label();
}

std::string displacements(const Model& model, const Results& results, const std::vector<CaseId>& cases)
{
    const std::vector<Dof> dofs = dof_list(model.analysis);
    SeparatedText csv;
    csv << "case"
        << "node";
    for (const Dof dof : dofs) csv << header(name(dof), unit(dof, model.units));
    csv.end_row();
    for (const CaseId id : cases) {
        const Magnitudes most = results[id].magnitudes();
        for (std::size_t i = 0; i < model.nodes.size(); ++i) {
            const NodeVector u = results[id].displacement(NodeId(i));
            csv << model.case_name(id) << model.nodes[i].id;
            for (const Dof dof : dofs) csv << without_rounding(u[index(dof)], most.displacement_of(dof));
            csv.end_row();
        }
    }
    return csv.take();
}

std::string reactions(const Model& model, const Results& results, const std::vector<CaseId>& cases)
{
    const std::vector<Dof> dofs = dof_list(model.analysis);
    SeparatedText csv;
    csv << "case"
        << "node";
    for (const Dof dof : dofs) csv << header(force_name(dof), force_unit(dof, model.units));
    csv.end_row();
    for (const CaseId id : cases) {
        const Magnitudes most = results[id].magnitudes();
        for (std::size_t i = 0; i < model.nodes.size(); ++i) {
            if (!results[id].is_supported(NodeId(i))) continue;
            const NodeVector reaction = results[id].reaction(NodeId(i));
            csv << model.case_name(id) << model.nodes[i].id;
            for (const Dof dof : dofs) csv << without_rounding(reaction[index(dof)], most.force_of(dof));
            csv.end_row();
        }
    }
    return csv.take();
}

std::string stations(const Model& model, const Results& results, const std::vector<CaseId>& cases, std::size_t n)
{
    const std::vector<MemberComponent> components = member_components(model.analysis);
    SeparatedText csv;
    csv << "case"
        << "member" << header("x", unit_text(dimension::length, model.units));
    for (const MemberComponent component : components)
        csv << header(name(component, model.analysis), unit(component, model.units));
    csv.end_row();
    for (const CaseId id : cases) {
        const Magnitudes most = results[id].magnitudes();
        for (std::size_t i = 0; i < model.members.size(); ++i)
            for (const Station& station : results[id].curve(MemberId(i)).stations(n)) {
                csv << model.case_name(id) << model.members[i].id << station.x;
                for (const MemberComponent component : components)
                    csv << without_rounding(value(station, component), most.of(component));
                csv.end_row();
            }
    }
    return csv.take();
}

std::string extremes(const Model& model, const Results& results, const std::vector<CaseId>& cases)
{
    const std::string x = unit_text(dimension::length, model.units);
    SeparatedText csv;
    csv << "case"
        << "member"
        << "component"
        << "unit"
        << "max" << header("x of max", x) << "min" << header("x of min", x);
    csv.end_row();
    for (const CaseId id : cases) {
        const Magnitudes most = results[id].magnitudes();
        for (std::size_t i = 0; i < model.members.size(); ++i) {
            const Curve curve = results[id].curve(MemberId(i));
            for (const MemberComponent component : member_components(model.analysis)) {
                const Extremes found = curve.extremes(component);
                const double size = most.of(component);
                csv << model.case_name(id) << model.members[i].id << name(component, model.analysis)
                    << unit(component, model.units) << without_rounding(found.max.value, size) << found.max.x
                    << without_rounding(found.min.value, size) << found.min.x;
                csv.end_row();
            }
        }
    }
    return csv.take();
}

std::string equilibrium(const Model& model, const Results& results, const std::vector<CaseId>& cases)
{
    const std::vector<Dof> dofs = equilibrium_dofs(model.analysis);
    SeparatedText csv;
    csv << "case"
        << "sum of";
    for (const Dof dof : dofs) csv << header(force_name(dof), force_unit(dof, model.units));
    csv << "residual";
    csv.end_row();
    for (const CaseId id : cases) {
        const CaseResult result = results[id];
        const Equilibrium& balance = result.equilibrium();
        const Magnitudes most = of_sums(result.magnitudes(), model);
        for (const bool is_load : {true, false}) {
            const NodeVector& sums = is_load ? balance.sum_loads : balance.sum_reactions;
            csv << model.case_name(id) << (is_load ? "loads" : "reactions");
            for (const Dof dof : dofs) csv << without_rounding(sums[index(dof)], most.force_of(dof));
            csv << balance.residual;
            csv.end_row();
        }
    }
    return csv.take();
}

/// Rounding of a value is told by the other numbers of its case: `size` gives them for the magnitudes of a case.
template <class Size>
void add_range(SeparatedText& csv, const Model& model, CaseMagnitudes& most, const GoverningRange& range, Size&& size)
{
    for (const Governing& end : {range.max, range.min})
        csv << without_rounding(end.value, size(most[end.load_case])) << model.case_name(end.load_case);
    csv.end_row();
}

/// Displacements of all nodes and reactions of those that are supported; `begin` writes what stands before the range.
template <class Begin>
void add_nodes(SeparatedText& csv, const Model& model, CaseMagnitudes& most, const Envelope& envelope, Begin&& begin)
{
    const Results& results = most.results();
    for (std::size_t i = 0; i < model.nodes.size(); ++i) {
        const std::string& node = model.nodes[i].id;
        for (const Dof dof : dof_list(model.analysis)) {
            begin(node, name(dof), unit(dof, model.units));
            add_range(csv, model, most, envelope.displacement(NodeId(i), dof),
                      [dof](const Magnitudes& of_case) { return of_case.displacement_of(dof); });
        }
        if (!results[envelope.cases().front()].is_supported(NodeId(i))) continue;
        for (const Dof dof : dof_list(model.analysis)) {
            begin(node, force_name(dof), force_unit(dof, model.units));
            add_range(csv, model, most, envelope.reaction(NodeId(i), dof),
                      [dof](const Magnitudes& of_case) { return of_case.force_of(dof); });
        }
    }
}

std::string node_envelope(const Model& model, CaseMagnitudes& most, const Envelope& envelope)
{
    SeparatedText csv;
    csv << "node"
        << "result"
        << "unit";
    add_range_columns(csv);
    csv.end_row();
    add_nodes(csv, model, most, envelope, [&](const std::string& node, std::string_view what, const std::string& in) {
        csv << node << what << in;
    });
    return csv.take();
}

std::string member_envelope(const Model& model, CaseMagnitudes& most, const Envelope& envelope)
{
    const std::string x = unit_text(dimension::length, model.units);
    SeparatedText csv;
    csv << "member"
        << "component"
        << "unit"
        << "max" << header("x of max", x) << "case of max"
        << "min" << header("x of min", x) << "case of min";
    csv.end_row();
    for (std::size_t i = 0; i < model.members.size(); ++i)
        for (const MemberComponent component : member_components(model.analysis)) {
            const GoverningExtremes found = envelope.extremes(MemberId(i), component);
            csv << model.members[i].id << name(component, model.analysis) << unit(component, model.units);
            for (const GoverningExtreme& end : {found.max, found.min})
                csv << without_rounding(end.value, most[end.load_case].of(component)) << end.x
                    << model.case_name(end.load_case);
            csv.end_row();
        }
    return csv.take();
}

} // namespace

std::vector<CsvFile> results_csv(const Model& model, const Results& results, const std::vector<CaseId>& cases,
                                 std::size_t n_stations)
{
    return {{"displacements.csv", displacements(model, results, cases)},
            {"reactions.csv", reactions(model, results, cases)},
            {"members.csv", stations(model, results, cases, n_stations)},
            {"extremes.csv", extremes(model, results, cases)},
            {"equilibrium.csv", equilibrium(model, results, cases)}};
}

std::vector<CsvFile> envelope_csv(const Model& model, const Results& results, const std::vector<CaseId>& cases)
{
    const Envelope envelope(results, cases);
    CaseMagnitudes most(results);
    return {{"envelope_nodes.csv", node_envelope(model, most, envelope)},
            {"envelope_members.csv", member_envelope(model, most, envelope)}};
}

std::string long_envelope_csv(const Model& model, const Results& results, const std::vector<CaseId>& cases,
                              std::size_t n_stations)
{
    const Envelope envelope(results, cases);
    CaseMagnitudes most(results);
    SeparatedText csv;
    csv << "part"
        << "id" << header("x", unit_text(dimension::length, model.units)) << "component"
        << "unit";
    add_range_columns(csv);
    csv.end_row();
    add_nodes(csv, model, most, envelope, [&](const std::string& node, std::string_view what, const std::string& in) {
        csv << "node" << node << "" << what << in;
    });
    const std::vector<MemberComponent> components = member_components(model.analysis);
    for (std::size_t i = 0; i < model.members.size(); ++i)
        for (const EnvelopeStation& station : envelope.stations(MemberId(i), components, n_stations))
            for (std::size_t c = 0; c < components.size(); ++c) {
                csv << "member" << model.members[i].id << station.x << name(components[c], model.analysis)
                    << unit(components[c], model.units);
                add_range(csv, model, most, station.ranges[c],
                          [&](const Magnitudes& of_case) { return of_case.of(components[c]); });
            }
    return csv.take();
}

std::string long_csv(const Model& model, const Results& results, const std::vector<CaseId>& cases,
                     std::size_t n_stations)
{
    SeparatedText csv;
    csv << "case"
        << "part"
        << "id" << header("x", unit_text(dimension::length, model.units)) << "component"
        << "value"
        << "unit";
    csv.end_row();
    for (const CaseId id : cases) {
        const CaseResult result = results[id];
        const Magnitudes most = result.magnitudes();
        const auto add_node = [&](std::size_t i, std::string_view what, double number, const std::string& in) {
            csv << result.name() << "node" << model.nodes[i].id << "" << what << number << in;
            csv.end_row();
        };
        for (std::size_t i = 0; i < model.nodes.size(); ++i) {
            const NodeVector u = result.displacement(NodeId(i)), r = result.reaction(NodeId(i));
            for (const Dof dof : dof_list(model.analysis))
                add_node(i, name(dof), without_rounding(u[index(dof)], most.displacement_of(dof)),
                         unit(dof, model.units));
            if (!result.is_supported(NodeId(i))) continue;
            for (const Dof dof : dof_list(model.analysis))
                add_node(i, force_name(dof), without_rounding(r[index(dof)], most.force_of(dof)),
                         force_unit(dof, model.units));
        }
        for (std::size_t i = 0; i < model.members.size(); ++i)
            for (const Station& station : result.curve(MemberId(i)).stations(n_stations))
                for (const MemberComponent component : member_components(model.analysis)) {
                    csv << result.name() << "member" << model.members[i].id << station.x
                        << name(component, model.analysis)
                        << without_rounding(value(station, component), most.of(component))
                        << unit(component, model.units);
                    csv.end_row();
                }
    }
    return csv.take();
}

} // namespace femoop
