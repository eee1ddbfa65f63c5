#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "apps/frame/tables/column.h"

namespace frame {

/// The names of the parts of a list. Whether each stands once is seen when all cells are written.
template <class Id, class Entries> Column name_column(ui::Message heading, Entries femoop::Model::*list)
{
    Column column{.heading = std::move(heading), .read = {}};
    column.read = [list](const femoop::Model& model, const Part& part) -> CellValue {
        return (model.*list)[std::get<Id>(part).index].id;
    };
    column.write = [list](Document& document, const Part& part, const CellText& entry) -> Refusal {
        if (entry.text.empty()) return value_needed(entry.manner);
        (document.model.*list)[std::get<Id>(part).index].id = std::string(entry.text);
        return std::nullopt;
    };
    return column;
}

/// The place of a name in a list, else the reason.
template <class Entries>
std::variant<std::size_t, std::string> place_of_name(const Entries& list, const CellText& entry)
{
    if (entry.text.empty()) return value_needed(entry.manner);
    const auto found = std::ranges::find(list, entry.text, [](const auto& part) { return std::string_view(part.id); });
    if (found != list.end()) return static_cast<std::size_t>(found - list.begin());
    if (list.empty())
        return entry.manner.tr("\"{text}\" is not there, and no other; add one first", {{"text", entry.text}});
    std::string names;
    constexpr std::size_t most = 12;
    for (std::size_t i = 0; i < list.size() && i < most; ++i) names += (i > 0 ? ", " : "") + list[i].id;
    if (list.size() > most) names += ", …";
    return entry.manner.tr("\"{text}\" is not there; choose from {names}", {{"text", entry.text}, {"names", names}});
}

} // namespace frame
