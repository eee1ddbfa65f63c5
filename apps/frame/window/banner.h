#pragma once

#include <optional>

#include "apps/frame/session/commands.h"
#include "ui/widgets/panel.h"

namespace frame {

/// What went wrong: a notice, what a linked program offers, or the first error of the model with the way to the others.
std::optional<ui::FootMessage> banner(const Workspace& workspace);
/// Shows it at the window's foot.
void show_banner(Workspace& workspace, const ui::FootMessage& message);

} // namespace frame
