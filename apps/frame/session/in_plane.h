#pragma once

#include "apps/frame/session/commands.h"

namespace frame {

/// Whether the structure lies in a plane: its nodes have two coordinates.
inline bool is_in_plane(const Workspace& workspace)
{
    return femoop::n_coordinates(workspace.session.model().analysis) == 2;
}

} // namespace frame
