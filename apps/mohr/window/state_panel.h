#pragma once

#include "apps/mohr/session/commands.h"
#include "ui/widgets/number_field.h"

namespace mohr {

/// Everything that can be typed: the kind of state and its numbers, principal values, the plane, material and
/// criterion.
class StatePanel {
public:
    void show(Workspace& workspace, const CommandTable& commands);
    bool is_typing() const { return fields_.is_typing(); }

private:
    void show_kind(Workspace& workspace, const CommandTable& commands);
    void show_numbers(Workspace& workspace);
    void show_principal(Workspace& workspace);
    void show_space_principal(Workspace& workspace);
    void show_direction(Workspace& workspace, int direction);
    void show_plane(Workspace& workspace);
    void show_material(Workspace& workspace);
    void show_criterion(Workspace& workspace, const CommandTable& commands);
    void number_row(Workspace& workspace, const std::string& label, NumberId number);

    ui::NumberFields fields_;
};

} // namespace mohr
