#include "apps/frame/document/named_sets.h"

#include <algorithm>
#include <stdexcept>
#include <type_traits>
#include <utility>

#include "apps/frame/document/document.h"
#include "apps/frame/document/loading.h"
#include "apps/frame/document/naming.h"
#include "apps/frame/document/overloaded.h"
#include "apps/frame/document/set_library.h"
#include "femoop/edit/load_change.h"
#include "femoop/model/quantity/in_units.h"
#include "ui/text/catalogue.h"

namespace frame {

using namespace femoop;
using ui::translatable;

namespace {

void drop_text(Quantity& number) { number = number.value(); }
void drop_text(std::vector<Component>& components)
{
    for (Component& component : components) drop_text(component.value);
}

MemberLoadValue bare(const MemberLoadValue& value)
{
    MemberLoad load{MemberId(0), value};
    change_places(load, [](Position& place) {
        if (auto* const length = std::get_if<Quantity>(&place)) drop_text(*length);
    });
    change_values(load, [](Dof, Quantity& number, LoadAxes) { drop_text(number); });
    if (auto* const rise = std::get_if<TemperatureLoad>(&load.load)) {
        drop_text(rise->top);
        drop_text(rise->bottom);
    }
    if (auto* const misfit = std::get_if<Misfit>(&load.load)) drop_text(misfit->elongation);
    return load.load;
}

/// The value by its numbers alone, however they were typed.
SetValue bare(const SetValue& value)
{
    return std::visit(Overloaded{[](Support support) -> SetValue {
                                     drop_text(support.angle);
                                     for (Spring& spring : support.springs) drop_text(spring.stiffness);
                                     return support;
                                 },
                                 [](std::vector<Component> forces) -> SetValue {
                                     drop_text(forces);
                                     return forces;
                                 },
                                 [](const MemberLoadValue& load) -> SetValue { return bare(load); }},
                      value);
}

/// Of the parts that can have a set of this kind, those that have it.
std::vector<Part> having(const Model& model, const SetValue& value)
{
    std::vector<Part> found;
    for (const Part& part : parts(model)) {
        const std::optional<SetValue> its = value_of(model, part);
        if (its && are_alike(*its, value)) found.push_back(part);
    }
    return found;
}

void put(Model& model, const Part& part, const SetValue& value)
{
    if (const auto* const node = std::get_if<NodeId>(&part))
        model.nodes[node->index].support = std::get<Support>(value);
    if (const auto* const load = std::get_if<NodeLoadPlace>(&part))
        model.load_cases[load->load_case].nodes[load->load].components = std::get<std::vector<Component>>(value);
    if (const auto* const load = std::get_if<MemberLoadPlace>(&part))
        model.load_cases[load->load_case].members[load->load].load = std::get<MemberLoadValue>(value);
}

bool bears(const Model& model, LoadCasePlace place, MemberId member, const MemberLoadValue& value)
{
    return std::ranges::any_of(model.load_cases[place.load_case].members, [&](const MemberLoad& load) {
        return load.member == member && bare(load.load) == bare(value);
    });
}

} // namespace

bool are_alike(const SetValue& a, const SetValue& b) { return bare(a) == bare(b); }

std::optional<SetValue> value_of(const Model& model, const Part& part)
{
    if (const auto* const node = std::get_if<NodeId>(&part)) {
        const std::optional<Support>& support = model[*node].support;
        return support ? std::optional<SetValue>(*support) : std::nullopt;
    }
    if (const auto* const load = std::get_if<NodeLoadPlace>(&part))
        return model.load_cases[load->load_case].nodes[load->load].components;
    if (const auto* const load = std::get_if<MemberLoadPlace>(&part))
        return model.load_cases[load->load_case].members[load->load].load;
    return std::nullopt;
}

std::optional<NamedSetPlace> set_of(const Document& document, const Part& part)
{
    const std::optional<SetValue> value = value_of(document.model, part);
    if (!value) return std::nullopt;
    const auto found = std::ranges::find_if(document.companion.sets,
                                            [&](const NamedSet& set) { return are_alike(set.value, *value); });
    if (found == document.companion.sets.end()) return std::nullopt;
    return NamedSetPlace{static_cast<std::size_t>(found - document.companion.sets.begin())};
}

std::vector<Part> users(const Document& document, NamedSetPlace set)
{
    return having(document.model, document.companion.sets.at(set.set).value);
}

bool suits(const SetValue& value, const Part& part)
{
    return std::holds_alternative<MemberLoadValue>(value) ? std::holds_alternative<MemberId>(part)
                                                          : std::holds_alternative<NodeId>(part);
}

NamedSetPlace keep(Document& document, const Part& part, const std::string& name)
{
    document.companion.sets.push_back(
        {fresh_name(document.companion.sets, &NamedSet::name, name), value_of(document.model, part).value()});
    return {document.companion.sets.size() - 1};
}

std::vector<Part> give(Document& document, NamedSetPlace set, std::span<const Part> parts, CaseId load_case)
{
    const SetValue value = document.companion.sets.at(set.set).value;
    for (const Part& part : parts)
        if (!has(document.model, part)) throw std::out_of_range("the document has no such part");
    std::vector<Part> loads;
    for (const Part& part : parts) {
        if (!suits(value, part)) continue;
        if (std::holds_alternative<Support>(value)) {
            put(document.model, part, value);
            continue;
        }
        const LoadCasePlace place = load_case_for(document, load_case);
        if (const auto* const forces = std::get_if<std::vector<Component>>(&value)) {
            for (const Component& force : *forces)
                loads.push_back(add_node_load(document, place, std::get<NodeId>(part), force));
            continue;
        }
        const auto member = std::get<MemberId>(part);
        const auto& load = std::get<MemberLoadValue>(value);
        if (!bears(document.model, place, member, load))
            loads.push_back(add_member_load(document, place, member, load));
    }
    return loads;
}

void assign(Document& document, NamedSetPlace set, const Part& part)
{
    put(document.model, part, document.companion.sets.at(set.set).value);
}

void replace(Document& document, NamedSetPlace set, const Part& part)
{
    SetValue& value = document.companion.sets.at(set.set).value;
    const SetValue wanted = value_of(document.model, part).value();
    if (wanted.index() != value.index()) throw std::out_of_range("the part is of another kind than the set");
    for (const Part& user : having(document.model, value)) put(document.model, user, wanted);
    value = wanted;
}

std::optional<ui::Message> why_not_rename(const Document& document, NamedSetPlace set, std::string_view name)
{
    return objection(document.companion.sets, &NamedSet::name, set.set, name);
}

void rename(Document& document, NamedSetPlace set, std::string name)
{
    document.companion.sets.at(set.set).name = std::move(name);
}

void erase(Document& document, NamedSetPlace set)
{
    (void)document.companion.sets.at(set.set);
    document.companion.sets.erase(document.companion.sets.begin() + static_cast<std::ptrdiff_t>(set.set));
}

Condensed condense_sets(Document& document)
{
    Condensed condensed;
    std::vector<NamedSet> kept;
    for (const NamedSet& set : document.companion.sets) {
        const bool is_there = std::ranges::any_of(kept, [&](const auto& k) { return are_alike(k.value, set.value); });
        if (is_there) ++condensed.n_equal;
        else if (having(document.model, set.value).empty()) ++condensed.n_unused;
        else kept.push_back(set);
    }
    document.companion.sets = std::move(kept);
    return condensed;
}

std::size_t import_sets(Document& document, const Document& other)
{
    const Model library = in_units(library_of(other.companion.sets, other.model), document.model.units);
    std::size_t n = 0;
    for (NamedSet& set : sets_in(library)) {
        const bool is_there = std::ranges::any_of(document.companion.sets,
                                                  [&](const auto& there) { return are_alike(there.value, set.value); });
        if (is_there || !is_usable(set, document.model)) continue;
        set.name = fresh_name(document.companion.sets, &NamedSet::name, set.name);
        document.companion.sets.push_back(std::move(set));
        ++n;
    }
    return n;
}

} // namespace frame
