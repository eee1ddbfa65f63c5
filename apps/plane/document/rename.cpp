#include "apps/plane/document/rename.h"

#include <type_traits>
#include <utility>

#include "ui/text/catalogue.h"

namespace plane {

namespace {

/// The list that an entry stands in.
template <class Model, class Use> decltype(auto) in_list(Model& model, const Named& entry, const Use& use)
{
    return std::visit(
        [&](auto id) -> decltype(auto) {
            using Id = decltype(id);
            if constexpr (std::is_same_v<Id, NodeId>) return use(model.points, id.index);
            else if constexpr (std::is_same_v<Id, CurveId>) return use(model.curves, id.index);
            else if constexpr (std::is_same_v<Id, RegionId>) return use(model.regions, id.index);
            else if constexpr (std::is_same_v<Id, MaterialId>) return use(model.materials, id.index);
            else if (id.index < model.load_cases.size()) return use(model.load_cases, id.index);
            else return use(model.combinations, id.index - model.load_cases.size());
        },
        entry);
}

/// Another entry of the list has the name; load cases and combinations share theirs.
bool is_taken(const PlaneModel& model, const Named& entry, std::string_view name)
{
    if (const auto* const id = std::get_if<femoop::CaseId>(&entry)) {
        const auto other = model.find_case(name);
        return other && *other != *id;
    }
    return in_list(model, entry, [&](const auto& list, std::size_t place) {
        for (std::size_t i = 0; i < list.size(); ++i)
            if (i != place && list[i].id == name) return true;
        return false;
    });
}

} // namespace

const std::string& name_of(const PlaneModel& model, const Named& entry)
{
    return in_list(model, entry, [](const auto& list, std::size_t i) -> const std::string& { return list.at(i).id; });
}

std::optional<ui::Message> why_not_named(const PlaneModel& model, const Named& entry, std::string_view name)
{
    if (name.find_first_not_of(' ') == std::string_view::npos) return ui::Message(ui::translatable("a name is wanted"));
    if (!is_taken(model, entry, name)) return std::nullopt;
    return ui::Message(ui::translatable("there is another one named {name}"), {{"name", std::string(name)}});
}

void rename(Document& document, const Named& entry, std::string name)
{
    in_list(document.model, entry, [&](auto& list, std::size_t i) { list.at(i).id = std::move(name); });
}

} // namespace plane
