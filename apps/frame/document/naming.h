#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "femoop/edit/naming.h"
#include "femoop/model/moving_load.h"
#include "ui/text/catalogue.h"
#include "ui/text/message.h"

namespace frame {

/// Why an entry of a list cannot have this name; nothing where it can. \param place of the entry in the list
template <class Entry>
std::optional<ui::Message> objection(const std::vector<Entry>& list, std::string Entry::*name_of, std::size_t place,
                                     std::string_view name)
{
    if (name.find_first_not_of(' ') == std::string_view::npos) return ui::Message(ui::translatable("a name is wanted"));
    for (std::size_t i = 0; i < list.size(); ++i)
        if (i != place && list[i].*name_of == name)
            return ui::Message(ui::translatable("there is another one named {name}"), {{"name", std::string(name)}});
    return std::nullopt;
}

/// The wanted name, counted on where an entry of the list has it (femoop/edit/naming.h).
template <class Entry>
std::string fresh_name(const std::vector<Entry>& list, std::string Entry::*name_of, const std::string& wanted)
{
    return femoop::fresh_name(
        wanted, [&](const std::string& name) { return std::ranges::find(list, name, name_of) != list.end(); });
}

/// A number counted up behind a standard's name would name another of its trains: "LM1 lane 1" is followed by
/// "LM1 lane 1 #2".
inline std::string fresh_train_name(const std::vector<femoop::Train>& trains, const std::string& wanted)
{
    const bool is_taken = std::ranges::find(trains, wanted, &femoop::Train::id) != trains.end();
    return is_taken ? fresh_name(trains, &femoop::Train::id, wanted + " #2") : wanted;
}

} // namespace frame
