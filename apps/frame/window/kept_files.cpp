#include "apps/frame/window/kept_files.h"

#include <imgui.h>

#include <string>

#include "apps/frame/session/tabs.h"

namespace frame {

KeptFiles::KeptFiles(const std::optional<std::filesystem::path>& folder)
{
    if (!folder) return;
    autosave_.emplace(*folder);
    recent_.emplace(*folder / "recent");
    leftovers_ = autosave_->new_leftovers();
}

void KeptFiles::tick(const Desk& desk, double seconds)
{
    if (autosave_) autosave_->tick(desk, seconds);
    if (!desk.session.history().is_dragging()) look_for_leftovers(seconds);
    const auto& path = desk.session.path();
    if (!recent_ || !path || *path == noted_) return;
    noted_ = *path;
    recent_->add(*path);
}

// Who starts the program again right after it was killed must not miss the draft that the dying one still holds; later
// nobody is interrupted.
void KeptFiles::look_for_leftovers(double seconds)
{
    constexpr double patience = 60.0, interval = 2.0; // s
    age_ += seconds;
    if (!autosave_ || age_ > patience || age_ - looked_at_ < interval) return;
    looked_at_ = age_;
    const std::vector<Leftover> found = autosave_->new_leftovers();
    leftovers_.insert(leftovers_.end(), found.begin(), found.end());
}

void KeptFiles::end()
{
    if (autosave_) autosave_->forget_all();
}

void KeptFiles::show(Desk& desk)
{
    if (!leftovers_.empty()) show_leftovers(desk);
    if (asks_for_recent_) show_recent(desk);
}

namespace {

// A window over all others in the middle of the screen; it must be ended where it is open.
bool begin_modal(const std::string& heading, const char* id)
{
    ImGui::OpenPopup(id);
    ImGui::SetNextWindowPos(ImGui::GetMainViewport()->GetCenter(), ImGuiCond_Appearing, {0.5F, 0.5F});
    return ImGui::BeginPopupModal((heading + id).c_str(), nullptr, ImGuiWindowFlags_AlwaysAutoResize);
}

bool is_escaped() { return ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape)); }

} // namespace

void KeptFiles::show_recent(Desk& desk)
{
    const ui::Catalogue tr = desk.session.view.tr;
    if (!begin_modal(tr("The last files"), "###recent")) return;
    const bool is_empty = !recent_ || recent_->paths().empty();
    if (is_empty) ImGui::TextUnformatted(tr("No file was opened or saved yet.").c_str());
    std::optional<std::filesystem::path> chosen;
    for (std::size_t i = 0; !is_empty && i < recent_->paths().size(); ++i) {
        const std::filesystem::path& path = recent_->paths()[i];
        const std::string label = path.filename().string() + "   –   " + path.parent_path().string();
        if (ImGui::Selectable((label + "###" + std::to_string(i)).c_str())) chosen = path;
    }
    ImGui::Spacing();
    asks_for_recent_ = !(ImGui::Button((tr("Cancel") + "###cancel").c_str()) || is_escaped() || chosen);
    if (!asks_for_recent_) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
    if (chosen) open_file(desk, *chosen);
}

void KeptFiles::show_leftovers(Desk& desk)
{
    const ui::Catalogue tr = desk.session.view.tr;
    if (!begin_modal(tr("Unsaved work was found"), "###leftovers")) return;
    ImGui::TextUnformatted(tr("The program ended before this was saved.").c_str());
    std::optional<std::size_t> done;
    for (std::size_t i = 0; i < leftovers_.size(); ++i) {
        const Leftover& leftover = leftovers_[i];
        ImGui::PushID(static_cast<int>(i));
        const bool opens = ImGui::Button((tr("Open") + "###open").c_str());
        ImGui::SameLine();
        const bool deletes = ImGui::Button((tr("Delete") + "###delete").c_str());
        ImGui::SameLine();
        ImGui::TextUnformatted(leftover.original ? leftover.original->string().c_str() : tr("Untitled").c_str());
        ImGui::PopID();
        if (opens) open_leftover(desk, leftover);
        if (deletes) Recovery::discard(leftover);
        if (opens || deletes) done = i;
    }
    if (done) leftovers_.erase(leftovers_.begin() + static_cast<std::ptrdiff_t>(*done));
    ImGui::Spacing();
    const bool later = ImGui::Button((tr("Later") + "###later").c_str()) || is_escaped();
    if (later) leftovers_.clear();
    if (leftovers_.empty()) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
}

} // namespace frame
