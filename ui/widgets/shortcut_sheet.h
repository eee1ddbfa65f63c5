#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "ui/command/command_table.h"
#include "ui/text/catalogue.h"

namespace ui {

/// A line of the sheet of keys: a command, or with no key the menu that the next ones stand in.
struct KeyLine {
    std::string key, words;
};

/// Menus in the order of their first command; what stands in none comes first.
template <class Session>
std::vector<KeyLine> key_lines(const CommandTable<Session>& commands, const Session& session, const Catalogue& tr)
{
    std::vector<std::string_view> menus;
    for (const auto& command : commands.all())
        if (std::ranges::find(menus, command.menu) == menus.end()) menus.push_back(command.menu);
    std::vector<KeyLine> lines;
    for (const std::string_view menu : menus) {
        const std::size_t begin = lines.size();
        for (const auto& command : commands.all())
            if (command.menu == menu && !command.shortcuts.empty())
                lines.push_back({text(command.shortcuts.front()), label(command, session, tr)});
        const auto at = lines.begin() + static_cast<std::ptrdiff_t>(begin);
        if (lines.size() > begin && !menu.empty()) lines.insert(at, {"", tr(menu)});
    }
    return lines;
}

/// Every key and what it does, in columns over the picture, until it is closed.
void shortcut_sheet(const std::vector<KeyLine>& lines, const Catalogue& tr, bool& is_open);

} // namespace ui
