#pragma once

#include "apps/frame/session/commands.h"
#include "ui/widgets/number_field.h"
#include "ui/widgets/side_window.h"

namespace frame {

/// Where the combinations of a code are made: the code, the action that each load case is, the limit states, and below
/// them every combination with what it stands for.
class DesignWindow {
public:
    /// Nothing where none are being made.
    void show(Workspace& workspace, ui::NumberFields& fields);

private:
    ui::SideWindow window_;
};

} // namespace frame
