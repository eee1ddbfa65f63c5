#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "apps/euler/session/session.h"
#include "topology/tables/entity_tables.h"
#include "ui/command/menu_builder.h"
#include "ui/workspace/document_workspace.h"

namespace euler {

/// What the user asks this app's window for, beside what every app's is asked for: where to look from, the keyboard
/// for the script.
enum class Request : std::uint8_t { LookFront, LookSide, LookTop, WriteScript };

/// What the panel at the left shows.
enum class Topic : std::uint8_t { Script, Operators, Gallery, Challenges };

/// The structure whose tables are seen below.
enum class Structure : std::uint8_t { HalfEdges, WingedEdges };

/// A session, the panels around its picture, and what its commands ask the window for. The window takes the requests
/// once a frame.
struct Workspace : ui::DocumentWorkspace<Workspace, Session> {
    using DocumentWorkspace::DocumentWorkspace;
    void show_table(topology::TableKind kind)
    {
        table = wanted_table = kind;
        structure = Structure::HalfEdges;
    }
    void set_panels_visible(bool are_visible) { has_panels = has_tables = are_visible; }

    std::vector<Request> requests{};
    Topic topic = Topic::Script;
    Structure structure = Structure::HalfEdges;
    topology::TableKind table = topology::TableKind::HalfEdges; ///< that is seen below: one that the step changes
    topology::TableKind wanted_table = table;                   ///< that is seen wherever the step changes it
    std::uint32_t next_challenge = 1;                           ///< what the next one is drawn from
    bool has_tables = true;
};

using CommandTable = ui::CommandTable<Workspace>;

/// Everything that the app can do, by name.
CommandTable command_table();

using TopicEntry = ui::Choice<Topic>;
std::span<const TopicEntry> topics(); ///< in the order of their tabs
using TableEntry = ui::Choice<topology::TableKind>;
std::span<const TableEntry> tables(); ///< likewise

/// A command that asks this app's window for something.
std::function<void(Workspace&)> asks(Request request);

} // namespace euler
