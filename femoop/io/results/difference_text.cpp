#include "femoop/io/results/difference_text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>
#include <vector>

#include "femoop/geometry/member_geometry.h"
#include "femoop/model/quantity/in_units.h"
#include "femoop/model/quantity/number_text.h"
#include "femoop/model/quantity/six_digits.h"
#include "femoop/result/components.h"
#include "femoop/tabular/plain_text.h"

namespace femoop {

namespace {

constexpr std::array compared_quantities{ComparedQuantity::SectionForce, ComparedQuantity::Reaction,
                                         ComparedQuantity::Displacement};

/// "M", "fy", "ux".
std::string component_word(const Difference& one, AnalysisKind analysis)
{
    if (const auto* const component = std::get_if<MemberComponent>(&one.component))
        return std::string(name(*component, analysis));
    const Dof dof = std::get<Dof>(one.component);
    return std::string(one.quantity == ComparedQuantity::Reaction ? force_name(dof) : name(dof));
}

/// Where two differences have one, their numbers are of one kind.
std::size_t kind_of(const Difference& one)
{
    return std::visit([](auto component) { return static_cast<std::size_t>(component); }, one.component);
}

const PrintedUnit& unit_of(const Difference& one, const ResultUnits& units)
{
    if (const auto* const component = std::get_if<MemberComponent>(&one.component)) return units.of(*component);
    const Dof dof = std::get<Dof>(one.component);
    return one.quantity == ComparedQuantity::Reaction ? units.of_force(dof) : units.of_displacement(dof);
}

const std::string& part_name(const Difference& one, const Model& model)
{
    return std::visit([&](auto id) -> const std::string& { return model[id].id; }, one.part);
}

std::optional<double> section_place(const Difference& one, const Model& model)
{
    const auto* const member = std::get_if<MemberId>(&one.part);
    if (member == nullptr || !one.share) return std::nullopt;
    return *one.share * geometry_of(model, model[*member]).length;
}

bool is_silent(const Difference& one) { return one.now == 0.0 && one.then.value_or(0.0) == 0.0; }

/// Those of one kind, in the order of the model; of trusses without span loads no V and no M.
std::vector<Difference> differences_of(ComparedQuantity quantity, const Differences& all, const Model& model)
{
    std::vector<Difference> found;
    bool is_bent = false;
    for (std::size_t i = 0; i < all.size(); ++i) {
        Difference one = all[i];
        if (one.quantity != quantity) continue;
        const auto* const component = std::get_if<MemberComponent>(&one.component);
        is_bent = is_bent || (component != nullptr && *component != MemberComponent::N && !is_silent(one));
        found.push_back(std::move(one));
    }
    if (quantity == ComparedQuantity::SectionForce && is_truss(model.analysis) && !is_bent)
        std::erase_if(
            found, [](const Difference& one) { return one.component != decltype(one.component){MemberComponent::N}; });
    return found;
}

tabular::Cell number_or_nothing(const std::optional<double>& value, const PrintedUnit& unit)
{
    return value ? tabular::Cell(*value * unit.factor) : tabular::Cell();
}

std::string heading(ComparedQuantity quantity, const Translator& tr)
{
    switch (quantity) {
    case ComparedQuantity::SectionForce: return tr("Section forces, each where it differs most");
    case ComparedQuantity::Reaction: return tr("Reactions of the supports on the structure");
    case ComparedQuantity::Displacement: break;
    }
    return tr("Displacements of the nodes");
}

tabular::Table difference_table(ComparedQuantity quantity, const std::vector<Difference>& all, const Model& model,
                                const ResultUnits& units, const Translator& tr)
{
    const bool is_along = quantity == ComparedQuantity::SectionForce;
    std::vector<tabular::Column> headers{is_along ? tr("member") : tr("node"), ""};
    if (is_along) headers.emplace_back(tr("at x"), units.length.name);
    for (const std::string& header : {tr("now"), tr("before"), tr("change")}) headers.emplace_back(header);
    tabular::Table table(headers);
    std::string before;
    for (const Difference& one : all) {
        const std::string& part = part_name(one, model);
        const PrintedUnit& unit = unit_of(one, units);
        std::vector<tabular::Cell> row{part == before ? std::string() : part,
                                       component_word(one, model.analysis) + " [" + unit.name + "]"};
        if (is_along) row.push_back(number_or_nothing(section_place(one, model), units.length));
        for (const std::optional<double>& value : {std::optional(one.now), one.then, one.change()})
            row.push_back(number_or_nothing(value, unit));
        table.add_row(std::move(row), kind_of(one));
        before = part;
    }
    return table;
}

/// What one structure has and the other has not, by name.
struct Missing {
    std::vector<std::string> nodes, members, supports;
};

Missing missing(const ComparedCase& there, const ComparedCase& here)
{
    Missing found;
    for (std::size_t i = 0; i < there.model->nodes.size(); ++i) {
        const std::string& id = there.model->nodes[i].id;
        const auto twin = here.model->find_node(id);
        if (!twin) found.nodes.push_back(id);
        else if (there.result.is_supported(NodeId(i)) && !here.result.is_supported(*twin)) found.supports.push_back(id);
    }
    for (const Member& member : there.model->members)
        if (!here.model->find_member(member.id)) found.members.push_back(member.id);
    return found;
}

using NamedParts = std::pair<std::string, const std::vector<std::string>*>;

std::string missing_text(const std::string& title, const Missing& parts, const Translator& tr)
{
    std::string text;
    for (const auto& [what, names] : {NamedParts{tr("nodes"), &parts.nodes}, NamedParts{tr("members"), &parts.members},
                                      NamedParts{tr("supports at"), &parts.supports}}) {
        if (names->empty()) continue;
        text += (text.empty() ? "" : "; ") + what + ' ';
        for (const std::string& name : *names) text += (&name == &names->front() ? "" : ", ") + name;
    }
    return text.empty() ? text : title + ": " + text + "\n";
}

std::string text_in_unit(double value, const PrintedUnit& unit, const Translator& tr)
{
    return six_digits(value * unit.factor, tr) + " " + unit.name;
}

std::string change_sentence(const Difference& one, const Model& model, const ResultUnits& units, const Translator& tr)
{
    const PrintedUnit& unit = unit_of(one, units);
    const std::string word = component_word(one, model.analysis), &part = part_name(one, model);
    const std::string now = text_in_unit(one.now, unit, tr), then = text_in_unit(*one.then, unit, tr);
    const std::string change = text_in_unit(*one.change(), unit, tr);
    if (const auto x = section_place(one, model))
        return fill(tr("{0} changes most in member {1} at x = {2}: {3} now, {4} before, change {5}"),
                    {word, part, text_in_unit(*x, units.length, tr), now, then, change});
    return fill(tr("{0} changes most at node {1}: {2} now, {3} before, change {4}"), {word, part, now, then, change});
}

/// Of each component, in the order in which they come.
std::vector<Difference> greatest_changes(const std::vector<Difference>& all)
{
    std::vector<Difference> most;
    for (const Difference& one : all) {
        if (!one.change()) continue;
        const auto known = std::ranges::find(most, one.component, &Difference::component);
        if (known == most.end()) most.push_back(one);
        else if (std::abs(*one.change()) > std::abs(*known->change())) *known = one;
    }
    return most;
}

void write_difference(JsonWriter& json, const Difference& one, const Model& model)
{
    const bool is_along = one.quantity == ComparedQuantity::SectionForce;
    json.begin_object().member(is_along ? "member" : "node", part_name(one, model));
    json.member("component", component_word(one, model.analysis));
    if (const auto x = section_place(one, model)) json.member("x", *x);
    json.member("now", one.now);
    if (one.then) json.member("before", *one.then).member("change", *one.change());
    json.end();
}

void write_missing(JsonWriter& json, std::string_view key, const Missing& parts)
{
    json.key(key).begin_object();
    for (const auto& [what, names] : {NamedParts{"nodes", &parts.nodes}, NamedParts{"members", &parts.members},
                                      NamedParts{"supports", &parts.supports}}) {
        json.key(what).begin_array();
        for (const std::string& name : *names) json.value(name);
        json.end();
    }
    json.end();
}

std::string_view key_of(ComparedQuantity quantity)
{
    switch (quantity) {
    case ComparedQuantity::SectionForce: return "section_forces";
    case ComparedQuantity::Reaction: return "reactions";
    case ComparedQuantity::Displacement: break;
    }
    return "displacements";
}

} // namespace

Model comparable(Model model, const Units& units)
{
    if (model.units == units) return model;
    model.extra.clear();
    return in_units(model, units);
}

std::string differences_text(const ComparedCase& now, const ComparedCase& before, const ResultUnits& units,
                             const Translator& tr)
{
    const Model& model = *now.model;
    const Differences all(now, before);
    std::string text;
    for (const ComparedQuantity quantity : compared_quantities) {
        const tabular::Table table = difference_table(quantity, differences_of(quantity, all, model), model, units, tr);
        if (table.is_empty()) continue;
        text += "\n" + heading(quantity, tr) + "\n" + tabular::plain_text(table, {2, decimal_mark(tr)});
    }
    const std::string lost = missing_text(tr("Only now"), missing(now, before), tr) +
                             missing_text(tr("Only before"), missing(before, now), tr);
    return lost.empty() ? text : text + "\n" + lost;
}

std::string differences_sentences(const ComparedCase& now, const ComparedCase& before, const ResultUnits& units,
                                  const Translator& tr)
{
    const Differences all(now, before);
    std::string text, same;
    for (const ComparedQuantity quantity : compared_quantities)
        for (const Difference& one : greatest_changes(differences_of(quantity, all, *now.model))) {
            if (*one.change() != 0.0) text += change_sentence(one, *now.model, units, tr) + ".\n";
            else same += (same.empty() ? "" : ", ") + component_word(one, now.model->analysis);
        }
    if (!same.empty()) text += tr("No change") + ": " + same + ".\n";
    return text + missing_text(tr("Only now"), missing(now, before), tr) +
           missing_text(tr("Only before"), missing(before, now), tr);
}

void write_differences(JsonWriter& json, const ComparedCase& now, const ComparedCase& before)
{
    const Differences all(now, before);
    for (const ComparedQuantity quantity : compared_quantities) {
        json.key(key_of(quantity)).begin_array(JsonWriter::Layout::Block);
        for (const Difference& one : differences_of(quantity, all, *now.model)) write_difference(json, one, *now.model);
        json.end();
    }
    write_missing(json, "only_now", missing(now, before));
    write_missing(json, "only_before", missing(before, now));
}

} // namespace femoop
