#pragma once

#include <span>

#include "apps/frame/session/session.h"

namespace frame {

/// What can be chosen for parts besides their numbers: supports, hinges, materials, releases, axes of loads. A choice
/// is made for all of them at once; what differs among them is shown as mixed. \pre all parts are of one kind
void show_choices(Session& session, std::span<const Part> parts);

} // namespace frame
