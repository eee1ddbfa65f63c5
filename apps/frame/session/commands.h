#pragma once

#include "apps/frame/session/session.h"
#include "ui/command/command_table.h"

namespace frame {

/// What the user asks the window for, since the session has none: a dialog, a list, the end.
enum class Request : std::uint8_t { OpenDialog, SaveDialog, Palette, ShortcutList, Fit, ZoomIn, ZoomOut, Quit };

/// A session and what its commands ask the window for. The window takes the requests once a frame.
struct Desk {
    Session session;
    std::vector<Request> requests{};
};

using CommandTable = ui::CommandTable<Desk>;

/// Everything that the app can do, by name.
CommandTable command_table();

/// The word that a scenario and a menu use for each thing that the picture can show: "view.show.loads".
std::string_view command_id(Show item);

} // namespace frame
