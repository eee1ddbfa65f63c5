#include "apps/frame/window/case_list.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <array>
#include <utility>

#include "apps/frame/session/case_commands.h"
#include "ui/text/trimmed.h"
#include "ui/widgets/command_menu.h"
#include "ui/widgets/wrapped_text.h"

namespace frame {

using ui::translatable;

namespace {

constexpr std::array<std::string_view, 6> of_cases{"case.new",  "case.combination", "case.rename",
                                                   "case.copy", "case.delete",      "case.self_weight"};

// The commands, once the list has opened it.
void show_menu(Workspace& workspace, const CommandTable& commands)
{
    if (!ImGui::BeginPopup("###case menu")) return;
    const ui::Catalogue tr = workspace.session.view.tr;
    for (const std::string_view id : of_cases) ui::show_command(*commands.find(id), workspace, tr);
    ImGui::EndPopup();
}

} // namespace

void CaseList::show(Workspace& workspace, const CommandTable& commands)
{
    Session& session = workspace.session;
    show_heading(workspace);
    const femoop::Model& model = session.model();
    if (std::exchange(begins_to_type_, false) && model.n_cases() > 0) {
        typed_case_ = session.view.load_case;
        name_ = model.case_name(*typed_case_);
        reason_.reset();
        is_fresh_ = true;
    }
    if (typed_case_ && typed_case_->index >= model.n_cases()) typed_case_.reset();
    if (model.n_cases() == 0) ImGui::TextWrapped("%s", session.view.tr("The model has no load case.").c_str());
    for (std::size_t i = 0; i < session.model().n_cases(); ++i) {
        if (typed_case_ == femoop::CaseId(i)) show_name_field(workspace, femoop::CaseId(i));
        else show_entry(workspace, femoop::CaseId(i));
    }
    const bool is_of_trains = session.shows_train_envelope();
    const auto choose = [&](std::string_view label, bool is_now, bool takes_trains) {
        if (!ImGui::RadioButton((session.view.tr(label) + "###" + std::string(label)).c_str(), is_now)) return;
        session.view.is_envelope = true;
        session.train_envelope.turn(takes_trains);
    };
    if (session.model().n_cases() > 1)
        choose(translatable("Envelope"), session.view.is_envelope && !is_of_trains, false);
    if (!session.model().moving_loads.trains.empty()) choose(translatable("Envelope of trains"), is_of_trains, true);
    if (std::exchange(opens_menu_, false)) ImGui::OpenPopup("###case menu");
    show_menu(workspace, commands);
}

void CaseList::show_heading(Workspace& workspace)
{
    const ui::Catalogue& tr = workspace.session.view.tr;
    ImGui::Spacing();
    ImGui::TextDisabled("%s", tr("Load case").c_str());
    const float side = ImGui::GetTextLineHeight();
    ImGui::SameLine(ImGui::GetContentRegionMax().x - 1.6F * side);
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    if (ImGui::InvisibleButton("###add case", {1.6F * side, side})) opens_menu_ = true;
    const bool is_hovered = ImGui::IsItemHovered();
    if (is_hovered) ImGui::SetTooltip("%s", tr("New load case or combination; rename, duplicate, delete").c_str());
    const ImU32 ink = ImGui::GetColorU32(ImGuiCol_Text),
                ground = ImGui::GetColorU32(is_hovered ? ImGuiCol_ButtonHovered : ImGuiCol_Button);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(corner, {corner.x + 1.6F * side, corner.y + side}, ground, ImGui::GetStyle().FrameRounding);
    const ImVec2 middle{corner.x + 0.8F * side, corner.y + 0.5F * side};
    const float arm = 0.3F * side, half = 0.05F * side;
    list.AddRectFilled({middle.x - arm, middle.y - half}, {middle.x + arm, middle.y + half}, ink);
    list.AddRectFilled({middle.x - half, middle.y - arm}, {middle.x + half, middle.y + arm}, ink);
    ImGui::Separator();
}

void CaseList::show_entry(Workspace& workspace, femoop::CaseId id)
{
    Session& session = workspace.session;
    const femoop::Model& model = session.model();
    const std::string& name = model.case_name(id);
    const bool is_combination = id.index >= model.load_cases.size();
    const std::string label = ui::label_beside_box(
        is_combination ? session.view.tr("{case} (combination)", {{"case", name}}) : name, std::to_string(id.index));
    const bool is_shown = !session.view.is_envelope && session.view.load_case == id;
    if (ImGui::RadioButton(label.c_str(), is_shown)) show_case(session, id);
    if (!ImGui::IsItemHovered()) return;
    if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) begins_to_type_ = true;
    if (!ImGui::IsMouseReleased(ImGuiMouseButton_Right)) return;
    show_case(session, id);
    opens_menu_ = true;
}

void CaseList::show_name_field(Workspace& workspace, femoop::CaseId id)
{
    Session& session = workspace.session;
    ImGui::SetNextItemWidth(-1.0F);
    if (std::exchange(is_fresh_, false)) ImGui::SetKeyboardFocusHere();
    const auto flags = ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll;
    const bool is_confirmed = ImGui::InputText("###case name", &name_, flags);
    const bool is_cancelled = ImGui::IsItemDeactivated() && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape));
    const bool is_left = is_confirmed || ImGui::IsItemDeactivated();
    if (is_left) reason_ = is_cancelled ? std::nullopt : rename(session, id, std::string(ui::trimmed(name_)));
    if (is_left && (is_cancelled || !reason_ || !is_confirmed)) typed_case_.reset();
    else if (is_confirmed) is_fresh_ = true; // to be mended
    if (typed_case_ && reason_) ui::wrapped_text(session.view.tr(*reason_));
    if (!typed_case_ && reason_) workspace.notify(*std::exchange(reason_, std::nullopt));
}

} // namespace frame
