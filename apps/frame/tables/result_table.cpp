#include "apps/frame/tables/result_table.h"

#include <utility>

#include "apps/drawing/measures.h"
#include "apps/drawing/results/case_numbers.h"
#include "apps/drawing/results/diagram.h"
#include "apps/drawing/results/reactions.h"
#include "apps/frame/tables/column.h"
#include "femoop/result/components.h"
#include "femoop/result/envelope.h"
#include "ui/text/catalogue.h"
#include "ui/text/number_format.h"

namespace frame {

using namespace femoop;
using ui::Measure;
using ui::translatable;

namespace {

/// Writes the rows of one table.
class ResultRows {
public:
    ResultRows(const TabledResults& shown, const Manner& manner)
        : shown_(shown), manner_(manner), kind_(shown.model.analysis), numbers_(shown.results, manner.units)
    {}

    Table displacements()
    {
        const std::vector<Dof> list = dof_list(kind_);
        begin(translatable("Node"));
        for (const Dof dof : list) add_heading(std::string(name(dof)), displacement_measures.of(dof));
        for (std::size_t i = 0; i < shown_.model.nodes.size(); ++i) {
            begin_row(NodeId(i), shown_.model.nodes[i].id);
            const NodeVector u = result().displacement(NodeId(i));
            for (const Dof dof : list)
                add(u[index(dof)], displacement_measures.of(dof), shown_.load_case,
                    of_node(ExpectedQuantity::Displacement, NodeId(i), dof));
        }
        return std::move(table_);
    }

    Table reactions()
    {
        const std::vector<Dof> list = dof_list(kind_);
        begin(translatable("Node"));
        for (const Dof dof : list) add_heading(std::string(force_name(dof)), force_measures.of(dof));
        const bool has_slanting = drawing::has_slanting_support(shown_.model);
        if (has_slanting) add_heading("R", Measure::Force);
        for (std::size_t i = 0; i < shown_.model.nodes.size(); ++i) {
            if (!result().is_supported(NodeId(i))) continue;
            begin_row(NodeId(i), shown_.model.nodes[i].id);
            const NodeVector r = result().reaction(NodeId(i));
            for (const Dof dof : list)
                add(r[index(dof)], force_measures.of(dof), shown_.load_case,
                    of_node(ExpectedQuantity::Reaction, NodeId(i), dof));
            if (has_slanting) add_resultant(NodeId(i), r);
        }
        return std::move(table_);
    }

    Table member_ends()
    {
        begin(translatable("Member"));
        for (const std::string_view sentence : {translatable("{force}, start"), translatable("{force}, end")})
            for (const MemberComponent component : components())
                add_heading(manner_.tr(sentence, {{"force", symbol(component)}}), measure_of(component));
        each_member([&](MemberId id, const Curve& curve) {
            for (const MemberComponent component : components())
                add(curve.value(component, 0.0), measure_of(component), shown_.load_case,
                    drawing::number_at_section({id, 0.0}, component, curve.length()));
            for (const MemberComponent component : components())
                add(curve.value(component, curve.length(), Side::Before), measure_of(component), shown_.load_case,
                    drawing::number_at_section({id, curve.length()}, component, curve.length()));
        });
        return std::move(table_);
    }

    Table extremes()
    {
        begin(translatable("Member"));
        for (const MemberComponent component : components()) {
            for (const std::string_view which : {translatable("max"), translatable("min")}) {
                add_heading(symbol(component) + ' ' + manner_.tr(which), measure_of(component));
                add_heading("x", Measure::Length);
            }
        }
        each_member([&](MemberId id, const Curve& curve) {
            for (const MemberComponent component : components()) {
                const Extremes found = curve.extremes(component);
                for (const Extreme& extreme : {found.max, found.min}) {
                    add(extreme.value, measure_of(component), shown_.load_case,
                        drawing::number_on_diagram(id, curve, component, extreme.x, extreme.value));
                    add(extreme.x, Measure::Length, shown_.load_case);
                }
            }
        });
        return std::move(table_);
    }

    Table envelope()
    {
        begin(translatable("Member"));
        for (const MemberComponent component : components()) {
            for (const std::string_view which : {translatable("max"), translatable("min")}) {
                add_heading(symbol(component) + ' ' + manner_.tr(which), measure_of(component));
                add_heading("x", Measure::Length);
                add_case_heading();
            }
        }
        const Envelope all = chosen();
        for (std::size_t i = 0; i < shown_.model.members.size(); ++i) {
            begin_row(MemberId(i), shown_.model.members[i].id);
            for (const MemberComponent component : components()) {
                const GoverningExtremes found = all.extremes(MemberId(i), component);
                for (const GoverningExtreme& extreme : {found.max, found.min}) add(extreme, MemberId(i), component);
            }
        }
        return std::move(table_);
    }

    Table reaction_envelope()
    {
        const std::vector<Dof> list = dof_list(kind_);
        begin(translatable("Node"));
        for (const Dof dof : list) {
            for (const std::string_view which : {translatable("max"), translatable("min")}) {
                add_heading(std::string(force_name(dof)) + ' ' + manner_.tr(which), force_measures.of(dof));
                add_case_heading();
            }
        }
        const Envelope all = chosen();
        for (std::size_t i = 0; i < shown_.model.nodes.size(); ++i) {
            if (!result().is_supported(NodeId(i))) continue;
            begin_row(NodeId(i), shown_.model.nodes[i].id);
            for (const Dof dof : list) {
                const GoverningRange range = all.reaction(NodeId(i), dof);
                for (const Governing& bound : {range.max, range.min}) {
                    add(bound.value, force_measures.of(dof), bound.load_case,
                        of_node(ExpectedQuantity::Reaction, NodeId(i), dof));
                    table_.rows.back().cells.back().of_case = bound.load_case;
                    add_name(bound.load_case);
                }
            }
        }
        return std::move(table_);
    }

private:
    Envelope chosen() const
    {
        return shown_.envelope_of.empty() ? Envelope(shown_.results) : Envelope(shown_.results, shown_.envelope_of);
    }
    CaseResult result() const { return shown_.results[shown_.load_case]; }
    std::vector<MemberComponent> components() const { return section_force_components(kind_); }
    std::string symbol(MemberComponent component) const { return std::string(name(component, kind_)); }

    void begin(std::string_view heading) { table_.headings.push_back({manner_.tr(heading)}); }
    void add_heading(const std::string& name, Measure measure)
    {
        table_.headings.push_back(number_heading(manner_.units.label(name, measure)));
    }

    void begin_row(const Part& part, const std::string& name) { table_.rows.push_back({part, {Cell{name}}}); }

    template <class Visit> void each_member(Visit&& visit)
    {
        for (std::size_t i = 0; i < shown_.model.members.size(); ++i) {
            begin_row(MemberId(i), shown_.model.members[i].id);
            visit(MemberId(i), result().curve(MemberId(i)));
        }
    }

    static MovingEffect of_node(ExpectedQuantity quantity, NodeId node, Dof dof)
    {
        return {.quantity = quantity, .node = node, .dof = dof};
    }

    void add(double value, Measure measure, CaseId of, std::optional<MovingEffect> number = std::nullopt)
    {
        std::string shown = numbers_[of].number(value, measure);
        const double tidy = shown == "0" ? 0.0 : value;
        Cell cell = cell_of(Quantity(tidy), measure, manner_);
        cell.value.shown = std::move(shown);
        cell.number = std::move(number);
        table_.rows.back().cells.push_back(std::move(cell));
    }

    void add_resultant(NodeId node, const NodeVector& reaction)
    {
        if (!drawing::slanting_normal(shown_.model, node)) return table_.rows.back().cells.push_back({});
        add(drawing::resultant(reaction), Measure::Force, shown_.load_case,
            MovingEffect{.quantity = ExpectedQuantity::Reaction, .node = node});
    }

    void add(const GoverningExtreme& extreme, MemberId member, MemberComponent component)
    {
        const Curve curve = shown_.results[extreme.load_case].curve(member);
        add(extreme.value, measure_of(component), extreme.load_case,
            drawing::number_on_diagram(member, curve, component, extreme.x, extreme.value));
        table_.rows.back().cells.back().of_case = extreme.load_case;
        add(extreme.x, Measure::Length, extreme.load_case);
        add_name(extreme.load_case);
    }

    void add_case_heading() { table_.headings.push_back({manner_.tr("Case")}); }
    void add_name(CaseId load_case)
    {
        const std::string& name = shown_.model.case_name(load_case);
        table_.rows.back().cells.push_back({name});
    }

    TabledResults shown_;
    const Manner& manner_;
    AnalysisKind kind_;
    NumbersOfCases numbers_;
    Table table_;
};

} // namespace

Table result_table(const TabledResults& results, TableKind kind, const Manner& manner)
{
    ResultRows rows(results, manner);
    switch (kind) {
    case TableKind::Displacements: return rows.displacements();
    case TableKind::Reactions: return rows.reactions();
    case TableKind::MemberEnds: return rows.member_ends();
    case TableKind::Extremes: return rows.extremes();
    case TableKind::ReactionEnvelope: return rows.reaction_envelope();
    default: return rows.envelope();
    }
}

} // namespace frame
