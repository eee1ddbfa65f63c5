#include "ui/widgets/path_dialog.h"
#include "ui/widgets/item_label.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cstdlib>
#include <system_error>
#include <utility>

namespace ui {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t most_entries = 2000;

fs::path expanded(const std::string& typed)
{
    const char* const home = std::getenv("HOME");
    if (home != nullptr && (typed == "~" || typed.starts_with("~/"))) return fs::path(home + typed.substr(1));
    return typed;
}

} // namespace

void PathDialog::open(Purpose purpose, const fs::path& start, std::string extension, std::string left_out)
{
    is_open_ = is_fresh_ = true;
    must_confirm_overwrite_ = false;
    purpose_ = purpose;
    extension_ = std::move(extension);
    left_out_ = std::move(left_out);
    std::error_code error;
    start_ = fs::absolute(start.empty() ? fs::current_path(error) / "" : start, error);
    enter(start_.has_filename() ? start_.parent_path() : start_);
    typed_ = purpose == Purpose::Save ? start_.filename().string() : "";
}

bool PathDialog::is_listed(const fs::path& file) const
{
    return file.extension() == extension_ && (left_out_.empty() || !file.filename().string().ends_with(left_out_));
}

void PathDialog::enter(const fs::path& folder)
{
    std::error_code error;
    folder_ = folder.lexically_normal();
    entries_.clear();
    for (fs::directory_iterator item(folder_, fs::directory_options::skip_permission_denied, error), end;
         !error && item != end && entries_.size() < most_entries; item.increment(error)) {
        const std::string name = item->path().filename().string();
        std::error_code unknown;
        const bool is_folder = item->is_directory(unknown);
        const bool is_hidden = name.starts_with('.');
        if (!is_hidden && (is_folder || is_listed(item->path()))) entries_.push_back({name, is_folder});
    }
    std::ranges::sort(entries_, [](const Entry& a, const Entry& b) {
        return a.is_folder != b.is_folder ? a.is_folder : a.name < b.name;
    });
}

bool PathDialog::show_list()
{
    bool is_confirmed = false;
    ImGui::BeginChild("###entries", {0.0F, 14.0F * ImGui::GetTextLineHeightWithSpacing()}, true);
    fs::path entered;
    if (folder_.has_parent_path() && folder_ != folder_.root_path() && ImGui::Selectable(".."))
        entered = folder_ / "..";
    for (const Entry& entry : entries_) {
        const std::string label = shown_whole(entry.is_folder ? entry.name + "/" : entry.name);
        if (!ImGui::Selectable(label.c_str(), typed_ == entry.name, ImGuiSelectableFlags_AllowDoubleClick)) continue;
        if (entry.is_folder) entered = folder_ / entry.name;
        if (!entry.is_folder) typed_ = entry.name;
        must_confirm_overwrite_ = false;
        is_confirmed = !entry.is_folder && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
    }
    ImGui::EndChild();
    if (!entered.empty()) enter(entered);
    return is_confirmed;
}

std::optional<fs::path> PathDialog::confirm()
{
    fs::path path = folder_ / expanded(typed_); // an absolute path stays as it is
    std::error_code error;
    if (typed_.empty()) return std::nullopt;
    if (fs::is_directory(path, error)) {
        enter(path);
        typed_.clear();
        return std::nullopt;
    }
    if (!path.has_extension()) path += extension_;
    const bool would_overwrite = purpose_ == Purpose::Save && path != start_ && fs::exists(path, error);
    if (would_overwrite && !must_confirm_overwrite_) {
        must_confirm_overwrite_ = true;
        return std::nullopt;
    }
    is_open_ = false;
    return path.lexically_normal();
}

std::optional<fs::path> PathDialog::show(const Catalogue& tr)
{
    if (!is_open_) return std::nullopt;
    const bool is_opening = purpose_ == Purpose::Open;
    const std::string title = (is_opening ? tr("Open a file") : tr("Save as")) + "###path dialog";
    if (is_fresh_) ImGui::OpenPopup("###path dialog");
    const ImVec2 middle = ImGui::GetMainViewport()->GetCenter();
    ImGui::SetNextWindowPos(middle, ImGuiCond_Appearing, {0.5F, 0.5F});
    ImGui::SetNextWindowSize({36.0F * ImGui::GetFontSize(), 0.0F});
    bool stays_open = true;
    if (!ImGui::BeginPopupModal(title.c_str(), &stays_open, ImGuiWindowFlags_NoSavedSettings)) {
        is_open_ = false;
        return std::nullopt;
    }
    ImGui::TextDisabled("%s", folder_.string().c_str());
    bool is_confirmed = show_list();
    ImGui::SetNextItemWidth(-1.0F);
    if (std::exchange(is_fresh_, false)) ImGui::SetKeyboardFocusHere();
    if (ImGui::InputTextWithHint("###typed", tr("Path of the file").c_str(), &typed_,
                                 ImGuiInputTextFlags_EnterReturnsTrue))
        is_confirmed = true;
    if (must_confirm_overwrite_) ImGui::TextWrapped("%s", tr("This file exists. Save again to replace it.").c_str());
    if (ImGui::Button((is_opening ? tr("Open") : tr("Save")).c_str())) is_confirmed = true;
    ImGui::SameLine();
    const bool is_escaped = ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape));
    if (ImGui::Button(tr("Cancel").c_str()) || is_escaped || !stays_open) is_open_ = false;
    std::optional<fs::path> path = is_confirmed ? confirm() : std::nullopt;
    if (!is_open_) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
    return path;
}

} // namespace ui
