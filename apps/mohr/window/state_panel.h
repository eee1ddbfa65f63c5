#pragma once

#include "apps/mohr/session/commands.h"
#include "ui/widgets/number_field.h"

namespace mohr {

/// Everything that can be typed: the kind of state and its numbers, principal values, the plane, material and
/// criterion.
class StatePanel {
public:
    void show(Desk& desk, const CommandTable& commands);
    bool is_typing() const { return fields_.is_typing(); }

private:
    void show_kind(Desk& desk, const CommandTable& commands);
    void show_numbers(Desk& desk);
    void show_principal(Desk& desk);
    void show_space_principal(Desk& desk);
    void show_direction(Desk& desk, int direction);
    void show_plane(Desk& desk);
    void show_material(Desk& desk);
    void show_criterion(Desk& desk, const CommandTable& commands);
    void number_row(Desk& desk, const std::string& label, NumberId number);

    ui::NumberFields fields_;
};

} // namespace mohr
