#pragma once

#include <optional>
#include <string>

#include "apps/frame/session/commands.h"

namespace frame {

/// The list of load cases and combinations, of which one is shown in the picture. Beside its heading stands "+", which
/// opens the menu of what can be done with cases, as a right click on one of them does; a double click renames.
class CaseList {
public:
    void show(Workspace& workspace, const CommandTable& commands);
    /// The name of the case that is shown is typed next.
    void rename_shown() { begins_to_type_ = true; }

private:
    void show_heading(Workspace& workspace);
    void show_entry(Workspace& workspace, femoop::CaseId id);
    void show_name_field(Workspace& workspace, femoop::CaseId id);

    std::optional<femoop::CaseId> typed_case_; ///< whose name is being typed
    std::string name_;                         ///< as it is typed
    std::optional<ui::Message> reason_;        ///< why a case cannot have it
    bool begins_to_type_ = false;
    bool is_fresh_ = false; ///< the field waits for the keyboard
    bool opens_menu_ = false;
};

} // namespace frame
