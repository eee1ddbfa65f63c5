#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "ui/app/settings.h"
#include "ui/desk/desk.h"
#include "ui/files/autosave.h"
#include "ui/files/recent_files.h"
#include "ui/text/catalogue.h"

namespace ui {

/// What an app remembers from one time to the next: the files that were opened last, drafts of what is not saved, and
/// how it was left.
class KeptFiles {
public:
    /// \param folder where it is kept; without one nothing is
    explicit KeptFiles(const std::optional<DraftFolder>& folder);

    /// Call once a frame. `Desk` is an app's own (desk.h). \param window  its size [logical pixels]
    template <class Desk> void tick(Desk& desk, Size window, double seconds)
    {
        if (const auto told = keep([&desk] { return desk.unsaved(); }, seconds)) desk.tell(*told);
        can_recover_ = desk.can_recover();
        if (can_recover_) look_for_leftovers(seconds);
        note(desk.session.path());
        const Desk& now = desk;
        Settings settings{.theme = now.theme(),
                          .language = now.tr().language(),
                          .units = now.units(),
                          .has_panels = now.has_panels,
                          .window = window};
        if constexpr (requires { now.kept_tools(); }) settings.tools = now.kept_tools();
        note(settings, seconds);
    }
    /// The program ends in good order, so no draft is needed.
    void end();

    /// Opens what is asked for; false where the request is for something else.
    bool take(Request request);
    bool is_open() const { return asks_for_recent_ || shows_leftovers(); }
    /// Shows the list of the last files, or what a program left behind when it was killed.
    template <class Desk> void show(Desk& desk)
    {
        const Catalogue tr = desk.tr();
        if (shows_leftovers())
            if (const auto chosen = chosen_leftover(tr)) open(desk, *chosen);
        if (!asks_for_recent_) return;
        if (const auto chosen = chosen_file(tr)) desk.open(*chosen);
    }

private:
    template <class Desk> void open(Desk& desk, const Leftover& leftover)
    {
        auto draft = Draft::taken_over(autosave_->folder(), leftover);
        if (!draft) return desk.tell(translatable("this work was opened or deleted by another window"));
        if (const auto document = desk.recover(leftover)) autosave_->adopt(*document, std::move(draft));
    }
    std::optional<Phrase> keep(const std::function<std::vector<Unsaved>()>& unsaved, double seconds);
    void note(const std::optional<std::filesystem::path>& file);
    void note(const Settings& settings, double seconds);
    void keep_settings();
    void look_for_leftovers(double seconds);
    bool shows_leftovers() const { return can_recover_ && !leftovers_.empty(); }
    std::optional<std::filesystem::path> chosen_file(const Catalogue& tr);
    std::optional<Leftover> chosen_leftover(const Catalogue& tr);

    std::optional<Autosave> autosave_;
    std::optional<RecentFiles> recent_;
    std::vector<Leftover> leftovers_;
    Settings settings_, kept_settings_; ///< as they are now, and in their file
    double unkept_ = 0.0;               ///< how long they have been other ones [s]
    double age_ = 0.0;                  ///< of the program [s]
    double looked_at_ = 0.0;            ///< when leftovers were looked for last
    std::filesystem::path noted_;       ///< the last file that was put on the list
    bool can_recover_ = true;           ///< nothing is in the way of what was left behind
    bool asks_for_recent_ = false;
};

} // namespace ui
