#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "apps/frame/session/commands.h"

namespace frame {

/// The commands on views under names, and those that walk: through the named views, or the load cases where there are
/// none.
void add_view_commands(CommandTable& table);

/// Keeps how the document is looked at under a fresh name. \param region nothing: the whole model
void keep_view(Session& session, const std::optional<Region>& region);
/// Looks at the document so. What the view names that is there no more, as a load case, stays as it is.
void show_view(Session& session, std::size_t view);

/// Why the view cannot have this name; else it is renamed.
std::optional<ui::Message> rename_view(Session& session, std::size_t view, const std::string& name);
enum class Direction : std::uint8_t { Earlier, Later };
/// Changes places with its neighbour. \pre it has one there
void move_view(Session& session, std::size_t view, Direction way);
void erase_view(Session& session, std::size_t view);

} // namespace frame
