#pragma once

#include "apps/frame/session/commands.h"
#include "ui/command/chord.h"
#include "ui/context/imgui_session.h"
#include "ui/paint/text_measure.h"

namespace frame {

/// Where a number of the results comes from, in what is left of the current window of Dear ImGui's: a bar with the
/// steps, the numbers of the same place and the ways to copy, and the picture of the step
/// (apps/frame/view/derivation/derivation_picture.h). It follows every edit; where the number's place is gone it closes
/// with a notice.
void derivation_panel(Workspace& workspace, const CommandTable& commands, ui::ImGuiSession& gui,
                      const ui::Fonts& fonts);

/// PageUp, PageDown and Esc, whoever has the keyboard: the step before, the one after, the end. False for other keys.
bool handle_presenter_key(Workspace& workspace, const ui::Chord& chord);
/// And where the panel has it: Left, Right, Home, End go through the steps, Up and Down through the numbers of the same
/// place.
bool handle_derivation_key(Workspace& workspace, const ui::Chord& chord);

} // namespace frame
