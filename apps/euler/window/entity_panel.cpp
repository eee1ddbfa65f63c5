#include "apps/euler/window/entity_panel.h"

#include <imgui.h>

#include <string>

#include "apps/euler/view/pointers/pointer_drawing.h"
#include "apps/euler/window/canvas.h"
#include "topology/tables/pointer_graph.h"
#include "ui/text/shortened.h"
#include "ui/widgets/item_label.h"
#include "ui/widgets/wrapped_text.h"

namespace euler {

namespace {

constexpr std::size_t most_letters = 200; // of a row

bool is_to_be_mended(const Session& session)
{
    return session.game() && !session.game()->is_over() &&
           std::holds_alternative<CorruptedPointer>(session.game()->task());
}

// A click on a box selects its entity.
void pointer_picture(Session& session, const Part& part, ui::ImGuiSession& gui, const ui::Fonts& fonts)
{
    const auto scale = static_cast<float>(gui.scale());
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const ImVec2 room{ImGui::GetContentRegionAvail().x, 13.0F * ImGui::GetFontSize()};
    if (room.x < 8.0F) return;
    const Snapshot& in = session.after()[part.subject];
    const ui::Size sheet{static_cast<double>(room.x / scale), static_cast<double>(room.y / scale)};
    topology::PointerGraph graph = topology::pointer_graph(*in.solid, part.entity);
    graph.pointers = topology::pointers(*in.solid, part.entity); // those of the others would crowd so small a sheet
    const PointerDrawing drawing(graph, {in.solid.get(), in.names.get(), {}}, session.look, sheet, fonts);
    ui::Painter painter(sheet, fonts);
    drawing.draw(painter);
    gui.show(painter.picture(), *ImGui::GetWindowDrawList(),
             {static_cast<double>(corner.x), static_cast<double>(corner.y)});
    const bool is_clicked = ImGui::InvisibleButton("###pointer picture", room);
    if (!ImGui::IsItemHovered()) return;
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const auto under = drawing.pick(
        {static_cast<double>((mouse.x - corner.x) / scale), static_cast<double>((mouse.y - corner.y) / scale)});
    if (!under) return;
    session.hover = Part{part.subject, *under};
    if (is_clicked) session.selection = session.hover;
}

} // namespace

void entity_panel(Session& session, ui::ImGuiSession& gui, const ui::Fonts& fonts)
{
    if (!session.selection || session.selection->subject >= session.after().size()) return;
    if (is_to_be_mended(session)) return; // its pointers would tell which is wrong
    const Part part = *session.selection;
    const topology::Solid& solid = *session.after()[part.subject].solid;
    if (!lives(solid, part.entity)) return;
    ImGui::Separator();
    ui::wrapped_text(describe(session, part));
    pointer_picture(session, part, gui, fonts);
    if (!ImGui::BeginTable("pointers", 2, ImGuiTableFlags_RowBg)) return;
    ImGui::TableSetupColumn("link", ImGuiTableColumnFlags_WidthFixed, 7.0F * ImGui::GetFontSize());
    ImGui::TableSetupColumn("entity", ImGuiTableColumnFlags_WidthStretch);
    int row = 0;
    for (const topology::Pointer& pointer : topology::pointers(solid, part.entity)) {
        ImGui::TableNextColumn();
        ImGui::TextDisabled("%s", link_name(pointer.label, session.tr()).c_str());
        ImGui::TableNextColumn();
        const Part to{part.subject, pointer.to};
        const std::string words = ui::shortened(describe(session, to), most_letters);
        if (ImGui::Selectable(ui::item_label(words, std::to_string(row++)).c_str())) session.selection = to;
        if (ImGui::IsItemHovered()) session.hover = to;
    }
    ImGui::EndTable();
}

} // namespace euler
