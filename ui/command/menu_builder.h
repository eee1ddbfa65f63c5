#pragma once

#include <concepts>
#include <functional>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "ui/command/command_table.h"

namespace ui {

/// What a command is called by scenarios, by people and by the keyboard.
struct CommandName {
    std::string_view id;
    std::string_view label; ///< translatable
    std::vector<Chord> shortcuts{};
};

/// One of several values that a command each stands for.
template <class Value> struct Choice {
    Value value;
    std::string_view id, label;
    std::optional<Chord> shortcut{};
};

/// Adds the commands of one menu to a table, each in a line:
///
///     MenuBuilder<Workspace> menu(table, translatable("View"));
///     menu.step({"view.fit", translatable("Show everything"), {{Key::F, {}}}}, fit, why_not_fit);
///     menu.toggle({"view.grid", translatable("Grid")}, [](auto& workspace) -> auto& { return workspace.has_grid; });
///     menu.choices(themes, [](auto& workspace) -> auto& { return workspace.theme; });
///
/// A `why_not` says nothing where the command can run now, else why it cannot. What is returned is the row itself, for
/// what few rows have; it holds until the next command is added.
template <class Workspace> class MenuBuilder {
public:
    using Row = Command<Workspace>;
    using Run = std::function<void(Workspace&)>;
    using WhyNot = std::function<Reason(const Workspace&)>;

    MenuBuilder(CommandTable<Workspace>& table, std::string_view menu) : table_(table), menu_(menu) {}

    /// Something that is done.
    Row& step(CommandName name, Run run, WhyNot why_not = {})
    {
        return table_.add({.id = name.id,
                           .menu = menu_,
                           .label = name.label,
                           .shortcuts = std::move(name.shortcuts),
                           .run = std::move(run),
                           .why_not = std::move(why_not)});
    }

    /// Something that is on or off. \param place  the switch itself, of a workspace that may be const
    template <class Place> Row& toggle(CommandName name, Place place, WhyNot why_not = {})
    {
        return toggle(
            std::move(name), [place](const Workspace& workspace) { return place(workspace); },
            [place](Workspace& workspace, bool is_on) { place(workspace) = is_on; }, std::move(why_not));
    }

    /// The same where more than a switch changes. \param turn  gets whether it is to be on
    template <class IsOn, class Turn>
    requires std::invocable<Turn, Workspace&, bool> Row& toggle(CommandName name, IsOn is_on, Turn turn,
                                                                WhyNot why_not = {})
    {
        Row& row = step(
            std::move(name), [is_on, turn](Workspace& workspace) { turn(workspace, !is_on(std::as_const(workspace))); },
            std::move(why_not));
        row.is_on = is_on;
        return row;
    }

    /// A command for each switch. \param place  the switch of a choice's value: (workspace, value)
    template <class Choices, class Place> void toggles(const Choices& entries, Place place, WhyNot why_not = {})
    {
        for (const auto& entry : entries) {
            const auto own_place = [place, value = entry.value](auto& workspace) -> decltype(auto) {
                return place(workspace, value);
            };
            toggle(name_of(entry), own_place, why_not);
        }
    }

    /// The same where more than a switch changes. \param turn  gets a choice's value and whether it is to be on
    template <class Choices, class IsOn, class Turn>
    requires(!std::convertible_to<Turn, WhyNot>) void toggles(const Choices& entries, IsOn is_on, Turn turn,
                                                              WhyNot why_not = {})
    {
        for (const auto& entry : entries)
            toggle(
                name_of(entry),
                [is_on, value = entry.value](const Workspace& workspace) { return is_on(workspace, value); },
                [turn, value = entry.value](Workspace& workspace, bool on) { turn(workspace, value, on); }, why_not);
    }

    /// A command for each value, of which one is chosen. \param place  where the value is kept
    template <class Choices, class Place> void choices(const Choices& entries, Place place, WhyNot why_not = {})
    {
        choices(
            entries, [place](const Workspace& workspace) { return place(workspace); },
            [place](Workspace& workspace, const auto& value) { place(workspace) = value; }, why_not);
    }

    /// The same where more than a value changes. \param chosen  the value now \param choose  gets the new one
    template <class Choices, class Chosen, class Choose>
    requires(!std::convertible_to<Choose, WhyNot>) void choices(const Choices& entries, Chosen chosen, Choose choose,
                                                                WhyNot why_not = {})
    {
        for (const auto& entry : entries) choice(entry, chosen, choose, why_not);
    }

    template <class Entry, class Chosen, class Choose>
    Row& choice(const Entry& entry, Chosen chosen, Choose choose, WhyNot why_not = {})
    {
        const auto value = entry.value;
        Row& row = step(
            name_of(entry), [choose, value](Workspace& workspace) { choose(workspace, value); }, std::move(why_not));
        row.is_on = [chosen, value](const Workspace& workspace) { return chosen(workspace) == value; };
        return row;
    }

private:
    template <class Value> static CommandName name_of(const Choice<Value>& entry)
    {
        return {entry.id, entry.label, entry.shortcut ? std::vector{*entry.shortcut} : std::vector<Chord>{}};
    }

    CommandTable<Workspace>& table_;
    std::string_view menu_;
};

} // namespace ui
