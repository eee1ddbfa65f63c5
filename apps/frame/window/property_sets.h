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
    void show(Workspace& workspace, const Part& part);
    /// The lists of supports and loads under names.
    void show_named(Workspace& workspace) { named_.show(workspace); }

private:
    void show_name(Workspace& workspace, const Part& part);
    void show_case(Workspace& workspace, const Part& part);

    NamedSetLists named_;
    std::string name_;                  ///< as it is typed
    std::optional<ui::Message> reason_; ///< why it was not taken
};

/// Below the list of materials: small buttons that add, import and condense.
void property_buttons(Workspace& workspace);

} // namespace frame
