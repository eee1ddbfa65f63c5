#pragma once

#include "apps/frame/session/commands.h"
#include "apps/frame/window/property_sets.h"
#include "apps/frame/window/title_rows.h"
#include "ui/widgets/number_field.h"

namespace frame {

/// What the panel keeps of what is typed into it.
struct PropertyFields {
    ui::NumberFields& numbers;
    PropertySets& sets;
    TitleRows& title;
    bool begins = false; ///< the first number of what is selected gets the keyboard now
};

/// What is selected: its numbers, its choices and the loads on it, and a button that adds one; nothing selected: the
/// model's title and the list of parts.
void properties_panel(Workspace& workspace, const CommandTable& commands, const PropertyFields& fields);

} // namespace frame
