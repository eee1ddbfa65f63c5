#pragma once

#include "apps/frame/session/commands.h"
#include "ui/command/chord.h"
#include "ui/widgets/tab_stops.h"

namespace frame {

/// The window in which units are chosen quantity by quantity.
class UnitWindow {
public:
    void toggle() { is_open_ = !is_open_; }
    /// \returns whether it was open
    bool close();
    void show(Workspace& workspace, ui::TabStops& stops);
    /// A key that moves in it, opens a list or chooses is its own, and no command.
    bool wants(ui::Key key) const;

private:
    bool is_open_ = false;
    bool has_keyboard_ = false; ///< and shows in which of its lists
};

} // namespace frame
