#pragma once

#include "apps/cross/session/commands.h"
#include "ui/widgets/number_field.h"

namespace cross {

/// How the sheets are worked: load case, order, digits, tolerance, far ends, signs; which sheet is worked on; and the
/// ways that were gone so far.
class MethodPanel {
public:
    void show(Workspace& workspace, const CommandTable& commands);
    bool is_typing() const { return fields_.is_typing(); }

private:
    void show_own_order(Workspace& workspace);
    void show_tolerance(Workspace& workspace);

    ui::NumberFields fields_;
};

} // namespace cross
