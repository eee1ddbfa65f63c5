#pragma once

#include "apps/frame/session/commands.h"
#include "apps/frame/window/property_sets.h"
#include "ui/widgets/number_field.h"

namespace frame {

/// What is selected: its numbers, its choices and the loads on it; nothing selected: the list of parts.
void properties_panel(Desk& desk, ui::NumberFields& fields, PropertySets& sets);

} // namespace frame
