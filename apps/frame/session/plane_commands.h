#pragma once

#include <span>
#include <string_view>

#include "apps/frame/session/commands.h"

namespace frame {

/// The commands that choose the working plane of what is drawn in space; through a node where one is selected.
void add_plane_commands(CommandTable& table);

struct PlaneEntry {
    WorkingPlane::Normal normal;
    std::string_view id, label, name; ///< "xy"
};
/// In the order of the tool bar.
std::span<const PlaneEntry> working_planes();

} // namespace frame
