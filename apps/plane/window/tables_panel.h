#pragma once

#include <string>
#include <vector>

#include "apps/plane/session/commands.h"
#include "apps/plane/window/properties_panel.h"
#include "ui/widgets/number_field.h"

namespace plane {

/// The panel at the bottom of the window: points, curves, regions, materials and load cases in rows, whose numbers are
/// typed as in the panel of properties. A click on a name selects.
class TablesPanel {
public:
    /// Of the panel [physical pixels]; 0 while it is closed.
    float height(const Workspace& workspace, float room) const;
    void show(Workspace& workspace, const CommandTable& commands);
    bool is_typing() const { return fields_.is_typing(); }

private:
    ui::NumberFields fields_;
};

} // namespace plane
