#pragma once

#include <memory>
#include <span>

#include "apps/frame/session/bottom_view.h"
#include "apps/frame/session/section_draft.h"
#include "apps/frame/session/session.h"
#include "apps/frame/session/transform.h"
#include "apps/frame/session/typical_draft.h"
#include "apps/frame/tools/hand.h"
#include "ui/command/command_table.h"

namespace frame {

/// What the user asks the window for, since the session has none: a dialog, a list, the end.
enum class Request : std::uint8_t {
    OpenDialog,
    SaveDialog,
    ExportDialog,
    CopyPicture,
    ImportDialog,
    RecentList,
    Description,
    KeepView,
    ViewList,
    CloseTab,
    ExportTable,
    Palette,
    ShortcutList,
    Fit,
    ZoomIn,
    ZoomOut,
    Quit
};

/// What the panel at the right shows.
enum class Topic : std::uint8_t { Properties, Results, Problems, History };

/// A session, the panels around its picture, and what its commands ask the window for. The window takes the requests
/// once a frame.
struct Desk {
    Session session;
    Hand hand{};
    std::vector<Session> shelf{};                ///< the other tabs in their order (tabs.h)
    std::size_t tab = 0;                         ///< place of the session among the tabs
    std::shared_ptr<const Clipping> clipboard{}; ///< what was copied last; null before that
    std::optional<Transform> transform{};        ///< under way: its numbers can still change
    TypicalDraft typical{};
    SectionDraft section{};
    std::vector<Request> requests{};
    Topic topic = Topic::Properties;
    bool has_panels = true;
    BottomView bottom{};
    double export_scale = 2.0; ///< pixels of a PNG for a logical one
};

using CommandTable = ui::CommandTable<Desk>;

/// Everything that the app can do, by name.
CommandTable command_table();

/// The commands that choose what the panel at the right shows, in the order of its tabs.
struct TopicEntry {
    Topic topic;
    std::string_view id, label;
};
std::span<const TopicEntry> topics();

/// The word that a scenario and a menu use for each thing that the picture can show: "view.show.loads".
std::string_view command_id(Show item);

} // namespace frame
