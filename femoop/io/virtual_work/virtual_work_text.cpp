#include "femoop/io/virtual_work/virtual_work_text.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numeric>
#include <string_view>
#include <vector>

#include "femoop/geometry/member_geometry.h"
#include "femoop/io/results/matrix_table.h"
#include "femoop/methods/influence/effect_name.h"
#include "femoop/model/fault/fault.h"
#include "femoop/model/quantity/number_text.h"
#include "femoop/model/quantity/six_digits.h"
#include "femoop/model/quantity/unit_signs.h"
#include "femoop/result/expression.h"
#include "femoop/result/magnitudes.h"
#include "femoop/tabular/latex.h"
#include "femoop/tabular/plain_text.h"

namespace femoop::virtual_work {

namespace {

constexpr std::size_t indent = 2;
constexpr int formula_digits = 6, sheet_digits = 4;

/// What the force of a stretch or joint is called, and what resists it.
std::string_view stiffness_name(const std::optional<MemberComponent>& force)
{
    if (!force) return "k";
    switch (*force) {
    case MemberComponent::N: return "EA";
    case MemberComponent::Vy: return "GAsy";
    case MemberComponent::Vz: return "GAsz";
    case MemberComponent::T: return "GJ";
    case MemberComponent::My: return "EIy";
    default: return "EIz";
    }
}

/// Of the largest of its parts.
double size_of(const Work& work)
{
    double size = 0.0;
    for (const WorkIntegral& one : work.integrals) size = std::max(size, std::abs(one.value));
    for (const JointWork& one : work.joints) size = std::max(size, std::abs(one.value));
    for (const SupportWork& one : work.supports) size = std::max(size, std::abs(one.value));
    return size;
}

/// The tables of one work.
class Tables {
public:
    Tables(const Work& of, const WorkCaptions& captions, const Model& model, const Translator& tr)
        : of_(of), captions_(captions), model_(model), tr_(tr), size_(size_of(of))
    {}

    std::string all() const
    {
        const auto shown = [&](const std::string& sentence, const tabular::Table& table, const std::string& note = {}) {
            if (table.is_empty()) return std::string();
            return "\n" + sentence + "\n" + tabular::plain_text(table, {indent, decimal_mark(tr_)}) +
                   (note.empty() ? note : note + "\n");
        };
        return shown(integral_sentence(), integrals(), taper_sentence(of_, tr_)) + shown(joint_sentence(), joints()) +
               shown(support_sentence(), supports());
    }

    std::string latex() const
    {
        const auto shown = [&](const std::string& sentence, const tabular::Table& table) {
            if (table.is_empty()) return std::string();
            return "\n\\par\n" + tabular::latex_text(sentence) + "\n" + latex_table(table, tr_);
        };
        std::string text;
        if (!of_.integrals.empty()) text = "\n\\par\n" + tabular::latex_text(integral_sentence()) + "\n";
        if (std::ranges::any_of(of_.integrals, is_tapered)) text += tabular::latex_text(split_sentence()) + "\n";
        for (const WorkIntegral& one : of_.integrals) text += latex(one);
        return text + shown(joint_sentence(), joints()) + shown(support_sentence(), supports());
    }

    /// "a + b - c", the work of each part.
    std::string addends() const
    {
        std::string text;
        for (const Part& one : parts()) {
            const std::string value = value_text(one.value);
            if (value == "0") continue;
            const bool is_negative = value.starts_with('-');
            text += text.empty() ? (is_negative ? "-" : "") : (is_negative ? " - " : " + ");
            text += is_negative ? value.substr(1) : value;
        }
        return text.empty() ? "0" : text;
    }

    /// What works, a row each, with its work.
    struct Part {
        std::vector<tabular::Cell> cells; ///< without the work
        double value;
    };
    std::vector<Part> parts() const
    {
        std::vector<Part> all;
        for (const WorkIntegral& one : of_.integrals) all.push_back(part(one));
        for (const JointWork& one : of_.joints) all.push_back(part(one));
        for (const SupportWork& one : of_.supports) all.push_back(part(one));
        return all;
    }
    std::string value_text(double value) const { return six_digits(without_rounding(value, size_), tr_); }

private:
    std::string force_name(const std::optional<MemberComponent>& force) const
    {
        return force ? std::string(name(*force, model_.analysis)) : "p";
    }
    std::string length_unit() const { return unit_text(dimension::length, model_.units); }
    std::string formula(const Polynomial& p, const WorkIntegral& on, int digits = formula_digits) const
    {
        const double length = geometry_of(model_, model_[on.member]).length;
        return localized(femoop::text(expression(p, on.from, on.to, length), digits), tr_);
    }
    /// Of the two forces, multiplied out; of power series it is not written.
    std::string product_formula(const WorkIntegral& on, int digits = formula_digits) const
    {
        const auto multiplied = product(on);
        return multiplied ? formula(*multiplied, on, digits) : "…";
    }
    /// Over a stiffness that varies it is no part of the work.
    std::string product_integral(const WorkIntegral& on) const
    {
        if (on.stiffness.n_terms() > 1) return "–";
        const double bound = largest(on.real, on) * largest(on.unit, on) * (on.to - on.from);
        return six_digits(without_rounding(integral_of_product(on), bound), tr_);
    }
    /// No value of the polynomial is greater.
    static double largest(const Polynomial& p, const WorkIntegral& on)
    {
        double sum = 0.0, power = 1.0;
        for (std::size_t i = 0; i < p.n_terms(); ++i, power *= on.to - on.from) sum += std::abs(p[i]) * power;
        return sum;
    }

    Part part(const WorkIntegral& one) const
    {
        const std::string strain = one.strain == 0.0 ? "" : "; ε = " + strain_value(one, sheet_digits);
        return {{model_[one.member].id, force_name(one.force),
                 six_digits(one.from, tr_) + " … " + six_digits(one.to, tr_), formula(one.real, one, sheet_digits),
                 formula(one.unit, one, sheet_digits), product_formula(one, sheet_digits), product_integral(one),
                 stiffness(one) + strain},
                one.value};
    }
    Part part(const JointWork& one) const
    {
        const std::string& node = model_[model_[one.member].nodes.at(one.end)].id;
        return {{fill(tr_("spring of {0} at {1}"), {model_[one.member].id, node}), force_name(one.force), "",
                 six_digits(one.real, tr_), six_digits(one.unit, tr_), six_digits(one.real * one.unit, tr_), "",
                 "k = " + six_digits(one.stiffness, tr_)},
                one.value};
    }
    Part part(const SupportWork& one) const
    {
        return {{fill(tr_("support {0}"), {model_[one.node].id}), std::string(name(one.dof)), "",
                 "c = " + six_digits(one.displacement, tr_), "r = " + six_digits(one.reaction, tr_), "−r c", "", ""},
                one.value};
    }

    static bool is_tapered(const WorkIntegral& on) { return on.stiffness.n_terms() > 1; }
    std::string stiffness_value(const WorkIntegral& on) const
    {
        if (!is_tapered(on)) return six_digits(1.0 / on.flexibility, tr_);
        Polynomial varying;
        for (std::size_t i = 0; i < on.stiffness.n_terms(); ++i) varying.append(on.stiffness[i] / on.flexibility);
        return formula(varying, on);
    }
    /// Along a taper heat bends as its depth says: curvature(0) h(0) / h(x).
    static bool has_varying_strain(const WorkIntegral& on) { return on.strain != 0.0 && on.depth.n_terms() > 1; }
    std::string strain_value(const WorkIntegral& on, int digits = formula_digits) const
    {
        const std::string at_start = six_digits(on.strain, tr_);
        return has_varying_strain(on) ? at_start + " / (" + formula(on.depth, on, digits) + ")" : at_start;
    }
    std::string strain_latex(const WorkIntegral& on) const
    {
        const std::string at_start = tabular::latex_formula(six_digits(on.strain, tr_));
        if (!has_varying_strain(on)) return at_start;
        return "\\frac{" + at_start + "}{" + tabular::latex_formula(formula(on.depth, on)) + "}";
    }
    static std::string strain_symbol(const WorkIntegral& on)
    {
        return has_varying_strain(on) ? "\\varepsilon(x)" : "\\varepsilon";
    }
    std::string stiffness(const WorkIntegral& on) const
    {
        if (on.flexibility == 0.0) return tr_("rigid");
        return std::string(stiffness_name(on.force)) + " = " + stiffness_value(on);
    }

    /// "EI_{z}", "V_{y}": what follows the letters that are a name by themselves is its index.
    static std::string with_index(std::string_view symbol, std::size_t n_letters)
    {
        std::string text(symbol.substr(0, n_letters));
        if (symbol.size() > n_letters) text += "_{" + std::string(symbol.substr(n_letters)) + "}";
        return text;
    }
    std::string stiffness_symbol(const WorkIntegral& on) const
    {
        return with_index(stiffness_name(on.force), 2) + (is_tapered(on) ? "(x)" : "");
    }

    /// What is integrated, then the same with numbers; no numbers where the stiffness varies.
    std::string integrand(const WorkIntegral& on) const
    {
        const std::string strained = on.flexibility == 0.0 ? "" : "\\frac{F f}{" + stiffness_symbol(on) + "}";
        if (on.strain == 0.0) return strained.empty() ? "0" : strained;
        const std::string imposed = strain_symbol(on) + " f";
        return strained.empty() ? imposed : "\\left(" + strained + " + " + imposed + "\\right)";
    }
    std::string integrated(const WorkIntegral& on) const
    {
        if (is_tapered(on)) return {};
        std::string text;
        const auto add = [&](const std::string& term) { text += (text.empty() ? "" : " + ") + term; };
        if (on.flexibility != 0.0)
            add("\\frac{" + tabular::latex_formula(product_integral(on)) + "}{" +
                tabular::latex_formula(stiffness_value(on)) + "}");
        if (on.strain != 0.0) {
            WorkIntegral of_unit = on;
            of_unit.real = Polynomial{1.0};
            add("(" + tabular::latex_formula(six_digits(on.strain, tr_)) + ") \\cdot (" +
                tabular::latex_formula(product_integral(of_unit)) + ")");
        }
        return text.empty() ? text : " = " + text;
    }
    std::string latex(const WorkIntegral& one) const
    {
        const auto math = [](const std::string& symbol, const std::string& value) {
            return "$" + symbol + " = " + tabular::latex_formula(value) + "$";
        };
        std::string text = "\n\\paragraph{" + tabular::latex_text(model_[one.member].id) + ", $" +
                           with_index(force_name(one.force), 1) + "$}\n" + math("F", formula(one.real, one)) +
                           ", \\quad " + math("f", formula(one.unit, one));
        if (product(one)) text += ", \\quad " + math("F f", product_formula(one));
        if (one.flexibility == 0.0) text += ", \\quad " + tabular::latex_text(tr_("rigid"));
        else text += ", \\quad " + math(stiffness_symbol(one), stiffness_value(one));
        if (one.strain != 0.0) text += ", \\quad $" + strain_symbol(one) + " = " + strain_latex(one) + "$";
        return text + "\n\\[\n\\int_{" + tabular::latex_formula(six_digits(one.from, tr_)) + "}^{" +
               tabular::latex_formula(six_digits(one.to, tr_)) + "} " + integrand(one) + "\\, dx" + integrated(one) +
               " = " + tabular::latex_formula(value_text(one.value)) + "\n\\]\n";
    }

    bool is_strained() const
    {
        return std::ranges::any_of(of_.integrals, [](const WorkIntegral& one) { return one.strain != 0.0; });
    }
    std::string integral_sentence() const
    {
        return is_strained()
                   ? tr_("Members: the integral of f (F / stiffness + ε) over x, the distance from the first node.")
                   : tr_("Members: the integral of F f / stiffness over x, the distance from the first node.");
    }
    /// Where each integral stands with its stiffness, and nothing is left out of a table.
    std::string split_sentence() const
    {
        return tr_("Along a taper the stiffness varies with x and stays under the integral: it is split into short "
                   "pieces, over which F f / stiffness is a power series, integrated term by term.");
    }
    std::string joint_sentence() const { return tr_("Springs at the ends of members: F f / stiffness."); }
    std::string support_sentence() const { return tr_("Supports that move, by springs or settlements: -r c."); }

    tabular::Table integrals() const
    {
        const auto& all = of_.integrals;
        std::vector<tabular::Column> columns{tr_("member"),
                                             "F",
                                             {tr_("from"), length_unit()},
                                             {tr_("to"), length_unit()},
                                             captions_.real + "(x)",
                                             captions_.unit + "(x)",
                                             "F f",
                                             {"∫ F f dx", "", tabular::Alignment::Right},
                                             tr_("stiffness")};
        if (is_strained()) columns.emplace_back(tr_("imposed strain ε"), "", tabular::Alignment::Right);
        columns.emplace_back(tr_("work"), captions_.unit_of_work, tabular::Alignment::Right);
        tabular::Table table(std::move(columns));
        for (const WorkIntegral& one : all) {
            std::vector<tabular::Cell> cells{model_[one.member].id,
                                             force_name(one.force),
                                             one.from,
                                             one.to,
                                             formula(one.real, one),
                                             formula(one.unit, one),
                                             product_formula(one),
                                             product_integral(one),
                                             stiffness(one)};
            if (is_strained()) cells.emplace_back(strain_value(one));
            cells.emplace_back(value_text(one.value));
            table.add_row(std::move(cells));
        }
        return table;
    }

    tabular::Table joints() const
    {
        tabular::Table table({tr_("member"),
                              tr_("node"),
                              "F",
                              {captions_.real, "", tabular::Alignment::Right},
                              {captions_.unit, "", tabular::Alignment::Right},
                              {tr_("stiffness"), "", tabular::Alignment::Right},
                              {tr_("work"), captions_.unit_of_work, tabular::Alignment::Right}});
        for (const JointWork& one : of_.joints)
            table.add_row({model_[one.member].id, model_[model_[one.member].nodes.at(one.end)].id,
                           force_name(one.force), six_digits(one.real, tr_), six_digits(one.unit, tr_),
                           six_digits(one.stiffness, tr_), value_text(one.value)});
        return table;
    }

    tabular::Table supports() const
    {
        tabular::Table table({tr_("node"),
                              tr_("direction"),
                              {tr_("displacement c"), "", tabular::Alignment::Right},
                              {tr_("reaction r to the unit load"), "", tabular::Alignment::Right},
                              {tr_("work"), captions_.unit_of_work, tabular::Alignment::Right}});
        for (const SupportWork& one : of_.supports)
            table.add_row({model_[one.node].id, std::string(name(one.dof)), six_digits(one.displacement, tr_),
                           six_digits(one.reaction, tr_), value_text(one.value)});
        return table;
    }

    const Work& of_;
    const WorkCaptions& captions_;
    const Model& model_;
    const Translator& tr_;
    double size_ = 0.0; ///< of the largest work
};

} // namespace

std::string taper_sentence(const Work& work, const Translator& tr)
{
    const auto is_tapered = [](const WorkIntegral& one) { return one.stiffness.n_terms() > 1; };
    if (std::ranges::none_of(work.integrals, is_tapered)) return {};
    return tr(
        "Along a taper the stiffness varies with x and stays under the integral: it is split into short pieces, over "
        "which F f / stiffness is a power series, integrated term by term, and there is no ∫ F f dx (–) of its own.");
}

double without_round_off(double value, const Work& work) { return without_rounding(value, size_of(work)); }

std::string free_rotation_text(const Model& model, NodeId node, const Translator& tr)
{
    std::vector<std::string> members;
    for (const Member& member : model.members)
        if (std::ranges::find(member.nodes, node) != member.nodes.end()) members.push_back(member.id);
    return fill(
        tr("node {0} has no rotation of its own: the ends of {1} turn there each by themselves; put a node on the "
           "one that is meant, just beside {0}, and ask for its rotation"),
        {model[node].id, listed(members)});
}

std::string work_text(const Work& work, const WorkCaptions& captions, const Model& model, const Translator& tr)
{
    return Tables(work, captions, model, tr).all();
}

namespace {

/// Which of the parts are told one by one: all, or those that work most.
std::vector<bool> told_apart(const std::vector<Tables::Part>& parts, std::size_t most)
{
    std::vector<bool> is_told(parts.size(), true);
    if (parts.size() <= most) return is_told;
    std::vector<std::size_t> order(parts.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, std::greater<>(), [&](std::size_t i) { return std::abs(parts[i].value); });
    for (std::size_t i = most - 1; i < order.size(); ++i) is_told[order[i]] = false;
    return is_told;
}

} // namespace

tabular::Table work_table(const VirtualWork& work, const Model& model, const Translator& tr, std::size_t most_rows)
{
    const std::string unit = printed_unit(influence::dimension_of(work.displacement), model.units);
    const WorkCaptions captions{.real = "F", .unit = "f", .unit_of_work = unit};
    const Tables tables(work.work, captions, model, tr);
    using tabular::Alignment;
    tabular::Table table({tr("member"),
                          "",
                          {"x", unit_text(dimension::length, model.units)},
                          {"F(x)", "", Alignment::Left},
                          {"f(x)", "", Alignment::Left},
                          {"F f", "", Alignment::Left},
                          {"∫ F f dx", "", Alignment::Right},
                          tr("stiffness"),
                          {tr("work"), unit, Alignment::Right}});
    const auto parts = tables.parts();
    const std::vector<bool> is_told = told_apart(parts, most_rows);
    double rest = 0.0;
    std::size_t n_rest = 0;
    const auto add = [&](std::vector<tabular::Cell> cells, double value) {
        cells.resize(table.columns.size() - 1);
        cells.emplace_back(tables.value_text(value));
        table.add_row(std::move(cells));
    };
    for (std::size_t i = 0; i < parts.size(); ++i) {
        if (is_told[i]) add(parts[i].cells, parts[i].value);
        else rest += parts[i].value;
        n_rest += is_told[i] ? 0 : 1;
    }
    if (n_rest > 0) add({fill(tr("{0} more that work less"), {std::to_string(n_rest)})}, rest);
    add({tr("sum")}, work.sum);
    table.n_sums = 1;
    return table;
}

namespace {

/// What stands above and below the tables of a displacement.
struct Sentences {
    std::string title, units, unit_load, unit_of_work, sum, analysis;
};

Sentences sentences(const VirtualWork& work, const Model& model, const Translator& tr)
{
    const std::string unit = printed_unit(influence::dimension_of(work.displacement), model.units);
    const auto value = [&](double number) { return six_digits(without_round_off(number, work.work), tr); };
    return {.title = fill(tr("{0} = {1} in {2}: by virtual work"),
                          {influence::effect_name(model, work.displacement, tr), value(work.value) + " " + unit,
                           model.case_name(work.load_case)}),
            .units = fill(tr("Lengths in {0}, forces in {1}, rotations in rad."),
                          {std::string(name(model.units.length)), std::string(name(model.units.force))}),
            .unit_load = tr("A unit load stands where the displacement is asked for, and along it. Its forces work on "
                            "what the loads strain: the displacement is the sum of that work."),
            .unit_of_work = unit,
            .sum = value(work.sum),
            .analysis = fill(tr("Sum: {0} {1}; the analysis has {2}."), {value(work.sum), unit, value(work.value)})};
}

} // namespace

std::string virtual_work_text(const VirtualWork& work, const Model& model, const Translator& tr)
{
    const Sentences said = sentences(work, model, tr);
    return said.title + "\n" + std::string(tabular::shown_width(said.title), '=') + "\n" + said.units + "\n" +
           said.unit_load + "\n" +
           work_text(work.work, {tr("under the loads, F"), tr("under the unit load, f"), said.unit_of_work}, model,
                     tr) +
           "\n" + said.analysis + "\n";
}

std::string virtual_work_latex(const VirtualWork& work, const Model& model, const Translator& tr)
{
    const Sentences said = sentences(work, model, tr);
    const WorkCaptions captions{tr("under the loads, F"), tr("under the unit load, f"), said.unit_of_work};
    const Tables tables(work.work, captions, model, tr);
    const auto line = [](const std::string& text) { return tabular::latex_text(text) + "\n"; };
    return "\\section*{" + tabular::latex_text(said.title) + "}\n" + line(said.units) + line(said.unit_load) +
           tables.latex() + "\n\\par\\medskip\\noindent\n$" + tabular::latex_formula(tables.addends()) + " = " +
           tabular::latex_formula(said.sum) + "$\n\\par\\noindent\n" + line(said.analysis);
}

} // namespace femoop::virtual_work
