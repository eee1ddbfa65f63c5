#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include "apps/euler/session/session.h"
#include "topology/tables/entity_tables.h"
#include "ui/command/command_table.h"

namespace euler {

/// What the user asks the window for, since the session has none: a dialog, a list, the end.
enum class Request : std::uint8_t {
    OpenDialog,
    SaveDialog,
    ExportDialog,
    CopyPicture,
    Palette,
    ShortcutList,
    Description,
    Fit,
    ZoomIn,
    ZoomOut,
    LookIsometric,
    LookFront,
    LookSide,
    LookTop,
    Quit
};

/// What the panel at the left shows.
enum class Topic : std::uint8_t { Script, Operators, Gallery, Challenges };

/// The structure whose tables are seen below.
enum class Structure : std::uint8_t { HalfEdges, WingedEdges };

/// A session, the panels around its picture, and what its commands ask the window for. The window takes the requests
/// once a frame.
struct Desk {
    Session session{};
    std::vector<Request> requests{};
    /// What is to be done once the user has said what becomes of steps that are not saved.
    std::function<void(Desk&)> after_question{};
    Topic topic = Topic::Script;
    Structure structure = Structure::HalfEdges;
    topology::TableKind table = topology::TableKind::HalfEdges; ///< that is seen below
    std::uint32_t next_challenge = 1;                           ///< what the next one is drawn from
    bool has_panels = true;
    bool has_tables = true;
    double export_scale = 2.0; ///< pixels of a PNG for a logical one
};

using CommandTable = ui::CommandTable<Desk>;

/// Everything that the app can do, by name.
CommandTable command_table();

struct TopicEntry {
    Topic topic;
    std::string_view id, label;
};
std::span<const TopicEntry> topics(); ///< in the order of their tabs
struct TableEntry {
    topology::TableKind table;
    std::string_view id, label;
};
std::span<const TableEntry> tables(); ///< likewise

/// A command that asks the window for something.
std::function<void(Desk&)> asks(Request request);
/// Goes on with what would lose steps that are not saved: at once where there are none, else the window asks first.
void leave_lesson(Desk& desk, std::function<void(Desk&)> then);

} // namespace euler
