#include "femoop/io/virtual_work/virtual_work_text.h"

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <vector>

#include "femoop/geometry/member_geometry.h"
#include "femoop/methods/influence/effect_name.h"
#include "femoop/model/fault/fault.h"
#include "femoop/model/quantity/number_text.h"
#include "femoop/model/quantity/six_digits.h"
#include "femoop/model/quantity/unit_signs.h"
#include "femoop/result/expression.h"
#include "femoop/result/magnitudes.h"
#include "femoop/tabular/plain_text.h"

namespace femoop::virtual_work {

namespace {

constexpr std::size_t indent = 2;
constexpr int formula_digits = 6;

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

    std::string all() const { return integrals() + joints() + supports(); }

private:
    std::string force_name(const std::optional<MemberComponent>& force) const
    {
        return force ? std::string(name(*force, model_.analysis)) : "p";
    }
    std::string length_unit() const { return unit_text(dimension::length, model_.units); }
    std::string value_text(double value) const { return six_digits(without_rounding(value, size_), tr_); }
    std::string shown(const tabular::Table& table) const
    {
        return tabular::plain_text(table, {indent, decimal_mark(tr_)});
    }

    std::string formula(const Polynomial& p, const WorkIntegral& on) const
    {
        const double length = geometry_of(model_, model_[on.member]).length;
        return localized(femoop::text(expression(p, on.from, on.to, length), formula_digits), tr_);
    }

    std::string stiffness(const WorkIntegral& on) const
    {
        if (on.flexibility == 0.0) return tr_("rigid");
        Polynomial varying;
        for (std::size_t i = 0; i < on.stiffness.n_terms(); ++i) varying.append(on.stiffness[i] / on.flexibility);
        const bool is_tapered = on.stiffness.n_terms() > 1;
        return std::string(stiffness_name(on.force)) + " = " +
               (is_tapered ? formula(varying, on) : six_digits(1.0 / on.flexibility, tr_));
    }

    std::string integrals() const
    {
        const auto& all = of_.integrals;
        if (all.empty()) return {};
        const bool is_strained = std::ranges::any_of(all, [](const WorkIntegral& one) { return one.strain != 0.0; });
        std::vector<tabular::Column> columns{tr_("member"),
                                             "F",
                                             {tr_("from"), length_unit()},
                                             {tr_("to"), length_unit()},
                                             captions_.real + "(x)",
                                             captions_.unit + "(x)",
                                             tr_("stiffness")};
        if (is_strained) columns.emplace_back(tr_("imposed strain ε"), "", tabular::Alignment::Right);
        columns.emplace_back(tr_("work"), captions_.unit_of_work, tabular::Alignment::Right);
        tabular::Table table(std::move(columns));
        for (const WorkIntegral& one : all) {
            std::vector<tabular::Cell> cells{model_[one.member].id,  force_name(one.force),  one.from,      one.to,
                                             formula(one.real, one), formula(one.unit, one), stiffness(one)};
            if (is_strained) cells.emplace_back(six_digits(one.strain, tr_));
            cells.emplace_back(value_text(one.value));
            table.add_row(std::move(cells));
        }
        return "\n" +
               (is_strained
                    ? tr_("Members: the integral of f (F / stiffness + ε) over x, the distance from the first "
                          "node.")
                    : tr_("Members: the integral of F f / stiffness over x, the distance from the first node.")) +
               "\n" + shown(table);
    }

    std::string joints() const
    {
        if (of_.joints.empty()) return {};
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
        return "\n" + tr_("Springs at the ends of members: F f / stiffness.") + "\n" + shown(table);
    }

    std::string supports() const
    {
        if (of_.supports.empty()) return {};
        tabular::Table table({tr_("node"),
                              tr_("direction"),
                              {tr_("displacement c"), "", tabular::Alignment::Right},
                              {tr_("reaction r to the unit load"), "", tabular::Alignment::Right},
                              {tr_("work"), captions_.unit_of_work, tabular::Alignment::Right}});
        for (const SupportWork& one : of_.supports)
            table.add_row({model_[one.node].id, std::string(name(one.dof)), six_digits(one.displacement, tr_),
                           six_digits(one.reaction, tr_), value_text(one.value)});
        return "\n" + tr_("Supports that move, by springs or settlements: -r c.") + "\n" + shown(table);
    }

    const Work& of_;
    const WorkCaptions& captions_;
    const Model& model_;
    const Translator& tr_;
    double size_ = 0.0; ///< of the largest work
};

} // namespace

std::string work_text(const Work& work, const WorkCaptions& captions, const Model& model, const Translator& tr)
{
    return Tables(work, captions, model, tr).all();
}

std::string virtual_work_text(const VirtualWork& work, const Model& model, const Translator& tr)
{
    const std::string unit = printed_unit(influence::dimension_of(work.displacement), model.units);
    const double size = size_of(work.work);
    const auto value = [&](double number) { return six_digits(without_rounding(number, size), tr); };
    const std::string title = fill(tr("{0} = {1} in {2}: by virtual work"),
                                   {influence::effect_name(model, work.displacement), value(work.value) + " " + unit,
                                    model.case_name(work.load_case)});
    return title + "\n" + std::string(tabular::shown_width(title), '=') + "\n" +
           fill(tr("Lengths in {0}, forces in {1}, rotations in rad."),
                {std::string(name(model.units.length)), std::string(name(model.units.force))}) +
           "\n" +
           tr("A unit load stands where the displacement is asked for, and along it. Its forces work on what the loads "
              "strain: the displacement is the sum of that work.") +
           "\n" + work_text(work.work, {tr("under the loads, F"), tr("under the unit load, f"), unit}, model, tr) +
           "\n" + fill(tr("Sum: {0} {1}; the analysis has {2}."), {value(work.sum), unit, value(work.value)}) + "\n";
}

} // namespace femoop::virtual_work
