#include "apps/frame/window/results_panel.h"

#include <imgui.h>

#include <array>
#include <string>
#include <vector>

#include "apps/frame/session/readout.h"
#include "apps/frame/view/results/mechanism_picture.h"
#include "femoop/result/results.h"

namespace frame {

using namespace femoop;
using ui::Measure;
using ui::translatable;

namespace {

std::vector<Dof> dofs_of(AnalysisKind kind)
{
    std::vector<Dof> list;
    for (const Dof dof : all_dofs) {
        if (dofs(kind).contains(dof)) list.push_back(dof);
    }
    return list;
}

void right_aligned(const std::string& text)
{
    const float room = ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(text.c_str()).x;
    if (room > 0.0F) ImGui::SetCursorPosX(ImGui::GetCursorPosX() + room);
    ImGui::TextUnformatted(text.c_str());
}

// A table whose first column names a part. Calls row(i) for the rows that are in sight.
template <class Row> void table(const char* id, const std::vector<std::string>& headings, std::size_t n_rows, Row&& row)
{
    constexpr ImGuiTableFlags flags = ImGuiTableFlags_RowBg | ImGuiTableFlags_BordersInnerH | ImGuiTableFlags_ScrollY |
                                      ImGuiTableFlags_SizingStretchSame;
    const float line = ImGui::GetTextLineHeightWithSpacing() + 2.0F * ImGui::GetStyle().CellPadding.y;
    const float height = std::min(static_cast<float>(n_rows + 1) * line + 2.0F, 12.0F * line);
    if (!ImGui::BeginTable(id, static_cast<int>(headings.size()), flags, {0.0F, height})) return;
    ImGui::TableSetupScrollFreeze(1, 1);
    for (const std::string& heading : headings) ImGui::TableSetupColumn(heading.c_str());
    ImGui::TableHeadersRow();
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(n_rows));
    while (clipper.Step()) {
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
            ImGui::TableNextRow();
            ImGui::TableNextColumn();
            ImGui::PushID(i);
            row(static_cast<std::size_t>(i));
            ImGui::PopID();
        }
    }
    ImGui::EndTable();
}

void part_cell(Session& session, const Part& part, const std::string& name)
{
    const bool is_selected = session.selection == part;
    if (ImGui::Selectable(name.c_str(), is_selected, ImGuiSelectableFlags_SpanAllColumns)) session.selection = part;
}

void number_cell(const std::string& text)
{
    ImGui::TableNextColumn();
    right_aligned(text);
}

void displacements(Session& session, const CaseResult& result)
{
    const ui::DisplayUnits units = session.units();
    const std::vector<Dof> list = dofs_of(session.model().analysis);
    const auto measure = [](Dof dof) { return index(dof) < 3 ? Measure::Displacement : Measure::Rotation; };
    std::vector<std::string> headings{session.view.tr("Node")};
    for (const Dof dof : list) headings.push_back(units.label(name(dof), measure(dof)));
    table("displacements", headings, session.model().nodes.size(), [&](std::size_t i) {
        part_cell(session, NodeId(i), session.model().nodes[i].id);
        const NodeVector u = result.displacement(NodeId(i));
        for (const Dof dof : list) number_cell(units.number(u[index(dof)], measure(dof)));
    });
}

void reactions(Session& session, const CaseResult& result)
{
    const ui::DisplayUnits units = session.units();
    const std::vector<Dof> list = dofs_of(session.model().analysis);
    const auto measure = [](Dof dof) { return index(dof) < 3 ? Measure::Force : Measure::Moment; };
    std::vector<NodeId> supported;
    for (std::size_t i = 0; i < session.model().nodes.size(); ++i) {
        if (result.is_supported(NodeId(i))) supported.emplace_back(i);
    }
    std::vector<std::string> headings{session.view.tr("Node")};
    for (const Dof dof : list) headings.push_back(units.label(force_name(dof), measure(dof)));
    table("reactions", headings, supported.size(), [&](std::size_t i) {
        part_cell(session, supported[i], session.model()[supported[i]].id);
        const NodeVector r = result.reaction(supported[i]);
        for (const Dof dof : list) number_cell(units.number(r[index(dof)], measure(dof)));
    });
}

// For each member its largest and its smallest value of one section force, and where they are.
void member_forces(Session& session, const CaseResult& result, const Reading& column)
{
    const ui::DisplayUnits units = session.units();
    const ui::Catalogue& tr = session.view.tr;
    const std::string value = units.label(column.name, column.measure);
    const std::string at = units.label("x", Measure::Length);
    const std::vector<std::string> headings{tr("Member"),
                                            tr("{value}, start", {{"value", value}}),
                                            tr("{value}, end", {{"value", value}}),
                                            tr("max"),
                                            at + "###x1",
                                            tr("min"),
                                            at + "###x2"};
    table(column.name, headings, session.model().members.size(), [&](std::size_t i) {
        part_cell(session, MemberId(i), session.model().members[i].id);
        const Curve curve = result.curve(MemberId(i));
        const Extremes extremes = curve.extremes(column.component);
        number_cell(units.number(curve.value(column.component, 0.0), column.measure));
        number_cell(units.number(curve.value(column.component, curve.length(), Side::Before), column.measure));
        number_cell(units.number(extremes.max.value, column.measure));
        number_cell(units.number(extremes.max.x, Measure::Length));
        number_cell(units.number(extremes.min.value, column.measure));
        number_cell(units.number(extremes.min.x, Measure::Length));
    });
}

bool section(const std::string& title, const char* id)
{
    return ImGui::CollapsingHeader((title + "###" + id).c_str(), ImGuiTreeNodeFlags_DefaultOpen);
}

void show_equilibrium(Session& session, const CaseResult& result)
{
    const ui::DisplayUnits units = session.units();
    const ui::Catalogue& tr = session.view.tr;
    const Equilibrium& equilibrium = result.equilibrium();
    for (const Dof dof : dofs_of(session.model().analysis)) {
        const Measure measure = index(dof) < 3 ? Measure::Force : Measure::Moment;
        ImGui::TextWrapped("%s", tr("Σ{force}: loads {loads}, reactions {reactions}",
                                    {{"force", force_name(dof)},
                                     {"loads", units.text(equilibrium.sum_loads[index(dof)], measure)},
                                     {"reactions", units.text(equilibrium.sum_reactions[index(dof)], measure)}})
                                     .c_str());
    }
    ImGui::TextWrapped(
        "%s", tr("Largest force out of balance: {residual} of the largest load",
                 {{"residual", ui::number_text(equilibrium.residual, {.digits = 2, .mark = units.format().mark})}})
                  .c_str());
}

} // namespace

void results_panel(Desk& desk)
{
    Session& session = desk.session;
    const ui::Catalogue& tr = session.view.tr;
    const auto& results = session.solution().results;
    if (!results) {
        ImGui::TextWrapped("%s", tr("There are no results: see the problems.").c_str());
        return;
    }
    if (results->n_cases() == 0) {
        ImGui::TextWrapped("%s", tr("The model has no load case.").c_str());
        return;
    }
    const CaseResult result = (*results)[session.view.load_case];
    ImGui::TextDisabled("%s", tr("Case {case}", {{"case", result.name()}}).c_str());
    for (const Reading& column : section_forces(session.model().analysis)) {
        if (section(tr("Members: {value}", {{"value", column.name}}), column.name))
            member_forces(session, result, column);
    }
    if (section(tr("Reactions"), "reactions")) reactions(session, result);
    if (section(tr("Displacements"), "displacements")) displacements(session, result);
    if (section(tr("Equilibrium"), "equilibrium")) show_equilibrium(session, result);
}

void problems_panel(Desk& desk)
{
    Session& session = desk.session;
    const ui::Catalogue& tr = session.view.tr;
    const Solution& solution = session.solution();
    if (solution.faults.empty()) ImGui::TextWrapped("%s", tr("Nothing is wrong with the model.").c_str());
    for (std::size_t i = 0; i < solution.faults.size(); ++i) {
        const Fault& fault = solution.faults[i];
        const bool is_error = severity(fault.kind) == Severity::Error;
        ImGui::TextUnformatted((is_error ? tr("Error") : tr("Warning")).c_str());
        ImGui::TextWrapped("%s", sentence(fault, tr).c_str());
        ImGui::Separator();
    }
    for (std::size_t i = 0; i < solution.mechanisms.size() && solution.mechanisms.size() > 1; ++i) {
        const std::string label = tr("Mechanism {number}", {{"number", std::to_string(i + 1)}});
        if (ImGui::RadioButton(label.c_str(), session.mechanism == i)) session.mechanism = i;
    }
}

void history_panel(Desk& desk)
{
    Session& session = desk.session;
    for (std::size_t i = 0; i < session.history().n_states(); ++i) {
        const bool is_ahead = i > session.history().place();
        if (is_ahead) ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
        const std::string label = session.view.tr(session.history().label(i)) + "###" + std::to_string(i);
        const bool is_chosen = ImGui::Selectable(label.c_str(), i == session.history().place());
        if (is_ahead) ImGui::PopStyleColor();
        if (is_chosen) {
            session.jump(i);
            return;
        }
    }
}

} // namespace frame
