#pragma once

#include <algorithm>
#include <compare>
#include <cstddef>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "ui/command/argument.h"
#include "ui/command/chord.h"
#include "ui/command/match.h"
#include "ui/text/catalogue.h"

namespace ui {

/// What an app can do, by name. `Session` is the app's state, which the functions get when they are called.
template <class Session> struct Command {
    std::string_view id;            ///< of scenarios and tests, stable: "view.fit"
    std::string_view menu{};        ///< translatable title of the menu that it stands in; empty: in no menu
    std::string_view label{};       ///< translatable, a verb: "Undo"
    std::vector<Chord> shortcuts{}; ///< the first is shown
    std::function<void(Session&)> run;
    /// Nothing if it can run now, else why not, as a sentence.
    std::function<Reason(const Session&)> why_not{};
    /// Given for what can be on or off, such as a layer of the picture.
    std::function<bool(const Session&)> is_on{};
    /// A label that depends on the state ("Undo Move node B"); `label` when absent.
    std::function<Message(const Session&)> live_label{};
};

template <class Session> std::string label(const Command<Session>& command, const Session& session, const Catalogue& tr)
{
    return command.live_label ? tr(command.live_label(session)) : tr(command.label);
}

template <class Session> Reason why_not(const Command<Session>& command, const Session& session)
{
    return command.why_not ? command.why_not(session) : std::nullopt;
}

/// Runs it if it can run now; else says why not and changes nothing.
template <class Session> Reason run(const Command<Session>& command, Session& session)
{
    Reason reason = why_not(command, session);
    if (!reason) command.run(session);
    return reason;
}

/// The one table that makes the menus, the palette, the shortcut list and the scripted tests.
template <class Session> class CommandTable {
public:
    using Entry = Command<Session>;

    /// \returns the row, until the next one is added. \throws std::logic_error for an id or a shortcut that another
    /// command has.
    Entry& add(Entry command)
    {
        if (find(command.id) != nullptr) throw std::logic_error("two commands named " + std::string(command.id));
        for (const Chord chord : command.shortcuts) {
            if (find(chord) != nullptr) throw std::logic_error("two commands on " + text(chord));
        }
        return commands_.emplace_back(std::move(command));
    }

    /// What scenarios do with an argument: `file.open portal.json`. The command of that name, where there is one, says
    /// whether it can run now; else it is a command of scenarios alone.
    using RunWith = std::function<Reason(Session&, const Argument&)>; ///< returns why it cannot
    void with_argument(std::string_view id, RunWith run) { with_argument_.emplace_back(id, std::move(run)); }

    const std::vector<Entry>& all() const { return commands_; }

    /// Null where there is none.
    const Entry* find(std::string_view id) const
    {
        return first([&](const Entry& command) { return command.id == id; });
    }
    const Entry* find(Chord chord) const
    {
        return first([&](const Entry& command) { return std::ranges::count(command.shortcuts, chord) > 0; });
    }

    /// Null where the command takes no argument.
    const RunWith* find_with_argument(std::string_view id) const
    {
        const auto found = std::ranges::find(with_argument_, id, &std::pair<std::string_view, RunWith>::first);
        return found == with_argument_.end() ? nullptr : &found->second;
    }

    /// Those whose label, in the catalogue's language or in English, goes with what was typed, the best first; of equal
    /// ones those that can run, and of these those of the fewest words. Where a label has the words themselves, those
    /// with mere letters of them are left out.
    std::vector<const Entry*> matching(std::string_view typed, const Session& session, const Catalogue& tr) const
    {
        std::vector<std::pair<Merit, const Entry*>> ranked;
        for (const Entry& command : commands_) {
            const std::optional<int> rank = best_rank(typed, command, session, tr);
            if (!rank) continue;
            Merit merit{*rank};
            if (!typed.empty())
                merit = {*rank, ui::why_not(command, session).has_value(),
                         std::ranges::count(ui::label(command, session, tr), ' ')};
            ranked.emplace_back(merit, &command);
        }
        std::ranges::stable_sort(ranked, {}, [](const auto& pair) { return pair.first; });
        std::vector<const Entry*> found;
        for (const auto& [merit, command] : ranked) {
            if (merit.rank > worst_rank_of_words && ranked.front().first.rank <= worst_rank_of_words) break;
            found.push_back(command);
        }
        return found;
    }

private:
    /// The least is the best.
    struct Merit {
        int rank;
        bool is_refused = false;
        std::ptrdiff_t n_blanks = 0; ///< in the label
        auto operator<=>(const Merit&) const = default;
    };

    static std::optional<int> best_rank(std::string_view typed, const Entry& command, const Session& session,
                                        const Catalogue& tr)
    {
        std::optional<int> best;
        for (const Catalogue& words : {tr, Catalogue()}) {
            const std::string label = ui::label(command, session, words);
            for (const std::string& name : {label, words(command.menu) + ' ' + label}) {
                const std::optional<int> rank = match_rank(typed, name);
                if (rank && (!best || *rank < *best)) best = rank;
            }
        }
        return best;
    }

    template <class Predicate> const Entry* first(Predicate&& predicate) const
    {
        const auto found = std::ranges::find_if(commands_, predicate);
        return found == commands_.end() ? nullptr : &*found;
    }

    std::vector<Entry> commands_;
    std::vector<std::pair<std::string_view, RunWith>> with_argument_;
};

/// Runs the command of that name as a scenario asks for it, with an argument or (empty) without. \returns what hinders
/// it, in English
template <class Session>
std::optional<std::string> run_by_name(const CommandTable<Session>& table, const Argument& argument, Session& session)
{
    const auto* const command = table.find(argument.id);
    const auto* const with_argument = table.find_with_argument(argument.id);
    const bool takes_argument = with_argument != nullptr && (command == nullptr || !argument.text.empty());
    if (command == nullptr && !takes_argument)
        return "found command \"" + std::string(argument.id) +
               "\", wanted one of the app's; the palette (Ctrl+K) lists them";
    if (!takes_argument && !argument.text.empty()) return Catalogue()(argument.wanted("no argument"));
    Reason reason = command != nullptr ? why_not(*command, session) : std::nullopt;
    if (!reason && takes_argument) reason = (*with_argument)(session, argument);
    else if (!reason) command->run(session);
    return reason ? std::optional(Catalogue()(*reason)) : std::nullopt;
}

} // namespace ui
