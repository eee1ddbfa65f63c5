#include "ui/app/session_store.h"

#include <imgui.h>

#include <string>
#include <system_error>

#include "femoop/files/whole_file.h"
#include "ui/app/app_options.h"
#include "ui/text/shortened.h"
#include "ui/widgets/answer_button.h"
#include "ui/widgets/item_label.h"
#include "ui/widgets/modal_turn.h"
#include "ui/widgets/tooltip.h"

namespace ui {

SessionStore::SessionStore(const std::optional<DraftFolder>& folder, const Settings& asked_for)
{
    if (!folder) return;
    autosave_.emplace(*folder);
    recent_.emplace(folder->path / "recent");
    recoverable_files_ = autosave_->new_recoverable_files();
    settings_ = kept_settings_ = read_settings(settings_file(*folder));
    chosen_ = ChosenSettings(kept_settings_, asked_for);
}

std::optional<Message> SessionStore::keep(const std::function<std::vector<UnsavedDocument>()>& unsaved, double seconds)
{
    return autosave_ ? autosave_->tick(unsaved, seconds) : std::nullopt;
}

void SessionStore::note(const std::optional<std::filesystem::path>& file)
{
    if (!recent_ || !file || *file == noted_) return;
    noted_ = *file;
    recent_->add(*file);
}

// While a window is drawn larger nothing is written.
void SessionStore::note(const Settings& now, double seconds)
{
    constexpr double patience = 1.0; // s
    const Settings& chosen = chosen_.update(now);
    unkept_ = chosen == settings_ ? unkept_ + seconds : 0.0;
    settings_ = chosen;
    if (unkept_ > patience) keep_settings();
}

void SessionStore::keep_settings()
{
    if (!autosave_ || settings_ == kept_settings_) return;
    kept_settings_ = settings_; // what cannot be written is no reason to stop
    const DraftFolder& folder = autosave_->folder();
    std::error_code error;
    std::filesystem::create_directories(folder.path, error);
    (void)files::write_whole_file(settings_file(folder), settings_text(settings_));
}

// Who starts the program again right after it was killed must not miss the draft that the dying one still holds; later
// nobody is interrupted.
void SessionStore::look_for_recoverable_files(double seconds)
{
    constexpr double patience = 60.0, interval = 2.0; // s
    age_ += seconds;
    if (!autosave_ || age_ > patience || age_ - looked_at_ < interval) return;
    looked_at_ = age_;
    const std::vector<RecoverableFile> found = autosave_->new_recoverable_files();
    recoverable_files_.insert(recoverable_files_.end(), found.begin(), found.end());
}

void SessionStore::end()
{
    keep_settings();
    if (autosave_) autosave_->forget_all();
    autosave_.reset(); // else the frame that ends the program would begin again
}

bool SessionStore::handle_request(Request request)
{
    asks_for_recent_ |= request == Request::RecentList;
    return request == Request::RecentList;
}

namespace {

// A window over all others in the middle of the screen; it must be ended where it is open.
bool begin_modal(const std::string& heading, const char* id)
{
    if (!has_turn(id)) return false;
    ImGui::OpenPopup(id);
    ImGui::SetNextWindowPos(ImGui::GetMainViewport()->GetCenter(), ImGuiCond_Appearing, {0.5F, 0.5F});
    return ImGui::BeginPopupModal((heading + id).c_str(), nullptr, ImGuiWindowFlags_AlwaysAutoResize);
}

// The name first, since a long folder may end beyond the window.
std::string name_and_folder(const std::filesystem::path& path)
{
    return path.filename().string() + "   –   " + path.parent_path().string();
}

// Documents without a name are told apart by when they were kept, and by what they hold.
std::string name_of(const RecoverableFile& recoverable, const Catalogue& tr)
{
    std::string name = time_of(recoverable) + "   ";
    name += recoverable.original ? name_and_folder(*recoverable.original) : tr("Untitled");
    const auto language = static_cast<std::size_t>(tr.language());
    const bool is_told = language < recoverable.about.size() && !recoverable.about[language].empty();
    return is_told ? name + "   –   " + recoverable.about[language] : name;
}

// As much as the screen has room for behind the buttons; the pointer on it has the whole.
void row_text(const std::string& words)
{
    constexpr std::size_t least_letters = 8;
    const float beside = ImGui::GetCursorScreenPos().x - ImGui::GetWindowPos().x + 2.0F * ImGui::GetFontSize();
    const float room = ImGui::GetMainViewport()->WorkSize.x - beside;
    const std::string shown = shortened_to_fit(
        words, least_letters, [&](const std::string& text) { return ImGui::CalcTextSize(text.c_str()).x <= room; });
    ImGui::TextUnformatted((shown.empty() ? words : shown).c_str());
    if (shown != words && ImGui::IsItemHovered()) show_tooltip(words);
}

bool is_escaped() { return ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape)); }

} // namespace

std::optional<std::filesystem::path> SessionStore::chosen_file(const Catalogue& tr)
{
    if (!begin_modal(tr("The last files"), "###recent")) return std::nullopt;
    const bool is_empty = !recent_ || recent_->paths().empty();
    if (is_empty) ImGui::TextUnformatted(tr("No file was opened or saved yet.").c_str());
    std::optional<std::filesystem::path> chosen;
    for (std::size_t i = 0; !is_empty && i < recent_->paths().size(); ++i) {
        const std::filesystem::path& path = recent_->paths()[i];
        if (ImGui::Selectable(item_label(name_and_folder(path), std::to_string(i)).c_str())) chosen = path;
    }
    ImGui::Spacing();
    asks_for_recent_ = !(answer_button(tr("Cancel") + "###cancel") || is_escaped() || chosen);
    if (!asks_for_recent_) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
    return chosen;
}

std::optional<RecoverableFile> SessionStore::chosen_recoverable_file(const Catalogue& tr)
{
    if (!begin_modal(tr("Unsaved work was found"), "###leftovers")) return std::nullopt;
    ImGui::TextUnformatted(tr("The program ended before this was saved.").c_str());
    std::optional<RecoverableFile> opened, deleted;
    for (std::size_t i = 0; i < recoverable_files_.size(); ++i) {
        const RecoverableFile& recoverable = recoverable_files_[i];
        ImGui::PushID(static_cast<int>(i));
        if (answer_button(tr("Open") + "###open")) opened = recoverable;
        ImGui::SameLine();
        if (answer_button(tr("Delete") + "###delete")) deleted = recoverable;
        ImGui::SameLine();
        row_text(name_of(recoverable, tr));
        ImGui::PopID();
    }
    if (deleted)
        if (const auto draft = Draft::taken_over(autosave_->folder(), *deleted)) draft->forget();
    std::erase_if(recoverable_files_, [&](const RecoverableFile& recoverable) {
        return (opened && recoverable.draft == opened->draft) || (deleted && recoverable.draft == deleted->draft);
    });
    ImGui::Spacing();
    const bool later = answer_button(tr("Later") + "###later") || is_escaped();
    if (later) recoverable_files_.clear();
    if (recoverable_files_.empty() || opened) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
    return opened;
}

} // namespace ui
