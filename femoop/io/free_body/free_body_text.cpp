#include "femoop/io/free_body/free_body_text.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numeric>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "femoop/io/results/matrix_table.h"
#include "femoop/methods/free_body/ritter.h"
#include "femoop/model/fault/fault.h"
#include "femoop/model/quantity/dimension.h"
#include "femoop/model/quantity/number_text.h"
#include "femoop/model/quantity/six_digits.h"
#include "femoop/model/quantity/unit_signs.h"
#include "femoop/tabular/halves.h"
#include "femoop/tabular/latex.h"
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

/// With the minus of the equations that it stands in.
std::string point_text(const Eigen::Vector3d& point, const Model& model, const Translator& tr)
{
    std::string text;
    for (const char letter : place_text({point.data(), n_coordinates(model.analysis)}, tr))
        text += letter == '-' ? std::string("−") : std::string(1, letter);
    return text;
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

constexpr double longest_whole = 1e12; // what is larger is written as a power of ten

/// A number of an equation: six digits, and all of a whole one that has more.
std::string digits(double value, const Translator& tr)
{
    constexpr double six_of_a_whole = 1e5;
    const double size = std::abs(value);
    if (size < six_of_a_whole || size >= longest_whole) return six_digits(value, tr);
    return localized(std::to_string(std::llround(tabular::off_half(value))), tr);
}

/// Numbers that balance, with as many decimals as give the largest six digits, whole ones at least, so that they add up to
/// nothing as printed too: each one is off by less than a unit of its last place. Those that do not balance are rounded
/// and no more.
std::vector<double> balanced(const std::vector<double>& numbers)
{
    constexpr int n_digits = 6;
    double largest = 0.0;
    for (const double one : numbers) largest = std::max(largest, std::abs(one));
    if (largest == 0.0) return numbers;
    const double for_six = n_digits - 1 - std::floor(std::log10(largest));
    const double decimals = largest < longest_whole ? std::max(for_six, 0.0) : for_six;
    const auto in_units = [&](double value) { return value * std::pow(10.0, decimals); };
    std::vector<double> rounded;
    for (const double one : numbers) rounded.push_back(std::round(tabular::off_half(in_units(one))));
    const double left = std::accumulate(rounded.begin(), rounded.end(), 0.0), way = left > 0.0 ? -1.0 : 1.0;
    std::vector<std::size_t> order(numbers.size());
    std::iota(order.begin(), order.end(), 0);
    std::ranges::stable_sort(order, std::greater(),
                             [&](std::size_t i) { return way * (in_units(numbers[i]) - rounded[i]); });
    const auto n = static_cast<std::size_t>(std::abs(left));
    if (n < order.size())
        for (std::size_t i = 0; i < n; ++i) rounded[order[i]] += way;
    for (double& one : rounded) one /= std::pow(10.0, decimals);
    return rounded;
}

/// "− 30 kN · 1 m" on the way through a sum, "−30 kN · 1 m" at its beginning.
std::string signed_term(double value, const std::string& size, bool is_first)
{
    if (value < 0.0) return (is_first ? "−" : " − ") + size;
    return (is_first ? "" : " + ") + size;
}

/// "60 + 54 − 114" without what is nothing; empty where all is.
std::string added(const std::vector<double>& terms, const Translator& tr)
{
    std::string text;
    for (const double term : terms)
        if (term != 0.0) text += signed_term(term, digits(std::abs(term), tr), text.empty());
    return text;
}

std::vector<double> shown_terms(const Equation& equation)
{
    std::vector<double> terms;
    if (is_rotation(equation.dof))
        for (const MomentTerm& one : equation.moments) terms.push_back(one.moment);
    else
        for (const double term : equation.terms) terms.push_back(without_rounding(term, equation));
    return balanced(terms);
}

std::string sum_text(const Equation& equation, const Translator& tr)
{
    const std::string text = added(shown_terms(equation), tr);
    const std::string sum = six_digits(without_rounding(equation.sum, equation), tr);
    return text.empty() ? sum : text + " = " + sum;
}

/// "−30 kN · 1 m + 84 kN·m"; empty where no force has an arm.
/// \param moments  of the terms, as the line after it has them, so that a moment is one number in both
std::string arms_text(std::span<const MomentTerm> terms, std::span<const double> moments, const Model& model,
                      const Translator& tr)
{
    if (std::ranges::none_of(terms, [](const MomentTerm& one) { return one.arm.has_value(); })) return {};
    std::string text;
    for (std::size_t i = 0; i < terms.size(); ++i) {
        const MomentTerm& one = terms[i];
        const double moment = moments[i] != 0.0 ? moments[i] : one.moment; // which may be too small for that line
        std::string size = digits(std::abs(one.arm ? one.value : moment), tr) + " " +
                           unit(one.arm ? dimension::force : dimension::moment, model);
        if (one.arm) size += " · " + length_text(std::abs(*one.arm), model, tr);
        text += signed_term(one.moment, size, text.empty());
    }
    return text;
}

/// "Fx", "M" about the point.
std::string summed(Dof dof, const Model& model)
{
    return symbol(dof, model.analysis).substr(std::string_view("Σ").size());
}

std::string equation_name(const Equation& equation, const Model& model, const Eigen::Vector3d& about,
                          const Translator& tr)
{
    return symbol(equation.dof, model.analysis) +
           (is_rotation(equation.dof) ? point_text(about, model, tr) : std::string());
}

void add_sums(tabular::Table& table, std::vector<tabular::Cell> sums)
{
    table.add_row(std::move(sums));
    table.n_sums = 1;
}

/// A column for each equation of forces.
tabular::Table force_table(const FreeBody& body, const Model& model, std::span<const Equation> equations,
                           const Translator& tr)
{
    std::vector<tabular::Column> columns{tabular::Column(tr("acts on the body"))};
    std::vector<std::vector<double>> terms;
    for (const Equation& equation : equations) {
        columns.emplace_back(summed(equation.dof, model), unit(dimension::force, model));
        terms.push_back(shown_terms(equation));
    }
    tabular::Table table(columns);
    for (std::size_t i = 0; i < body.forces.size(); ++i) {
        std::vector<tabular::Cell> cells{force_text(body.forces[i], model, tr)};
        for (const std::vector<double>& one : terms) cells.emplace_back(one[i]);
        table.add_row(std::move(cells));
    }
    std::vector<tabular::Cell> sums{tr("sum")};
    for (const Equation& equation : equations) sums.emplace_back(without_rounding(equation.sum, equation));
    add_sums(table, std::move(sums));
    return table;
}

/// "V" of a section, "fx" of what else.
std::string component_text(const MomentTerm& term, const Model& model)
{
    return std::string(term.of ? name(*term.of, model.analysis) : force_name(term.dof));
}

/// Of what has a moment about the point: each force with its arm, and the moments by themselves.
tabular::Table moment_table(const FreeBody& body, const Model& model, const Equation& equation, const Translator& tr)
{
    tabular::Table table({tr("turns the body"),
                          {std::string(), {}, tabular::Alignment::Left},
                          {tr("force"), unit(dimension::force, model)},
                          {tr("arm"), unit(dimension::length, model)},
                          {summed(equation.dof, model), unit(dimension::moment, model)}});
    const std::vector<double> moments = shown_terms(equation);
    for (std::size_t i = 0; i < moments.size(); ++i) {
        const MomentTerm& one = equation.moments[i];
        const auto nothing = tabular::Cell();
        table.add_row({force_text(body.forces[one.force], model, tr), component_text(one, model),
                       one.arm ? tabular::Cell(one.value) : nothing, one.arm ? tabular::Cell(*one.arm) : nothing,
                       moments[i]});
    }
    add_sums(table, {tr("sum"), {}, {}, {}, without_rounding(equation.sum, equation)});
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
        const std::string arms = is_moment ? arms_text(equation.moments, shown_terms(equation), model, tr)
                                           : std::string();
        const std::string name = equation_name(equation, model, about, tr);
        if (!arms.empty()) lines.push_back(name + " = " + arms);
        lines.push_back((arms.empty() ? name : std::string()) + (arms.empty() ? " = " : "= ") + sum_text(equation, tr) +
                        "  [" + unit(is_moment ? dimension::moment : dimension::force, model) + "]");
    }
    return lines;
}

std::vector<std::string> ritter_lines(const FreeBody& body, const Model& model, const RitterPoint& point,
                                      const Translator& tr)
{
    RitterForce found = ritter_force(body, point);
    std::vector<double> moments;
    for (MomentTerm& one : found.moments) {
        one.moment *= point.arm < 0.0 ? 1.0 : -1.0; // to the other side of the equation
        moments.push_back(one.moment);
    }
    const auto by_arm = [&](const std::string& sum, const std::string& arm) {
        if (sum.empty()) return sum;
        return (moments.size() > 1 ? "(" + sum + ")" : sum) + " / " + arm;
    };
    const double arm = std::abs(point.arm);
    const std::string arms = by_arm(arms_text(found.moments, moments, model, tr), length_text(arm, model, tr));
    const std::string sum = by_arm(added(moments, tr), six_digits(arm, tr));
    const std::string force = found.force == 0.0 ? "0" : added({found.force}, tr);
    std::vector<std::string> lines{fill(tr("N of {0} = {1}"), {model[point.bar].id, arms.empty() ? sum : arms})};
    if (sum.empty()) lines.back() += force;
    else lines.push_back((arms.empty() ? "" : "= " + sum + " ") + "= " + force);
    lines.back() += fill(tr("  [{0}]  about {1}, where the other bars meet"),
                         {unit(dimension::force, model), point_text(point.at, model, tr)});
    return lines;
}

namespace {

std::string moment_point_text(const Model& model, const Eigen::Vector3d& about, const Translator& tr)
{
    return fill(tr("Moments about {0} {1}"), {point_text(about, model, tr), unit(dimension::length, model)});
}

/// Of the forces, then of the moments about each axis.
std::vector<tabular::Table> tables(const FreeBody& body, const Model& model, const Eigen::Vector3d& about,
                                   const Translator& tr)
{
    const std::vector<Equation> equations = free_body::equations(body, model.analysis, about);
    const auto first_moment = std::ranges::find_if(equations, [](const Equation& one) { return is_rotation(one.dof); });
    const auto n_forces = static_cast<std::size_t>(first_moment - equations.begin());
    const std::span<const Equation> all_equations = equations;
    std::vector<tabular::Table> all{force_table(body, model, all_equations.first(n_forces), tr)};
    for (const Equation& equation : all_equations.subspan(n_forces))
        if (!equation.moments.empty()) all.push_back(moment_table(body, model, equation, tr));
    return all;
}

std::vector<std::string> all_lines(const FreeBody& body, const Model& model, const Eigen::Vector3d& about,
                                   const Translator& tr)
{
    std::vector<std::string> lines = equation_lines(body, model, about, tr);
    for (const RitterPoint& point : body.ritter_points)
        for (std::string& line : ritter_lines(body, model, point, tr)) lines.push_back(std::move(line));
    return lines;
}

/// The sum's sign and its letter: what stands behind a Greek letter would be taken for its index.
std::string line_latex(std::string_view line)
{
    constexpr std::string_view sum = "Σ";
    if (!line.starts_with(sum)) return tabular::latex_text(line);
    line.remove_prefix(sum.size());
    std::string letters = "\\sum " + std::string(line.substr(0, 1));
    line.remove_prefix(1);
    if (std::string_view("xyz").find(line.front()) != std::string_view::npos) {
        letters += "_" + std::string(line.substr(0, 1));
        line.remove_prefix(1);
    }
    return "\\ensuremath{" + letters + "}" + tabular::latex_text(line);
}

} // namespace

std::string uncut_sentence(const std::vector<MemberId>& across, const Model& model, const Translator& tr)
{
    std::vector<std::string> names;
    for (const MemberId member : across) names.push_back(model[member].id);
    return femoop::fill(
        tr("the cut does not part the structure: it still hangs together by {0}; let the cut go right through it"),
        {listed(names)}, tr(translatable("and")));
}

std::string free_body_text(const FreeBody& body, const Model& model, const Eigen::Vector3d& about, const Translator& tr)
{
    std::string text = body_text(body.body, model, tr) + "\n" + moment_point_text(model, about, tr) + "\n\n";
    for (const tabular::Table& table : tables(body, model, about, tr))
        text += tabular::plain_text(table, {indent, decimal_mark(tr)}) + "\n";
    for (const std::string& line : all_lines(body, model, about, tr)) text += line + "\n";
    return text;
}

std::string free_body_latex(const FreeBody& body, const Model& model, const Eigen::Vector3d& about,
                            const Translator& tr)
{
    std::string text = "\\section*{" + tabular::latex_text(body_text(body.body, model, tr)) + "}\n" +
                       tabular::latex_text(moment_point_text(model, about, tr)) + "\n";
    for (tabular::Table& table : tables(body, model, about, tr)) text += latex_table(std::move(table), tr);
    for (const std::string& line : all_lines(body, model, about, tr))
        text += "\\par\\noindent " + line_latex(line) + "\n";
    return text;
}

} // namespace femoop::free_body
