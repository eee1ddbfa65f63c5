#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "ui/app/settings.h"
#include "ui/files/autosave.h"
#include "ui/files/recent_files.h"
#include "ui/text/catalogue.h"
#include "ui/workspace/workspace.h"

namespace ui {

/// What an app remembers from one time to the next: the files that were opened last, drafts of what is not saved, and
/// how it was left.
class SessionStore {
public:
    /// \param folder     where it is kept; without one nothing is
    /// \param asked_for  settings of this time alone
    explicit SessionStore(const std::optional<DraftFolder>& folder, const Settings& asked_for = {});

    /// Call once a frame. `Workspace` is an app's own (workspace.h). \param window  its size [logical pixels]
    template <class Workspace> void tick(Workspace& workspace, Size window, double seconds)
    {
        if (const auto notice = keep([&workspace] { return workspace.unsaved(); }, seconds)) workspace.notify(*notice);
        can_recover_ = workspace.can_recover();
        if (can_recover_) look_for_recoverable_files(seconds);
        note(workspace.session.path());
        const Workspace& now = workspace;
        Settings settings{.theme = now.theme(),
                          .language = now.tr().language(),
                          .units = now.units(),
                          .has_panels = now.has_panels,
                          .window = window};
        if constexpr (requires { now.unit_choices(); }) settings.unit_choices = now.unit_choices();
        if constexpr (requires { now.kept_tools(); }) settings.tools = now.kept_tools();
        note(settings, seconds);
    }
    /// The program ends in good order, so no draft is needed.
    void end();

    /// Opens what is asked for; false where the request is for something else.
    bool handle_request(Request request);
    bool is_open() const { return asks_for_recent_ || shows_recoverable_files(); }
    /// Shows the list of the last files, or what a program left behind when it was killed.
    template <class Workspace> void show(Workspace& workspace)
    {
        const Catalogue tr = workspace.tr();
        if (shows_recoverable_files())
            if (const auto chosen = chosen_recoverable_file(tr)) open(workspace, *chosen);
        if (!asks_for_recent_) return;
        if (const auto chosen = chosen_file(tr)) workspace.open(*chosen);
    }

private:
    template <class Workspace> void open(Workspace& workspace, const RecoverableFile& recoverable)
    {
        auto draft = Draft::taken_over(autosave_->folder(), recoverable);
        if (!draft) return workspace.notify(translatable("this work was opened or deleted by another window"));
        if (const auto document = workspace.recover(recoverable)) autosave_->adopt(*document, std::move(draft));
    }
    std::optional<Message> keep(const std::function<std::vector<UnsavedDocument>()>& unsaved, double seconds);
    void note(const std::optional<std::filesystem::path>& file);
    void note(const Settings& now, double seconds);
    void keep_settings();
    void look_for_recoverable_files(double seconds);
    bool shows_recoverable_files() const { return can_recover_ && !recoverable_files_.empty(); }
    std::optional<std::filesystem::path> chosen_file(const Catalogue& tr);
    std::optional<RecoverableFile> chosen_recoverable_file(const Catalogue& tr);

    std::optional<Autosave> autosave_;
    std::optional<RecentFiles> recent_;
    std::vector<RecoverableFile> recoverable_files_;
    ChosenSettings chosen_;
    Settings settings_, kept_settings_; ///< as they are chosen now, and in their file
    double unkept_ = 0.0;               ///< how long they have been other ones [s]
    double age_ = 0.0;                  ///< of the program [s]
    double looked_at_ = 0.0;            ///< when leftovers were looked for last
    std::filesystem::path noted_;       ///< the last file that was put on the list
    bool can_recover_ = true;           ///< nothing is in the way of what was left behind
    bool asks_for_recent_ = false;
};

} // namespace ui
