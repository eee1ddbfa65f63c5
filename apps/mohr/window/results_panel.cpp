#include "apps/mohr/window/results_panel.h"

#include <imgui.h>

#include <algorithm>
#include <string>

#include "apps/mohr/session/report.h"
#include "apps/mohr/view/axis.h"
#include "ui/widgets/number_grid.h"
#include "ui/widgets/wrapped_text.h"

namespace mohr {

namespace {

template <class Matrix>
void show_matrix(const Session& session, const char* id, const std::string& title, const Matrix& matrix)
{
    ui::NumberRows rows;
    for (const auto& row : matrix.rowwise()) {
        rows.emplace_back();
        for (const double value : row) rows.back().push_back(session.look.number(value));
    }
    ImGui::TextUnformatted(title.c_str());
    ui::number_grid(id, rows);
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

/// Dear ImGui lays a table out when it is new, and keeps that. Where values have become so long, or so large, since then
/// that one which would have room is broken, the table is taken for a new one; once, since that may not help.
class TableLayout {
public:
    explicit TableLayout(const std::string& id)
        : id_(id), number_(ImGui::GetStateStorage()->GetInt(key(".number"))), begun_(begun())
    {}

    std::string table() const { return id_ + "." + std::to_string(number_); }
    /// Called in a cell before its text, which should not be broken. \param room  of the row
    void note(const std::string& text, float room)
    {
        const float width = ImGui::CalcTextSize(text.c_str()).x;
        if (width > ImGui::GetContentRegionAvail().x + 1.0F && width < 0.6F * room)
            outgrown_ = std::max(outgrown_, width);
    }
    void end() const
    {
        constexpr int frames_to_settle = 3;
        const bool is_settled = ImGui::GetFrameCount() - begun_ >= frames_to_settle;
        if (outgrown_ == 0.0F || !is_settled || outgrown_ == ImGui::GetStateStorage()->GetFloat(key(".tried"))) return;
        ImGui::GetStateStorage()->SetFloat(key(".tried"), outgrown_);
        ImGui::GetStateStorage()->SetInt(key(".number"), number_ + 1);
        ImGui::GetStateStorage()->SetInt(key(".begun"), ImGui::GetFrameCount());
    }

private:
    ImGuiID key(const char* what) const { return ImGui::GetID((id_ + what).c_str()); }
    int begun() const ///< the frame
    {
        const int now = ImGui::GetFrameCount(), kept = ImGui::GetStateStorage()->GetInt(key(".begun"), now);
        ImGui::GetStateStorage()->SetInt(key(".begun"), kept);
        return kept;
    }

    std::string id_;
    int number_, begun_;
    float outgrown_ = 0.0F; ///< width of the longest text that is broken, 0 for none
};

/// \pre it has rows
void show_group(const tabular::Table& group, ui::ImGuiSession& gui)
{
    ImGui::Spacing();
    ImGui::Separator();
    ImGui::PushFont(gui.bold());
    ui::wrapped_text(group.title);
    ImGui::PopFont();
    const std::string id = "###" + group.rows.front().cells[0].shown; // the title turns with the axes, columns do not
    const float room = ImGui::GetContentRegionAvail().x;
    TableLayout layout(id);
    if (!ImGui::BeginTable(layout.table().c_str(), 2, ImGuiTableFlags_SizingStretchProp)) return;
    for (const auto& [cells, kind] : group.rows) {
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        ui::wrapped_text(cells[0].shown);
        ImGui::TableNextColumn();
        layout.note(cells[1].shown, room);
        ui::wrapped_text(cells[1].shown);
    }
    ImGui::EndTable();
    layout.end();
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
