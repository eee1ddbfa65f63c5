#include "apps/frame/window/design_window.h"

#include <imgui.h>

#include <algorithm>
#include <string>
#include <vector>

#include "ui/widgets/wrapped_text.h"

namespace frame {

using femoop::ActionKind;
using femoop::DesignCode;
using femoop::DesignCombination;
using femoop::LimitState;
using ui::translatable;

namespace {

void show_codes(Workspace& workspace, ui::TabStops& stops)
{
    DesignDraft& draft = workspace.design;
    for (const DesignCode code : femoop::design_codes()) {
        const std::string label = std::string(name(code)) + "###" + std::string(id(code));
        const bool is_chosen = draft.code() == code;
        if (ImGui::RadioButton(label.c_str(), is_chosen)) draft.choose_code(workspace.session, code);
        if (is_chosen) stops.add();
    }
}

std::string label_of(const ActionKind* kind, const ui::Catalogue& tr)
{
    return kind != nullptr ? tr(kind->label) : tr("not in the combinations");
}

/// "γ 1.5   ψ 0.7 0.5 0.3   tables A1.1, A1.2(B)"
std::string factors_of(const ActionKind& kind, const Session& session)
{
    const ui::DisplayUnits units = session.units();
    const auto number = [&](double value) { return units.number(value, ui::Measure::Plain); };
    std::string text = "γ " + number(kind.unfavourable);
    if (kind.is_permanent) text += " / " + number(kind.favourable);
    if (kind.psi0 + kind.psi1 + kind.psi2 > 0.0)
        text += "   ψ " + number(kind.psi0) + "  " + number(kind.psi1) + "  " + number(kind.psi2);
    return text + "   " + session.view.tr(kind.table);
}

void show_action(Workspace& workspace, std::size_t place)
{
    DesignDraft& draft = workspace.design;
    const ui::Catalogue& tr = workspace.session.view.tr;
    const ActionKind* const chosen = draft.actions()[place].kind;
    const std::string id = "###action" + std::to_string(place);
    std::vector<std::string> labels{label_of(nullptr, tr)};
    for (const ActionKind& kind : action_kinds(draft.code())) labels.push_back(label_of(&kind, tr));
    if (ui::begin_wrapped_combo(label_of(chosen, tr), labels, id.c_str())) {
        if (ImGui::Selectable(label_of(nullptr, tr).c_str(), chosen == nullptr)) draft.set_action(place, nullptr);
        for (const ActionKind& kind : action_kinds(draft.code())) {
            if (ImGui::Selectable(label_of(&kind, tr).c_str(), chosen == &kind)) draft.set_action(place, &kind);
            if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", factors_of(kind, workspace.session).c_str());
        }
        ImGui::EndCombo();
    }
    if (chosen != nullptr && ImGui::IsItemHovered())
        ImGui::SetTooltip("%s", factors_of(*chosen, workspace.session).c_str());
}

void show_actions(Workspace& workspace, ui::TabStops& stops)
{
    if (!ImGui::BeginTable("actions", 2, ImGuiTableFlags_SizingFixedFit)) return;
    ImGui::TableSetupColumn("###case", ImGuiTableColumnFlags_WidthFixed);
    ImGui::TableSetupColumn("###action", ImGuiTableColumnFlags_WidthStretch);
    const femoop::Model& model = workspace.session.model();
    for (std::size_t i = 0; i < workspace.design.actions().size(); ++i) {
        ImGui::TableNextColumn();
        ImGui::AlignTextToFramePadding();
        ImGui::TextUnformatted(model.load_cases[i].id.c_str());
        ImGui::TableNextColumn();
        show_action(workspace, i);
        stops.add();
    }
    ImGui::EndTable();
}

void show_states(Workspace& workspace, ui::TabStops& stops)
{
    DesignDraft& draft = workspace.design;
    for (const LimitState state : limit_states(draft.code())) {
        bool is_on = draft.has(state);
        const std::string label = workspace.session.view.tr(short_name(draft.code(), state)) + "###" +
                                  std::string(id(state));
        if (ImGui::Checkbox(label.c_str(), &is_on)) draft.set(state, is_on);
        stops.add();
    }
}

void show_combination(const Workspace& workspace, const DesignCombination& one)
{
    const ui::Catalogue& tr = workspace.session.view.tr;
    const femoop::Model& model = workspace.session.model();
    ui::wrapped_text(combination_name(workspace.design.code(), model, one, tr));
    std::string meaning = std::string(one.clause);
    if (one.leading) meaning += tr(", {case} leads", {{"case", model.case_name(*one.leading)}});
    ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetColorU32(ImGuiCol_TextDisabled));
    ui::wrapped_text(meaning);
    ImGui::PopStyleColor();
}

void show_buttons(Workspace& workspace, ui::NumberFields& fields)
{
    const bool has_some = !workspace.design.combinations().empty();
    const ui::FootAnswer answer = ui::foot_buttons({.may_accept = has_some, .is_typing = fields.is_typing()},
                                                   workspace.session.view.tr, fields.stops());
    if (answer == ui::FootAnswer::Accept) workspace.design.accept(workspace.session);
    else if (answer == ui::FootAnswer::Cancel) workspace.design.cancel();
}

} // namespace

void DesignWindow::show(Workspace& workspace, ui::NumberFields& fields)
{
    const DesignDraft& draft = workspace.design;
    const ui::Catalogue& tr = workspace.session.view.tr;
    if (!window_.begin(draft.is_open(), "###design", tr("Combinations of a code"), fields.stops())) return;
    ui::SideWindow::begin_content();
    show_codes(workspace, fields.stops());
    ImGui::Separator();
    show_actions(workspace, fields.stops());
    show_states(workspace, fields.stops());
    ImGui::Separator();
    const std::vector<DesignCombination>& combinations = draft.combinations();
    const std::size_t n = draft.has_too_many() ? femoop::most_design_combinations : combinations.size();
    ui::wrapped_text(tr(draft.has_too_many() ? ui::translatable("More than {count} combinations may come of so many "
                                                                "alternatives; leave cases or limit states out")
                                             : ui::translatable("{count} combinations; they can be changed afterwards"),
                        {{"count", std::to_string(n)}}));
    ImGui::BeginChild("###combinations", {0.0F, 0.0F});
    for (const DesignCombination& one : combinations) show_combination(workspace, one);
    ImGui::EndChild();
    ui::SideWindow::end_content();
    show_buttons(workspace, fields);
    window_.end(draft.is_open(), fields.stops());
}

} // namespace frame
