#pragma once

#include <string>

#include "apps/frame/session/commands.h"
#include "ui/widgets/wrapped_field.h"

namespace frame {

/// What the whole model has, where nothing is selected: its kind, its title and its notes, each typed anew as one step.
class TitleRows {
public:
    void show(Workspace& workspace);
    /// The title is typed next.
    void begin() { begins_ = true; }

private:
    void show_title(Workspace& workspace);
    void show_notes(Workspace& workspace);

    std::string title_; ///< as it is typed
    ui::WrappedField notes_{{.least = 2, .most = 4}};
    bool begins_ = false;
};

} // namespace frame
