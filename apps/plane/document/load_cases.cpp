#include "apps/plane/document/load_cases.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "apps/plane/document/erase.h"
#include "femoop/edit/naming.h"
#include "ui/text/catalogue.h"

namespace plane {

using femoop::CaseId;
using femoop::Combination;
using femoop::Quantity;
using ui::Message;
using ui::translatable;

namespace {

/// Of what comes behind the load cases when there is one more of them.
void count_on(CaseId& id, std::size_t n_load_cases)
{
    if (id.index >= n_load_cases) ++id.index;
}

template <class Terms> auto term_of(Terms& terms, CaseId of)
{
    return std::ranges::find(terms, of, &Combination::Term::of);
}

void set_factor(Combination& combination, CaseId of, const std::optional<Quantity>& factor)
{
    const auto term = term_of(combination.terms, of);
    if (!factor) std::erase_if(combination.terms, [&](const auto& each) { return each.of == of; });
    else if (term != combination.terms.end()) term->factor = factor->value();
    else combination.terms.push_back({of, factor->value()});
}

Number self_weight(const PlaneModel& model, std::size_t load_case)
{
    return {"self-weight",
            translatable("Factor of self-weight"),
            ui::Measure::Plain,
            Quantity(model.load_cases[load_case].self_weight),
            false,
            [load_case](Document& document, const std::optional<Quantity>& value) -> std::optional<Message> {
                if (!value) return Message(translatable("a value is needed here"));
                document.model.load_cases[load_case].self_weight = *value;
                return std::nullopt;
            }};
}

/// How often a case takes part in a combination.
Number factor(const PlaneModel& model, std::size_t combination, CaseId of)
{
    const auto& terms = model.combinations[combination].terms;
    const auto term = term_of(terms, of);
    const std::string name = model.case_name(of);
    return {"factor " + name,
            Message(translatable("Factor of {case}"), {{"case", name}}),
            ui::Measure::Plain,
            term != terms.end() ? std::optional(Quantity(term->factor)) : std::nullopt,
            true,
            [=](Document& document, const std::optional<Quantity>& value) -> std::optional<Message> {
                set_factor(document.model.combinations[combination], of, value);
                return std::nullopt;
            }};
}

} // namespace

std::string fresh_case_id(const PlaneModel& model, const std::string& wanted)
{
    return femoop::fresh_name(wanted, [&](const std::string& name) { return model.find_case(name).has_value(); });
}

CaseId add_load_case(Document& document)
{
    PlaneModel& model = document.model;
    const std::size_t n = model.load_cases.size();
    model.load_cases.push_back(
        {.id = fresh_case_id(model, "1"), .points = {}, .curves = {}, .regions = {}, .settlements = {}});
    for (Combination& combination : model.combinations)
        for (Combination::Term& term : combination.terms) count_on(term.of, n);
    for (auto& check : model.expected)
        if (check.load_case) count_on(*check.load_case, n);
    return CaseId(n);
}

CaseId add_combination(Document& document)
{
    PlaneModel& model = document.model;
    Combination combination{.id = fresh_case_id(model, "C"), .terms = {}};
    for (std::size_t i = 0; i < model.load_cases.size(); ++i) combination.terms.push_back({CaseId(i), 1.0});
    model.combinations.push_back(std::move(combination));
    return CaseId(model.n_cases() - 1);
}

void erase_case(Document& document, CaseId id)
{
    Erased erased;
    erased.cases.resize(document.model.n_cases());
    erased.cases.at(id.index) = true;
    erase_entries(document.model, erased);
}

std::vector<Number> numbers(const PlaneModel& model, CaseId id)
{
    const std::size_t n = model.load_cases.size();
    if (id.index < n) return {self_weight(model, id.index)};
    const std::size_t combination = id.index - n;
    std::vector<Number> all;
    for (std::size_t i = 0; i < n; ++i) all.push_back(factor(model, combination, CaseId(i)));
    for (const auto& term : model.combinations[combination].terms)
        if (term.of.index >= n) all.push_back(factor(model, combination, term.of));
    return all;
}

} // namespace plane
