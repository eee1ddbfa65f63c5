#include "apps/plane/window/side_panels.h"

#include <imgui.h>

#include <array>
#include <string>

#include "apps/plane/document/fault_words.h"
#include "apps/plane/document/regions.h"
#include "apps/plane/session/drawing_commands.h"
#include "apps/plane/session/part_commands.h"
#include "apps/plane/window/properties_panel.h"
#include "ui/widgets/command_menu.h"
#include "ui/widgets/item_label.h"
#include "ui/widgets/wrapped_text.h"

namespace plane {

using ui::translatable;

namespace {

void title_row(Workspace& workspace, ui::NumberFields& fields)
{
    const Session& session = workspace.session;
    const ui::Catalogue tr = workspace.tr();
    ImGui::TextUnformatted(tr("Title").c_str());
    const std::string& title = session.model().title;
    const auto event = fields.show("title", {.text = title.empty() ? tr("Untitled") : title,
                                             .exact_text = title,
                                             .value = std::nullopt,
                                             .is_typed_only = true});
    if (event.kind == ui::NumberFieldEvent::Kind::Typed)
        workspace.change({translatable("Change the title"),
                          [text = event.text](Document& document) { document.model.title = text; }});
}

void case_rows(Workspace& workspace, const CommandTable& commands)
{
    Session& session = workspace.session;
    const ui::Catalogue tr = workspace.tr();
    ImGui::Spacing();
    ImGui::TextUnformatted(tr("Load cases").c_str());
    for (std::size_t i = 0; i < session.model().n_cases(); ++i) {
        const std::string name = session.model().case_name(femoop::CaseId(i));
        if (ImGui::RadioButton(ui::item_label(name, "case " + std::to_string(i)).c_str(), session.load_case == i))
            session.load_case = i;
    }
    for (const char* id : {"case.add", "case.combination", "case.delete"})
        if (!why_not(*commands.find(id), workspace)) ui::command_button(workspace, commands, id);
}

void shown_case_rows(Workspace& workspace, ui::NumberFields& fields)
{
    const Session& session = workspace.session;
    if (session.load_case >= session.model().n_cases()) return;
    name_row(workspace, fields, femoop::CaseId(session.load_case));
    case_number_rows(workspace, fields);
}

/// A line of the list of parts.
void part_row(Workspace& workspace, const Part& part, const std::string& text, const std::string& id)
{
    if (ImGui::Selectable(ui::item_label(text, id).c_str(), workspace.session.is_selected(part))) {
        workspace.session.select(part);
        workspace.topic = Topic::Properties;
    }
}

bool begin_list(const ui::Catalogue& tr, std::string_view heading, std::size_t n)
{
    const std::string label = tr(heading) + " (" + std::to_string(n) + ")";
    return ImGui::CollapsingHeader(ui::item_label(label, heading).c_str());
}

void part_lists(Workspace& workspace)
{
    const Session& session = workspace.session;
    const ui::Catalogue tr = workspace.tr();
    const auto* const drawing = session.drawing();
    if (drawing != nullptr && begin_list(tr, translatable("Faces"), drawing->faces().size()))
        for (std::size_t i = 0; i < drawing->faces().size(); ++i) {
            const Part part = FacePlace{drawing->faces()[i].inside};
            part_row(workspace, part, tr(title(session, part)), "face " + std::to_string(i));
        }
    if (begin_list(tr, translatable("Curves"), session.model().curves.size()))
        for (std::size_t i = 0; i < session.model().curves.size(); ++i)
            part_row(workspace, CurveId(i), tr(title(session, CurveId(i))), "curve " + std::to_string(i));
    if (begin_list(tr, translatable("Points"), session.model().points.size()))
        for (std::size_t i = 0; i < session.model().points.size(); ++i)
            part_row(workspace, NodeId(i), tr(title(session, NodeId(i))), "point " + std::to_string(i));
}

} // namespace

void model_panel(Workspace& workspace, const CommandTable& commands, ui::NumberFields& fields)
{
    title_row(workspace, fields);
    ImGui::Spacing();
    for (const char* id : {"analysis.plane_stress", "analysis.plane_strain", "analysis.axisymmetric"}) {
        const auto& command = *commands.find(id);
        const std::string label = ui::item_label(workspace.tr()(command.label), id);
        if (ImGui::RadioButton(label.c_str(), command.is_on(workspace))) run(command, workspace);
    }
    case_rows(workspace, commands);
    shown_case_rows(workspace, fields);
    ImGui::Spacing();
    part_lists(workspace);
}

void problems_panel(Workspace& workspace, const CommandTable& commands)
{
    Session& session = workspace.session;
    const ui::Catalogue tr = workspace.tr();
    std::vector<femoop::Fault> faults = session.solution().faults();
    if (session.analysed() != nullptr) // of the mesh and of the analysis
        faults.insert(faults.end(), session.analysed()->faults().begin(), session.analysed()->faults().end());
    const std::vector<femoop::Fault> of_modes = session.faults_of_modes();
    faults.insert(faults.end(), of_modes.begin(), of_modes.end());
    if (faults.empty()) ui::wrapped_text(tr("Nothing is wrong with the drawing."));
    else ImGui::TextDisabled("%s", tr("A click goes to the place.").c_str());
    for (std::size_t i = 0; i < faults.size(); ++i) {
        const auto part = part_of(faults[i], session.model(), session.drawing());
        const std::string text = (is_error(faults[i]) ? "! " : "") + sentence(faults[i], session.model(), tr);
        if (ui::wrapped_button(text, "problem " + std::to_string(i)) && part) session.select(*part);
    }
    if (told_gap(workspace)) ui::command_button(workspace, commands, "draw.close_gap");
}

} // namespace plane
