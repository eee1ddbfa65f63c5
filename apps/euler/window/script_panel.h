#pragma once

#include <cstddef>
#include <optional>

#include "apps/euler/session/commands.h"
#include "ui/widgets/kept_field.h"

namespace euler {

/// The steps of the script as lines, the present one marked; a click goes there, and one more line is written below
/// them. While the script is edited as text, that text stands in their place.
class ScriptPanel {
public:
    ScriptPanel();
    void show(Workspace& workspace, const CommandTable& commands);
    void grab_keyboard() { wants_keyboard_ = true; }
    void go_to_line(std::size_t line) { line_to_go_to_ = line; } ///< of the text, from 1, with the cursor
    void settle(Session& session);                               ///< the line that is half typed is done
    bool has_line() const { return !line_.text().empty(); }      ///< one that is not done
    /// Something is written into it.
    bool is_typing() const { return is_typing_; }

private:
    void write_line(Session& session);
    void edit_text(Session& session, float height);
    void mark_faulty_line(const Session& session) const;
    static int on_text_event(ImGuiInputTextCallbackData* data);

    ui::KeptField line_;
    std::optional<std::size_t> line_to_go_to_;
    bool wants_keyboard_ = false;
    bool is_typing_ = false;
};

} // namespace euler
