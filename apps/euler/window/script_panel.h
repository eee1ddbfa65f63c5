#pragma once

#include <string>

#include "apps/euler/session/commands.h"

namespace euler {

/// The steps of the script as lines, the present one marked; a click goes there, and one more line is written below
/// them. While the script is edited as text, that text stands in their place.
class ScriptPanel {
public:
    void show(Desk& desk, const CommandTable& commands);
    void take_keyboard() { wants_keyboard_ = true; }
    /// Something is written into it.
    bool is_typing() const { return is_typing_; }

private:
    void write_line(Session& session);
    void edit_text(Session& session, float height);

    std::string line_;
    bool wants_keyboard_ = false;
    bool is_typing_ = false;
};

} // namespace euler
