#pragma once

#include "apps/frame/session/commands.h"

namespace frame {

/// The window in which units are chosen quantity by quantity.
class UnitWindow {
public:
    void toggle() { is_open_ = !is_open_; }
    /// \returns whether it was open
    bool close();
    void show(Workspace& workspace);

private:
    bool is_open_ = false;
};

} // namespace frame
