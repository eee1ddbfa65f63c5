#include "apps/frame/window/questions.h"

#include <imgui.h>

#include <string>

#include "apps/frame/session/tabs.h"

namespace frame {

namespace {

// The first document that has something to lose; the present one, if it has.
std::optional<std::size_t> unsaved_tab(const Desk& desk)
{
    if (desk.session.is_dirty()) return desk.tab;
    for (std::size_t i = 0; i < n_tabs(desk); ++i)
        if (tab(desk, i).is_dirty()) return i;
    return std::nullopt;
}

} // namespace

bool Questions::show(Desk& desk)
{
    if (purpose_ == Purpose::None) return false;
    if (desk.session.is_dirty()) {
        ask(desk);
        return false;
    }
    return go_on(desk);
}

bool Questions::go_on(Desk& desk)
{
    if (purpose_ == Purpose::Close) {
        close_tab(desk);
        purpose_ = Purpose::None;
        return false;
    }
    const std::optional<std::size_t> unsaved = unsaved_tab(desk);
    if (unsaved) show_tab(desk, *unsaved);
    else purpose_ = Purpose::None;
    return !unsaved;
}

void Questions::ask(Desk& desk)
{
    const ui::Catalogue tr = desk.session.view.tr;
    const std::string heading = tr("Unsaved changes") + "###unsaved";
    ImGui::OpenPopup("###unsaved");
    ImGui::SetNextWindowPos(ImGui::GetMainViewport()->GetCenter(), ImGuiCond_Appearing, {0.5F, 0.5F});
    if (!ImGui::BeginPopupModal(heading.c_str(), nullptr, ImGuiWindowFlags_AlwaysAutoResize)) return;
    ImGui::TextUnformatted(tr("{file} has changes that are not saved.", {{"file", desk.session.file_name()}}).c_str());
    ImGui::Spacing();
    const bool wants_to_save = ImGui::Button((tr("Save") + "###save").c_str());
    ImGui::SameLine();
    const bool gives_up = ImGui::Button((tr("Do not save") + "###give up").c_str());
    ImGui::SameLine();
    const bool is_escaped = ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape));
    const bool is_cancelled = ImGui::Button((tr("Cancel") + "###cancel").c_str()) || is_escaped;
    if (wants_to_save || gives_up || is_cancelled) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
    const bool needs_a_name = wants_to_save && !desk.session.path();
    const bool is_hindered = wants_to_save && !needs_a_name && !desk.session.save(*desk.session.path());
    if (needs_a_name) desk.requests.push_back(Request::SaveDialog);
    if (needs_a_name || is_hindered || is_cancelled) purpose_ = Purpose::None;
    if (!gives_up) return;
    close_tab(desk);
    if (purpose_ == Purpose::Close) purpose_ = Purpose::None;
}

} // namespace frame
