#include "apps/frame/document/load_cases.h"

#include <stdexcept>
#include <utility>

#include "femoop/edit/insert.h"
#include "femoop/edit/naming.h"
#include "ui/text/catalogue.h"

namespace frame {

using namespace femoop;
using ui::Message;
using ui::translatable;

Part part_of(const Model& model, CaseId id)
{
    const std::size_t n = model.load_cases.size();
    if (id.index < n) return LoadCasePlace{id.index};
    return CombinationPlace{id.index - n};
}

std::optional<CaseId> case_id_of(const Model& model, const Part& part)
{
    if (const auto* const place = std::get_if<LoadCasePlace>(&part)) return CaseId(place->load_case);
    const auto* const place = std::get_if<CombinationPlace>(&part);
    return place != nullptr ? std::optional(CaseId(model.load_cases.size() + place->combination)) : std::nullopt;
}

CaseId add_load_case(Document& document)
{
    return insert_load_case(document.model, fresh_case_id(document.model, "1"));
}

CaseId add_combination(Document& document)
{
    Model& model = document.model;
    Combination combination{.id = fresh_case_id(model, "C"), .terms = {}};
    for (std::size_t i = 0; i < model.load_cases.size(); ++i) combination.terms.push_back({CaseId(i), 1.0});
    model.combinations.push_back(std::move(combination));
    return CaseId(model.n_cases() - 1);
}

CaseId copy_case(Document& document, CaseId id)
{
    Model& model = document.model;
    const std::string name = fresh_case_id(model, model.case_name(id));
    if (id.index < model.load_cases.size()) {
        LoadCase copy = model.load_cases[id.index];
        copy.id = name;
        const CaseId added = insert_load_case(model, name);
        model.load_cases[added.index] = std::move(copy);
        return added;
    }
    Combination copy = model.combinations.at(id.index - model.load_cases.size());
    copy.id = name;
    model.combinations.push_back(std::move(copy));
    return CaseId(model.n_cases() - 1);
}

std::optional<Message> why_not_rename(const Model& model, CaseId id, std::string_view name)
{
    if (name.find_first_not_of(' ') == std::string_view::npos) return Message(translatable("a name is wanted"));
    const std::optional<CaseId> other = model.find_case(name);
    if (!other || *other == id) return std::nullopt;
    return Message(translatable("there is another load case or combination named {name}"),
                   {{"name", std::string(name)}});
}

void rename(Document& document, CaseId id, std::string name)
{
    Model& model = document.model;
    if (id.index < model.load_cases.size()) model.load_cases[id.index].id = std::move(name);
    else model.combinations.at(id.index - model.load_cases.size()).id = std::move(name);
}

void set_self_weight(Document& document, LoadCasePlace place, double factor)
{
    document.model.load_cases.at(place.load_case).self_weight = factor;
}

} // namespace frame
