#pragma once

#include <imgui.h>

#include <string>
#include <vector>

#include "apps/mohr/session/commands.h"
#include "ui/widgets/wrapped_text.h"

namespace mohr {

/// A list of commands of which one is on; choosing another runs it.
template <class Entries, class Chosen>
void choice(Workspace& workspace, const CommandTable& commands, const char* id, const Entries& entries,
            const Chosen& is_chosen)
{
    const ui::Catalogue tr = workspace.tr();
    std::string chosen;
    std::vector<std::string> names;
    for (const auto& entry : entries) {
        names.push_back(tr(entry.label));
        if (is_chosen(entry)) chosen = names.back();
    }
    if (!ui::begin_wrapped_combo(chosen, names, id)) return;
    for (const auto& entry : entries)
        if (ImGui::Selectable((tr(entry.label) + "###" + std::string(entry.id)).c_str(), is_chosen(entry)))
            run(*commands.find(entry.id), workspace);
    ImGui::EndCombo();
}

} // namespace mohr
