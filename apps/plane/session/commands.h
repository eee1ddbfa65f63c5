#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "apps/plane/session/session.h"
#include "apps/plane/tools/hand.h"
#include "ui/command/menu_builder.h"
#include "ui/workspace/document_workspace.h"

namespace plane {

/// What the panel at the right shows.
enum class Topic : std::uint8_t { Properties, Model, Problems };

/// A list of entries that is shown at the bottom.
enum class TableKind : std::uint8_t { Points, Curves, Regions, Materials, Cases, Combinations, Reactions, Modes };

/// A session, the hand that works in it, and the panels around its picture.
struct Workspace : ui::DocumentWorkspace<Workspace, Session> {
    /// An image without a drawing and a file is yet to be placed.
    explicit Workspace(Session first);

    /// The curves of a DXF or SVG file join the drawing, which loses nothing by it; another file is opened in its place.
    void open(const std::filesystem::path& path);
    bool open_at_once(const std::filesystem::path& path);
    bool insert_outline(const std::filesystem::path& path); ///< all is shown then; false, with a notice, if it cannot

    std::optional<ui::UnitSystem> units() const { return session.look.units; }
    const ui::UnitChoices& unit_choices() const { return session.look.unit_choices; }

    /// Carries it out, or tells why not. \returns why not
    std::optional<ui::Message> change(const Change& change);
    /// Draws what the hand has ended.
    void draw(const std::optional<CurveDraft>& drawn);
    /// The backdrop comes where the hand has told.
    void align(const std::optional<Alignment>& told);
    bool insert_backdrop(const std::filesystem::path& path); ///< likewise, and its scale is asked for

    Hand hand;
    bool asks_for_outline = false;  ///< the window takes it, and asks for a file to insert
    bool asks_for_backdrop = false; ///< likewise, for an image
    bool asks_for_units = false;    ///< likewise, and shows the units quantity by quantity or hides them
    Topic topic = Topic::Properties;
    std::optional<TableKind> table{};     ///< that is shown; none while the tables are closed
    bool Look::*shown_by_table = nullptr; ///< what the open table has switched on, for as long as it is open
};

using CommandTable = ui::CommandTable<Workspace>;

/// Everything that the app can do, by name.
CommandTable command_table();

using TopicEntry = ui::Choice<Topic>;
std::span<const TopicEntry> topics(); ///< in the order of their tabs
using FieldEntry = ui::Choice<std::optional<femoop::plane::PlaneComponent>>;
std::span<const FieldEntry> fields(); ///< that bands can show, none first
using TableEntry = ui::Choice<TableKind>;
std::span<const TableEntry> tables(); ///< in the order of their tabs
using ToolEntry = ui::Choice<ToolKind>;
std::span<const ToolEntry> tools(); ///< in the order of their buttons

} // namespace plane
