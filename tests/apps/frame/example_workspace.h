#pragma once

#include <doctest/doctest.h>

#include <optional>
#include <string>
#include <string_view>

#include "apps/frame/session/tabs.h"
#include "tests/source_folder.h"

namespace frame_test {

/// A window's state with a file of examples/ open.
inline frame::Workspace workspace_with(const std::string& file)
{
    frame::Workspace workspace{frame::Session{frame::Document{}}};
    REQUIRE(open_file(workspace, source_folder() + "/examples/" + file));
    return workspace;
}

/// Carries out a command of the table; why it cannot be, in English.
inline std::optional<std::string> run(frame::Workspace& workspace, std::string_view id)
{
    const auto reason = ui::run(*frame::command_table().find(id), workspace);
    return reason ? std::optional(ui::Catalogue()(*reason)) : std::nullopt;
}

} // namespace frame_test
