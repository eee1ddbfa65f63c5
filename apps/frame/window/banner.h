#pragma once

#include <optional>

#include "apps/frame/session/commands.h"
#include "ui/widgets/panel.h"

namespace frame {

/// What went wrong: a notice, what a linked program offers, or the first error of the model with the way to the others.
std::optional<ui::FootMessage> banner(const Workspace& workspace);
/// Does what was pressed of it.
void answer_banner(Workspace& workspace, const ui::FootMessage& message, std::size_t pressed);

} // namespace frame
