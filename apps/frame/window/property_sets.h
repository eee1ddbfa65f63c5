#pragma once

#include <optional>
#include <string>

#include "apps/frame/session/commands.h"
#include "apps/frame/window/named_set_rows.h"

namespace frame {

/// What the panel offers for materials and sections as named sets, and for load cases and combinations.
class PropertySets {
public:
    /// The name of a material, section, load case or combination, typed anew, who has it, and what can be done with it.
    /// Nothing for other parts.
    void show(Desk& desk, const Part& part);
    /// The lists of supports and loads under names.
    void show_named(Desk& desk) { named_.show(desk); }

private:
    void show_name(Desk& desk, const Part& part);
    void show_case(Desk& desk, const Part& part);

    NamedSetLists named_;
    std::string name_;                 ///< as it is typed
    std::optional<ui::Phrase> reason_; ///< why it was not taken
};

/// Below the list of materials: small buttons that add, import and condense.
void property_buttons(Desk& desk);

} // namespace frame
