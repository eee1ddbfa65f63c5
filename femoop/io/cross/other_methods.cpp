#include "femoop/io/cross/other_methods.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "femoop/io/json/json_writer.h"
#include "femoop/model/fault/fault.h"
#include "femoop/model/quantity/number_text.h"
#include "femoop/model/quantity/unit_signs.h"
#include "femoop/tabular/plain_text.h"

namespace femoop::cross {

namespace {

constexpr double round_off_of_moments = 1e-12; // of the largest moment

/// Names of the unknowns: joints that turn, then props that move.
std::vector<std::string> unknowns(const Model& model, const Problem& problem)
{
    std::vector<std::string> names;
    for (const Joint& joint : problem.joints) names.push_back("th_" + model[joint.node].id);
    for (const Sway& sway : problem.sways) names.push_back("d_" + model[sway.prop].id);
    return names;
}

/// Numbers below round-off of the largest are 0.
std::vector<double> without_round_off(std::vector<double> values, double largest)
{
    for (double& value : values)
        if (std::abs(value) <= round_off_of_moments * largest) value = 0.0;
    return values;
}

double largest_moment(const std::vector<double>& values)
{
    double largest = 0.0;
    for (const double value : values) largest = std::max(largest, std::abs(value));
    return largest;
}

std::string method_heading(const Model& model, const Problem& problem, const std::string& what, const Translator& tr)
{
    const std::string unit = printed_unit(dimension::moment, model.units);
    return fill(tr("{0}, case {1}: moments on the member ends in {2}, counter-clockwise positive"),
                {what, model.case_name(problem.load_case), unit}) +
           "\n\n";
}

void add_row(tabular::Table& table, const std::string& name, const std::vector<double>& values, std::size_t kind = 0)
{
    std::vector<tabular::Cell> cells{name};
    cells.insert(cells.end(), values.begin(), values.end());
    table.add_row(std::move(cells), kind);
}

std::vector<tabular::Column> headers(const std::string& first, const Problem& problem)
{
    std::vector<tabular::Column> all{first};
    for (const End& end : problem.ends) all.push_back(end.label);
    return all;
}

void write_ends(JsonWriter& json, const char* key, const Problem& problem, const std::vector<double>& values)
{
    json.key(key).begin_object();
    for (std::size_t e = 0; e < values.size(); ++e) json.member(problem.ends[e].label, values[e]);
    json.end();
}

std::vector<double> listed_of(const Eigen::VectorXd& values) { return {values.begin(), values.end()}; }

void write_numbers(JsonWriter& json, const std::vector<double>& values)
{
    json.begin_array();
    for (const double value : values) json.value(value);
    json.end();
}

} // namespace

std::string kani_text(const Model& model, const Problem& problem, const Kani& kani, const Translator& tr)
{
    const double largest = largest_moment(kani.moments);
    tabular::Table table(headers(tr("cycle"), problem));
    add_row(table, "mu", kani.rotation_factor, 1);
    add_row(table, tr("FEM"), without_round_off(problem.loading.fixed_end, largest));
    for (std::size_t i = 0; i < kani.cycles.size(); ++i)
        add_row(table, std::to_string(i + 1), without_round_off(kani.cycles[i].rotation_contribution, largest));
    if (!problem.sways.empty() && !kani.cycles.empty())
        add_row(table, "M\"", without_round_off(kani.cycles.back().sway_contribution, largest));
    add_row(table, tr("TOTAL"), without_round_off(kani.moments, largest));
    return method_heading(model, problem, tr("Kani's method"), tr) +
           tabular::plain_text(table, {.decimal_mark = decimal_mark(tr)}) +
           tr("TOTAL = FEM + 2 M' + M' of the far end + M\" of the sways") + "\n";
}

std::string kani_json(const Model& model, const Problem& problem, const Kani& kani)
{
    const double largest = largest_moment(kani.moments);
    JsonWriter json;
    json.begin_object(JsonWriter::Layout::Block).member("method", "kani");
    json.member("case", model.case_name(problem.load_case));
    write_ends(json, "rotation_factors", problem, kani.rotation_factor);
    write_ends(json, "fixed_end_moments", problem, without_round_off(problem.loading.fixed_end, largest));
    json.key("cycles").begin_array(JsonWriter::Layout::Block);
    for (const KaniCycle& cycle : kani.cycles) {
        json.begin_object();
        write_ends(json, "rotation", problem, without_round_off(cycle.rotation_contribution, largest));
        if (!problem.sways.empty())
            write_ends(json, "sway", problem, without_round_off(cycle.sway_contribution, largest));
        json.end();
    }
    json.end();
    write_ends(json, "total", problem, without_round_off(kani.moments, largest));
    json.end();
    return json.take();
}

std::string equations_text(const Model& model, const Problem& problem, const SlopeDeflection& equations,
                           const Translator& tr)
{
    const std::vector<std::string> names = unknowns(model, problem);
    std::vector<tabular::Column> head{""};
    head.insert(head.end(), names.begin(), names.end());
    head.insert(head.end(), {tr("right-hand side"), tr("solution")});
    tabular::Table table(std::move(head));
    for (std::size_t i = 0; i < names.size(); ++i) {
        const auto row = static_cast<Eigen::Index>(i);
        std::vector<double> values = listed_of(equations.A.row(row));
        values.insert(values.end(), {equations.b[row] + 0.0, equations.x[row] + 0.0});
        add_row(table, names[i], values, i);
    }
    tabular::Table moments(headers("", problem));
    add_row(moments, tr("TOTAL"), without_round_off(equations.moments, largest_moment(equations.moments)));
    return method_heading(model, problem, tr("Slope-deflection equations"), tr) +
           tabular::plain_text(table, {.decimal_mark = decimal_mark(tr)}) + "\n" +
           tabular::plain_text(moments, {.decimal_mark = decimal_mark(tr)});
}

std::string equations_json(const Model& model, const Problem& problem, const SlopeDeflection& equations)
{
    JsonWriter json;
    json.begin_object(JsonWriter::Layout::Block).member("method", "slope-deflection");
    json.member("case", model.case_name(problem.load_case)).key("unknowns").begin_array();
    for (const std::string& name : unknowns(model, problem)) json.value(name);
    json.end().key("matrix").begin_array(JsonWriter::Layout::Block);
    for (Eigen::Index i = 0; i < equations.x.size(); ++i) write_numbers(json, listed_of(equations.A.row(i)));
    json.end().key("right_hand_side");
    write_numbers(json, listed_of(equations.b));
    json.key("solution");
    write_numbers(json, listed_of(equations.x));
    write_ends(json, "total", problem, without_round_off(equations.moments, largest_moment(equations.moments)));
    json.end();
    return json.take();
}

} // namespace femoop::cross
