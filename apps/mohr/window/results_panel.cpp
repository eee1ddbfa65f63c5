#include "apps/mohr/window/results_panel.h"

#include <imgui.h>

#include <string>

#include "apps/mohr/session/report.h"
#include "apps/mohr/view/axis.h"
#include "ui/widgets/wrapped_text.h"

namespace mohr {

namespace {

/// Numbers in rows and columns between tall brackets.
template <class Matrix>
void show_matrix(const Session& session, const char* id, const std::string& title, const Matrix& matrix)
{
    ImGui::TextUnformatted(title.c_str());
    if (!ImGui::BeginTable(id, static_cast<int>(matrix.cols()),
                           ImGuiTableFlags_SizingStretchSame | ImGuiTableFlags_BordersInnerV))
        return;
    for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
        ImGui::TableNextRow();
        for (Eigen::Index j = 0; j < matrix.cols(); ++j) {
            ImGui::TableNextColumn();
            const std::string text = session.look.number(matrix(i, j));
            const float shift = ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(text.c_str()).x;
            if (shift > 0.0F) ImGui::SetCursorPosX(ImGui::GetCursorPosX() + shift);
            ImGui::TextUnformatted(text.c_str());
        }
    }
    ImGui::EndTable();
}

void show_tensor(const Session& session, ui::ImGuiSession& gui)
{
    const Solution& s = session.solution();
    const ui::Catalogue& tr = session.tr();
    ImGui::PushFont(gui.bold());
    ImGui::TextUnformatted(axis_title(tr("Tensor"), s.unit).c_str());
    ImGui::PopFont();
    if (is_in_space(session.document().subject)) {
        show_matrix(session, "###tensor", tr("in x, y, z"), femoop::mohr::tensor(*s.space));
        return;
    }
    show_matrix(session, "###tensor", tr("in x, y"), femoop::mohr::tensor(s.plane));
    show_matrix(session, "###turned", tr("in x′, y′"), femoop::mohr::tensor(s.turned));
}

/// \pre it has rows
void show_group(const tabular::Table& group, ui::ImGuiSession& gui)
{
    ImGui::Spacing();
    ImGui::Separator();
    ImGui::PushFont(gui.bold());
    ui::wrapped_text(group.title);
    ImGui::PopFont();
    const std::string id = "###" + group.rows.front().cells[0].shown; // the title turns with the axes, columns do not
    if (!ImGui::BeginTable(id.c_str(), 2, ImGuiTableFlags_SizingStretchProp)) return;
    for (const auto& [cells, kind] : group.rows) {
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        ui::wrapped_text(cells[0].shown);
        ImGui::TableNextColumn();
        ui::wrapped_text(cells[1].shown);
    }
    ImGui::EndTable();
}

} // namespace

void results_panel(const Session& session, ui::ImGuiSession& gui)
{
    for (const ui::Message& remark : remarks(session.document(), session.solution())) {
        ui::wrapped_text(session.tr()(remark));
        ImGui::Separator();
    }
    show_tensor(session, gui);
    for (const tabular::Table& group : result_tables(session)) show_group(group, gui);
}

} // namespace mohr
