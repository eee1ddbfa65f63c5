#pragma once

#include <imgui.h>

#include <string>
#include <vector>

#include "ui/command/command_table.h"
#include "ui/text/catalogue.h"
#include "ui/widgets/wrapped_text.h"

namespace ui {

/// A list of commands of which one is on; choosing another runs it. \param entries  choices (ui/command/menu_builder.h)
template <class Workspace, class Entries, class Chosen>
void command_combo(Workspace& workspace, const CommandTable<Workspace>& commands, const char* id,
                   const Entries& entries, const Chosen& is_chosen)
{
    const Catalogue tr = workspace.tr();
    std::string chosen;
    std::vector<std::string> names;
    for (const auto& entry : entries) {
        names.push_back(tr(entry.label));
        if (is_chosen(entry)) chosen = names.back();
    }
    if (!begin_wrapped_combo(chosen, names, id)) return;
    for (const auto& entry : entries)
        if (ImGui::Selectable((tr(entry.label) + "###" + std::string(entry.id)).c_str(), is_chosen(entry)))
            run(*commands.find(entry.id), workspace);
    ImGui::EndCombo();
}

} // namespace ui
