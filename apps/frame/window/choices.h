#pragma once

#include <span>

#include "apps/frame/session/commands.h"
#include "ui/widgets/number_field.h"

namespace frame {

/// What can be chosen for parts besides their numbers: supports, hinges, materials, releases, axes of loads. A choice
/// is made for all of them at once; what differs among them is shown as mixed. The numbers that a choice brings, depths
/// of tapered members, stand below it, so that it stays under the pointer. \pre all parts are of one kind
void show_choices(Workspace& workspace, ui::NumberFields& fields, std::span<const Part> parts);

} // namespace frame
