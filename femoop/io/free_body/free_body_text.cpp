#include "femoop/io/free_body/free_body_text.h"

#include <cmath>
#include <cstddef>
#include <string_view>

#include "femoop/methods/free_body/ritter.h"
#include "femoop/model/fault/fault.h"
#include "femoop/model/quantity/dimension.h"
#include "femoop/model/quantity/number_text.h"
#include "femoop/model/quantity/six_digits.h"
#include "femoop/model/quantity/unit_signs.h"
#include "femoop/tabular/plain_text.h"

namespace femoop::free_body {

namespace {

constexpr std::size_t indent = 2;
constexpr double rounding = 1e-9; // of the largest thing that an equation sums

std::string unit(Dimension dimension, const Model& model) { return printed_unit(dimension, model.units); }

std::string length_text(double value, const Model& model, const Translator& tr)
{
    return six_digits(value, tr) + " " + unit(dimension::length, model);
}

std::string point_text(const Eigen::Vector3d& point, const Model& model, const Translator& tr)
{
    return place_text({point.data(), n_coordinates(model.analysis)}, tr);
}

double without_rounding(double term, const Equation& equation)
{
    return std::abs(term) <= rounding * equation.size ? 0.0 : term;
}

/// "ΣFy", or "ΣM" about the point.
std::string symbol(Dof dof, AnalysisKind kind)
{
    const std::string axis(1, "xyz"[index(dof) % 3]);
    if (!is_rotation(dof)) return "ΣF" + axis;
    return is_plane(kind) ? "ΣM" : "ΣM" + axis;
}

/// "60 + 54 − 114" without what is nothing; empty where all is.
std::string added(const std::vector<double>& terms, const Translator& tr)
{
    std::string text;
    for (const double term : terms) {
        if (term == 0.0) continue;
        text += term < 0.0 ? (text.empty() ? "−" : " − ") : (text.empty() ? "" : " + ");
        text += six_digits(std::abs(term), tr);
    }
    return text;
}

std::string sum_text(const Equation& equation, const Translator& tr)
{
    std::vector<double> terms;
    for (const double term : equation.terms) terms.push_back(without_rounding(term, equation));
    const std::string text = added(terms, tr);
    const std::string sum = six_digits(without_rounding(equation.sum, equation), tr);
    return text.empty() ? sum : text + " = " + sum;
}

tabular::Column column(Dof dof, const Model& model)
{
    const Dimension dimension = is_rotation(dof) ? dimension::moment : dimension::force;
    return {symbol(dof, model.analysis).substr(std::string_view("Σ").size()), unit(dimension, model)};
}

tabular::Table table(const FreeBody& body, const Model& model, const std::vector<Equation>& equations,
                     const Translator& tr)
{
    std::vector<tabular::Column> columns{tabular::Column(tr("acts on the body"))};
    for (const Equation& equation : equations) columns.push_back(column(equation.dof, model));
    tabular::Table table(columns);
    for (std::size_t i = 0; i < body.forces.size(); ++i) {
        std::vector<tabular::Cell> cells{force_text(body.forces[i], model, tr)};
        for (const Equation& equation : equations) cells.emplace_back(without_rounding(equation.terms[i], equation));
        table.add_row(std::move(cells));
    }
    std::vector<tabular::Cell> sums{tr("sum")};
    for (const Equation& equation : equations) sums.emplace_back(without_rounding(equation.sum, equation));
    table.add_row(std::move(sums));
    table.n_sums = 1;
    return table;
}

std::string piece_text(const Piece& piece, const Model& model, const Translator& tr)
{
    const double length = geometry_of(model, model[piece.member]).length;
    if (piece.from <= 0.0 && piece.to >= length) return model[piece.member].id;
    return fill(tr("{0} from x = {1} to x = {2}"),
                {model[piece.member].id, length_text(piece.from, model, tr), length_text(piece.to, model, tr)});
}

std::string body_text(const Body& body, const Model& model, const Translator& tr)
{
    std::string nodes, pieces;
    for (const NodeId node : body.nodes) nodes += (nodes.empty() ? "" : ", ") + model[node].id;
    for (const Piece& piece : body.pieces) pieces += (pieces.empty() ? "" : ", ") + piece_text(piece, model, tr);
    if (!nodes.empty()) nodes = fill(body.nodes.size() == 1 ? tr("node {0}") : tr("nodes {0}"), {nodes});
    if (!pieces.empty()) pieces = fill(body.pieces.size() == 1 ? tr("member {0}") : tr("members {0}"), {pieces});
    return fill(tr("Free body: {0}"), {nodes + (nodes.empty() || pieces.empty() ? "" : "; ") + pieces});
}

} // namespace

std::string force_text(const Force& force, const Model& model, const Translator& tr)
{
    const std::string node = force.node ? model[*force.node].id : std::string();
    const std::string member = force.member ? model[*force.member].id : std::string();
    const std::string x = length_text(force.x, model, tr);
    switch (force.kind) {
    case ForceKind::NodeLoad: return fill(tr("load at {0}"), {node});
    case ForceKind::Reaction: return fill(tr("reaction at {0}"), {node});
    case ForceKind::MemberLoad: return fill(tr("load on {0} at x = {1}"), {member, x});
    case ForceKind::Foundation: return fill(tr("foundation under {0} at x = {1}"), {member, x});
    case ForceKind::SectionForces: break;
    }
    return fill(tr("section of {0} at x = {1}"), {member, x});
}

std::vector<std::string> equation_lines(const FreeBody& body, const Model& model, const Eigen::Vector3d& about,
                                        const Translator& tr)
{
    std::vector<std::string> lines;
    for (const Equation& equation : equations(body, model.analysis, about)) {
        const bool is_moment = is_rotation(equation.dof);
        const std::string name = symbol(equation.dof, model.analysis) +
                                 (is_moment ? point_text(about, model, tr) : std::string());
        const std::string in = unit(is_moment ? dimension::moment : dimension::force, model);
        lines.push_back(name + " = " + sum_text(equation, tr) + "  [" + in + "]");
    }
    return lines;
}

std::string ritter_line(const FreeBody& body, const Model& model, const RitterPoint& point, const Translator& tr)
{
    RitterForce found = ritter_force(body, point);
    for (double& moment : found.moments) moment *= point.arm < 0.0 ? 1.0 : -1.0; // to the other side of the equation
    std::string moments = added(found.moments, tr);
    if (found.moments.size() > 1) moments = "(" + moments + ")";
    const std::string by_arm = moments.empty() ? "" : moments + " / " + six_digits(std::abs(point.arm), tr) + " = ";
    return fill(tr("N of {0} = {1}  [{2}]  about {3}, where the other bars meet"),
                {model[point.bar].id, by_arm + (found.force == 0.0 ? "0" : added({found.force}, tr)),
                 unit(dimension::force, model), point_text(point.at, model, tr)});
}

std::string free_body_text(const FreeBody& body, const Model& model, const Eigen::Vector3d& about, const Translator& tr)
{
    const std::vector<Equation> equations = free_body::equations(body, model.analysis, about);
    std::string text = body_text(body.body, model, tr) + "\n" +
                       fill(tr("Moments about {0} {1}"),
                            {point_text(about, model, tr), unit(dimension::length, model)}) +
                       "\n\n" + tabular::plain_text(table(body, model, equations, tr), {indent, decimal_mark(tr)}) +
                       "\n";
    for (const std::string& line : equation_lines(body, model, about, tr)) text += line + "\n";
    for (const RitterPoint& point : body.ritter_points) text += ritter_line(body, model, point, tr) + "\n";
    return text;
}

} // namespace femoop::free_body
