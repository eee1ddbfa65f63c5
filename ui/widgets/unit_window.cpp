#include "ui/widgets/unit_window.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <string>
#include <utility>

namespace ui {

namespace {

// The first entry is the unit of the system.
void show_row(UnitChoices& choices, const DisplayUnits& units, const QuantityUnits& quantity, const Catalogue& tr)
{
    const std::string_view chosen = choices.of(quantity.measure);
    const std::string usual = tr("as the system has it") + ": " + units.unit_of_system(quantity.measure).name;
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(tr(quantity.label).c_str());
    ImGui::TableNextColumn();
    ImGui::SetNextItemWidth(14.0F * ImGui::GetFontSize());
    if (!ImGui::BeginCombo(("###" + std::string(quantity.code)).c_str(),
                           chosen.empty() ? usual.c_str() : std::string(chosen).c_str()))
        return;
    if (ImGui::Selectable((usual + "###usual").c_str(), chosen.empty())) choices.choose(quantity.code, "");
    for (const std::string_view name : quantity.names)
        if (ImGui::Selectable(std::string(name).c_str(), name == chosen)) choices.choose(quantity.code, name);
    ImGui::EndCombo();
}

} // namespace

bool UnitWindow::close() { return std::exchange(is_open_, false); }

bool UnitWindow::wants(Key key) const
{
    using enum Key;
    constexpr std::array own{Tab, Space, Enter, Up, Down, Left, Right};
    return is_open_ && has_keyboard_ && std::ranges::find(own, key) != own.end();
}

void UnitWindow::show(UnitChoices& choices, const DisplayUnits& units, const Catalogue& tr, TabStops& stops)
{
    has_keyboard_ = false;
    if (!is_open_) return;
    ImGui::SetNextWindowPos(ImGui::GetMainViewport()->GetCenter(), ImGuiCond_Appearing, {0.5F, 0.5F});
    ImGui::Begin((tr("Units, quantity by quantity") + "###units").c_str(), &is_open_,
                 ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoCollapse);
    stops.begin_window();
    if (ImGui::BeginTable("###quantities", 2, ImGuiTableFlags_SizingFixedFit)) {
        for (const QuantityUnits& quantity : chosen_quantities()) {
            show_row(choices, units, quantity, tr);
            stops.add();
        }
        ImGui::EndTable();
    }
    if (ImGui::Button((tr("All as the system has them") + "###all").c_str())) choices = UnitChoices();
    stops.add();
    stops.end_window();
    has_keyboard_ = ImGui::IsWindowFocused(ImGuiFocusedFlags_RootAndChildWindows);
    ImGui::End();
}

} // namespace ui
