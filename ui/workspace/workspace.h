#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "ui/paint/theme.h"
#include "ui/text/display_units.h"
#include "ui/workspace/export_to_app.h"

namespace ui {

/// What the user asks the window of every app for, since a session has none: a dialog, a list, the end.
enum class Request : std::uint8_t {
    OpenDialog,
    RecentList,
    SaveDialog,
    ExportDialog,
    CopyPicture,
    Description,
    Palette,
    ShortcutList,
    Fit,
    ZoomIn,
    ZoomOut,
    TakeOver,
    KeepAsItIs,
    Quit
};

/// What the workspace of every app has beside its session, the document that is shown: the only one that is open
/// (document_workspace.h), or one of several. An app's own workspace is derived from it; its `session` knows `path()`,
/// `save(path)`, `is_dirty()`, `tr()` and `notice`, and the workspace itself
///
///     ui::ThemeName& theme();                   const ui::Catalogue& tr() const;
///     ui::ThemeName theme() const;              void set_language(ui::Language);
///     std::string name() const;                 of what is shown
///     void notify(const ui::Message&);          shows a sentence
///     void tick(double seconds);                time goes by
///     bool is_moving() const;                   frames must follow one another
///     void open(path);                          a file, once nothing is lost by it
///     void open_dropped(paths);                 files that were dropped on the window
///     bool open_at_once(path);                  whatever is lost by it
///     bool save_as(path);
///     void leave_all(then);                     goes on once nothing that is open is lost by it
///     std::function<void(Own&)> after_question; what goes on once the user has said what becomes of the session
///     std::vector<ui::UnsavedDocument> unsaved() const;                    what a crash would cost
///     bool can_recover() const;                                            nothing is in the way of
///     std::optional<std::uint64_t> recover(const ui::RecoverableFile&);    opening what a crash has left; its document
struct Workspace {
    std::vector<Request> asked{}; ///< the window takes them once a frame
    bool has_panels = true;
    ThemeName theme_at_desk = ThemeName::Light; ///< that comes back after the projector
    std::string_view offer{};  ///< says what a linked program has changed (ui/files/linked_copy.h); "" if nothing
    double export_scale = 2.0; ///< pixels of a PNG for a logical one
    std::vector<ExportToApp> handed{}; ///< what other programs are to go on with; taken like `asked`

    /// All of them; without them the picture has the whole window. An app that has more hides them too.
    void set_panels_visible(bool are_visible) { has_panels = are_visible; }

    /// What numbers are shown in, of an app that has a choice.
    static std::optional<UnitSystem> units() { return std::nullopt; }
};

/// A command that asks the window for something.
inline std::function<void(Workspace&)> asks(Request request)
{
    return [request](Workspace& workspace) { workspace.asked.push_back(request); };
}

} // namespace ui
