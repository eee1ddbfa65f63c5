#include "apps/euler/window/entity_panel.h"

#include <imgui.h>

#include <string>

#include "apps/euler/window/canvas.h"
#include "topology/tables/pointer_graph.h"

namespace euler {

namespace {

bool is_to_be_mended(const Session& session)
{
    return session.game() && !session.game()->is_over() &&
           std::holds_alternative<BrokenPointer>(session.game()->task());
}

} // namespace

void entity_panel(Session& session)
{
    if (!session.selection || session.selection->subject >= session.after().size()) return;
    if (is_to_be_mended(session)) return; // its pointers would tell which is wrong
    const Part part = *session.selection;
    const topology::Solid& solid = session.after()[part.subject].solid;
    if (!lives(solid, part.entity)) return;
    ImGui::Separator();
    ImGui::TextUnformatted(describe(session, part).c_str());
    if (!ImGui::BeginTable("pointers", 2, ImGuiTableFlags_RowBg)) return;
    ImGui::TableSetupColumn("link", ImGuiTableColumnFlags_WidthFixed, 7.0F * ImGui::GetFontSize());
    ImGui::TableSetupColumn("entity", ImGuiTableColumnFlags_WidthStretch);
    int row = 0;
    for (const topology::Pointer& pointer : topology::pointers(solid, part.entity)) {
        ImGui::TableNextColumn();
        ImGui::TextDisabled("%s", std::string(pointer.label).c_str());
        ImGui::TableNextColumn();
        const Part to{part.subject, pointer.to};
        if (ImGui::Selectable((describe(session, to) + "###" + std::to_string(row++)).c_str())) session.selection = to;
        if (ImGui::IsItemHovered()) session.hover = to;
    }
    ImGui::EndTable();
}

} // namespace euler
