#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "ui/paint/theme.h"
#include "ui/text/display_units.h"

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

/// What the workspace of every app has beside its session. An app's own workspace is derived from it; its `session`
/// knows `path()` and `save(path)`, and the workspace itself
///
///     ui::ThemeName& theme();                   const ui::Catalogue& tr() const;
///     ui::ThemeName theme() const;              void set_language(ui::Language);
///     void open(path);                          a file, once nothing is lost by it
///     void notify(const ui::Message&);          shows a sentence
///     std::vector<ui::UnsavedDocument> unsaved() const;                    what a crash would cost
///     bool can_recover() const;                                            nothing is in the way of
///     std::optional<std::uint64_t> recover(const ui::RecoverableFile&);    opening what a crash has left; its document
struct Workspace {
    std::vector<Request> asked{}; ///< the window takes them once a frame
    bool has_panels = true;
    ThemeName theme_at_desk = ThemeName::Light; ///< that comes back after the projector
    std::string_view offer{};  ///< says what a linked program has changed (ui/files/linked_copy.h); "" if nothing
    double export_scale = 2.0; ///< pixels of a PNG for a logical one

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
