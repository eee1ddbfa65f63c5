#pragma once

#include <cstdint>

#include "apps/frame/session/commands.h"
#include "ui/app/dialogs.h"
#include "ui/app/unsaved_changes.h"

namespace frame {

/// Asks what to do with changes that are not saved, before a tab is closed or the program ends.
class Questions {
public:
    void ask_to_close() { purpose_ = Purpose::Close; }
    void ask_to_quit() { purpose_ = Purpose::Quit; }
    bool is_open() const { return purpose_ != Purpose::None; }

    /// Goes on with what was asked for: at once where nothing is unsaved, else with a question for each document.
    /// \returns true when the program may end
    bool show(Workspace& workspace, ui::Dialogs& dialogs);

private:
    enum class Purpose : std::uint8_t { None, Close, Quit };

    bool go_on(Workspace& workspace);
    void ask(Workspace& workspace, ui::Dialogs& dialogs);

    Purpose purpose_ = Purpose::None;
    ui::UnsavedChanges unsaved_changes_;
};

} // namespace frame
