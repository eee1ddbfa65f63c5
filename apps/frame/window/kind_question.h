#pragma once

#include "apps/frame/session/commands.h"

namespace frame {

/// Asks what kind of structure the document that was just begun is to be: a click or the keys 1 to 5. Whoever goes on
/// without an answer - draws, presses another key, clicks beside it - has the plane frame that it is.
class KindQuestion {
public:
    void open() { is_open_ = true; }
    bool is_open() const { return is_open_; }
    void show(Workspace& workspace, const CommandTable& commands);
    /// \returns whether the key was an answer; any other ends the question
    bool handle_key(Workspace& workspace, const CommandTable& commands, ui::Key key);

private:
    bool is_open_ = false;
};

} // namespace frame
