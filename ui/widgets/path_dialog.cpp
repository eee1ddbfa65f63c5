#include "ui/widgets/path_dialog.h"
#include "ui/widgets/answer_button.h"
#include "ui/widgets/item_label.h"
#include "ui/widgets/wrapped_text.h"

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

/// What follows a name's last point, with it; a number, as in "v1.2", is no ending.
std::string ending_of(const fs::path& path)
{
    std::string ending = path.extension().string();
    const bool is_number = ending.find_first_not_of("0123456789", 1) == std::string::npos;
    return is_number ? "" : ending;
}

} // namespace

void PathDialog::open(Purpose purpose, const fs::path& start, std::string extension, std::string left_out)
{
    is_open_ = is_fresh_ = wants_keyboard_ = true;
    must_confirm_overwrite_ = false;
    refusal_.reset();
    purpose_ = purpose;
    extension_ = std::move(extension);
    left_out_ = std::move(left_out);
    endings_.clear();
    std::error_code error;
    start_ = fs::absolute(start.empty() ? fs::current_path(error) / "" : start, error);
    enter(start_.has_filename() ? start_.parent_path() : start_);
    typed_ = is_opening() ? "" : start_.filename().string();
    n_marked_ = typed_.size();
}

void PathDialog::open_any(const fs::path& start, std::vector<std::string> endings)
{
    open_listing(Purpose::Open, start, std::move(endings));
}

void PathDialog::open_export(const fs::path& start, std::vector<std::string> endings)
{
    open_listing(Purpose::Export, start, std::move(endings));
}

void PathDialog::open_listing(Purpose purpose, const fs::path& start, std::vector<std::string> endings)
{
    open(purpose, start, endings.front());
    endings_ = std::move(endings);
    enter(folder_); // what has one of the endings is listed
}

void PathDialog::refuse(const Message& reason)
{
    is_open_ = is_fresh_ = wants_keyboard_ = true;
    must_confirm_overwrite_ = false;
    n_marked_.reset();
    refusal_ = reason;
}

bool PathDialog::is_listed(const fs::path& file) const
{
    if (!endings_.empty()) return !why_not_ending(file, endings_);
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
    constexpr float most = 14.0F, least = 4.0F, others = 12.0F; // lines; those of the rest of the dialog
    const float line = ImGui::GetTextLineHeightWithSpacing();
    const float room = ImGui::GetMainViewport()->WorkSize.y / line - others;
    bool is_confirmed = false;
    ImGui::BeginChild("###entries", {0.0F, line * std::clamp(room, least, most)}, true);
    fs::path entered;
    if (folder_.has_parent_path() && folder_ != folder_.root_path() && ImGui::Selectable(".."))
        entered = folder_ / "..";
    for (const Entry& entry : entries_) {
        const std::string label = shown_whole(entry.is_folder ? entry.name + "/" : entry.name);
        if (!ImGui::Selectable(label.c_str(), typed_ == entry.name, ImGuiSelectableFlags_AllowDoubleClick)) continue;
        if (entry.is_folder) entered = folder_ / entry.name;
        if (!entry.is_folder) take_name(entry.name);
        must_confirm_overwrite_ = false;
        refusal_.reset();
        is_confirmed = !entry.is_folder && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
    }
    ImGui::EndChild();
    if (!entered.empty()) enter(entered);
    return is_confirmed;
}

// Without the longest of its endings.
std::string PathDialog::stem_of(const std::string& name) const
{
    const std::vector<std::string> wanted = wanted_endings();
    const auto had = std::ranges::max(wanted, {},
                                      [&](const std::string& one) { return has_ending(name, one) ? one.size() : 0; });
    if (has_ending(name, had)) return name.substr(0, name.size() - had.size());
    return name.substr(0, name.size() - ending_of(name).size());
}

// What is typed next takes the place of the name, not of its ending.
void PathDialog::take_name(const std::string& name)
{
    typed_ = name;
    n_marked_ = stem_of(name).size();
    wants_keyboard_ = true;
}

// The ending that the name has gives way to this one.
void PathDialog::take_ending(const std::string& ending)
{
    take_name(stem_of(typed_) + ending);
    extension_ = ending;
    refusal_.reset();
    must_confirm_overwrite_ = false;
}

void PathDialog::show_endings()
{
    const float end = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x;
    for (std::size_t i = 0; i < endings_.size(); ++i) {
        const float width = ImGui::CalcTextSize(endings_[i].c_str()).x + 2.0F * ImGui::GetStyle().FramePadding.x;
        if (i > 0 && ImGui::GetItemRectMax().x + ImGui::GetStyle().ItemSpacing.x + width <= end) ImGui::SameLine();
        if (answer_button(endings_[i])) take_ending(endings_[i]);
    }
}

std::vector<std::string> PathDialog::wanted_endings() const
{
    return endings_.empty() ? std::vector<std::string>{extension_} : endings_;
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
    const bool came_so = path.has_extension() && (is_opening() || path == start_);
    if (!came_so && ending_of(path).empty()) path += extension_;
    const bool is_kept = path == start_; // a file may go on under the name that it came with
    if (refusal_ = is_opening() || is_kept ? std::nullopt : why_not_ending(path, wanted_endings()); refusal_)
        return std::nullopt;
    const bool would_overwrite = !is_opening() && path != start_ && fs::exists(path, error);
    if (would_overwrite && !must_confirm_overwrite_) {
        must_confirm_overwrite_ = true;
        return std::nullopt;
    }
    is_open_ = false;
    return path.lexically_normal();
}

int PathDialog::mark(ImGuiInputTextCallbackData* data)
{
    const auto n = std::exchange(static_cast<PathDialog*>(data->UserData)->n_marked_, std::nullopt);
    if (!n) return 0;
    data->SelectionStart = 0;
    data->SelectionEnd = data->CursorPos = std::min(static_cast<int>(*n), data->BufTextLen);
    return 0;
}

// A question that was answered for one name is none for another.
bool PathDialog::show_field(const Catalogue& tr)
{
    ImGui::SetNextItemWidth(-1.0F);
    if (std::exchange(wants_keyboard_, false)) ImGui::SetKeyboardFocusHere();
    const bool is_confirmed = ImGui::InputTextWithHint(
        "###typed", tr("Path of the file").c_str(), &typed_,
        ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_CallbackAlways, mark, this);
    if (ImGui::IsItemEdited()) {
        must_confirm_overwrite_ = false;
        refusal_.reset();
    }
    return is_confirmed;
}

std::optional<fs::path> PathDialog::show(const Catalogue& tr)
{
    if (!is_open_) return std::nullopt;
    const auto verb = [&](std::string_view open, std::string_view save, std::string_view exported) {
        return tr(is_opening() ? open : purpose_ == Purpose::Save ? save : exported);
    };
    const std::string title = verb(translatable("Open a file"), translatable("Save as"), translatable("Export")) +
                              "###path dialog";
    if (std::exchange(is_fresh_, false)) ImGui::OpenPopup("###path dialog");
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
    if (!is_opening()) show_endings();
    if (show_field(tr)) is_confirmed = true;
    if (must_confirm_overwrite_)
        wrapped_text(verb({}, translatable("This file exists. Save again to replace it."),
                          translatable("This file exists. Export again to replace it.")));
    if (refusal_) wrapped_text(tr(*refusal_));
    const std::string button = verb(translatable("Open"), translatable("Save"), translatable("Export"));
    if (answer_button(button + "###confirm")) is_confirmed = true;
    ImGui::SameLine();
    const bool is_escaped = ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape));
    if (answer_button(tr("Cancel")) || is_escaped || !stays_open) is_open_ = false;
    std::optional<fs::path> path = is_confirmed && is_open_ ? confirm() : std::nullopt;
    const bool is_clicked_elsewhere = ImGui::IsMouseReleased(ImGuiMouseButton_Left) && !ImGui::IsAnyItemActive();
    if (is_clicked_elsewhere || (is_confirmed && !path)) wants_keyboard_ = true;
    if (!is_open_) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
    return path;
}

} // namespace ui
