#pragma once

#include "apps/frame/session/commands.h"

namespace frame {

/// The commands that suit what is selected, in a menu at the pointer: loads, settlements and springs first; where
/// nothing is selected what begins something.
class ContextMenu {
public:
    void open() { opens_ = true; }
    void show(Workspace& workspace, const CommandTable& commands);

private:
    bool opens_ = false;
};

/// A button that opens the loads that the selected nodes or members can have, in the panel of their properties.
void add_load_button(Workspace& workspace, const CommandTable& commands);

} // namespace frame
