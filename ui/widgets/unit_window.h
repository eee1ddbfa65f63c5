#pragma once

#include "ui/command/chord.h"
#include "ui/text/catalogue.h"
#include "ui/text/display_units.h"
#include "ui/widgets/tab_stops.h"

namespace ui {

/// The window in which units are chosen quantity by quantity.
class UnitWindow {
public:
    void toggle() { is_open_ = !is_open_; }
    /// \returns whether it was open
    bool close();
    /// Changes the choices, of which `units` are made.
    void show(UnitChoices& choices, const DisplayUnits& units, const Catalogue& tr, TabStops& stops);
    /// A key that moves in it, opens a list or chooses is its own, and no command.
    bool wants(Key key) const;

private:
    bool is_open_ = false;
    bool has_keyboard_ = false; ///< and shows in which of its lists
};

} // namespace ui
