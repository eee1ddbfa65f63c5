#pragma once

#include <functional>
#include <span>
#include <string_view>
#include <utility>

#include "apps/cross/report/tables.h"
#include "apps/cross/session/session.h"
#include "ui/command/menu_builder.h"
#include "ui/workspace/document_workspace.h"

namespace cross {

/// A session and the panels around its picture.
struct Workspace : ui::DocumentWorkspace<Workspace, Session> {
    using DocumentWorkspace::DocumentWorkspace;

    /// Ends the exercise: at once where it is done, else the window asks first.
    void end_exercise();

    Topic topic = Topic::Sheet;
    std::size_t first_column = 1; ///< beside the names, of a table that is too broad to be shown whole
    Seeded next_exercise{};       ///< what "New exercise" begins
    /// What is to be done once the user has said that the exercise ends.
    std::function<void(Workspace&)> after_exercise{};
};

using CommandTable = ui::CommandTable<Workspace>;

/// Everything that the app can do, by name.
CommandTable command_table();

using TopicEntry = ui::Choice<Topic>;
std::span<const TopicEntry> topics();

/// Nothing where there is no such node, or none that can be balanced.
std::optional<femoop::cross::JointId> joint_named(const Session& session, std::string_view name);

} // namespace cross
