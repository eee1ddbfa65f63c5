#include "femoop/io/plane/element_trace_output.h"
#include "femoop/io/results/matrix_table.h"
#include "femoop/model/fault/fault.h"
#include "femoop/model/quantity/number_text.h"
#include "femoop/model/quantity/six_digits.h"
#include "femoop/tabular/plain_text.h"

namespace femoop::plane {

namespace {

constexpr std::size_t trace_indent = 2;

std::string trace_section(const std::string& title, const tabular::Table& table, const Translator& tr)
{
    return "\n" + title + "\n" + tabular::plain_text(table, {trace_indent, decimal_mark(tr)});
}

/// What a point's matrices are made of: "xi = -0.577, eta = ..".
std::string point_text(const ElementTrace& trace, std::size_t index, const Translator& tr)
{
    const ElementTrace::Point& point = trace.points[index];
    std::string text = "\n" +
                       fill(tr("Integration point {0}: xi = {1}, eta = {2}, weight {3}; x = {4}, y = {5}"),
                            {std::to_string(index + 1), six_digits(point.natural.xi, tr),
                             six_digits(point.natural.eta, tr), six_digits(point.weight, tr),
                             six_digits(point.at.x(), tr), six_digits(point.at.y(), tr)}) +
                       "\n";
    text += trace_section(tr("Shape functions N"), matrix_table({"N"}, trace.nodes, point.N.transpose()), tr);
    text += trace_section(tr("Jacobian J = d(x, y)/d(xi, eta)"), matrix_table({"xi", "eta"}, {"x", "y"}, point.J), tr);
    text += "  " + fill(tr("det J = {0}, depth {1}"), {six_digits(point.area, tr), six_digits(point.depth, tr)}) + "\n";
    text += trace_section(tr("B, strain = B u"), matrix_table(trace.components, trace.dofs, point.B), tr);
    return text;
}

} // namespace

std::string trace_text(const ElementTrace& trace, const Units& units, const Translator& tr)
{
    std::string text = fill(tr("Element {0}, {1} in region {2}, formulation {3}: how it enters the system K u = f"),
                            {trace.element, std::string(femoop::name(trace.kind)), trace.region,
                             std::string(name(trace.formulation))}) +
                       "\n" +
                       fill(tr("Lengths in {0}, forces in {1}."),
                            {std::string(name(units.length)), std::string(name(units.force))}) +
                       "\n";
    text += trace_section(tr("D, stress = D strain"), matrix_table(trace.components, trace.components, trace.D), tr);
    for (std::size_t i = 0; i < trace.points.size(); ++i) text += point_text(trace, i, tr);
    const bool has_modes = trace.formulation == Formulation::Incompatible;
    text += trace_section(has_modes
                              ? tr("Stiffness k: the sum of B^T D B weight det J depth over the points, less what "
                                   "the incompatible modes take")
                              : tr("Stiffness k: the sum of B^T D B weight det J depth over the points"),
                          matrix_table(trace.dofs, trace.dofs, trace.stiffness), tr);
    if (trace.to_nodes.size() > 0)
        text += trace_section(tr("Stiffness in the axes of supports that are turned"),
                              matrix_table(trace.dofs, trace.dofs, trace.to_nodes), tr);
    for (const ElementTrace::NodalForces& load : trace.loads)
        text += trace_section(fill(tr("What its loads are to its nodes, load case {0}"), {load.load_case}),
                              matrix_table(trace.dofs, {"f"}, load.f), tr);
    tabular::Table rows({tr("row"), tr("place in the system matrix")});
    for (std::size_t i = 0; i < trace.dofs.size(); ++i)
        rows.add_row({trace.dofs[i],
                      trace.equations[i] == 0 ? tr("none: held by a support") : std::to_string(trace.equations[i])});
    return text + trace_section(tr("Where each row is added"), rows, tr);
}

} // namespace femoop::plane
