#pragma once

#include <optional>

#include "apps/frame/session/commands.h"
#include "ui/command/chord.h"
#include "ui/context/imgui_session.h"
#include "ui/paint/text_measure.h"

namespace frame {

/// The diagrams and formulas of the selected member. A line follows the pointer through all diagrams; a click pins the
/// section, which the picture of the structure reads too; the arrows move it.
class MemberPanel {
public:
    /// The one that is selected alone, else the one whose section is pinned.
    static std::optional<femoop::MemberId> member_of(const Session& session);

    /// Fills what is left of the current window of Dear ImGui's.
    void show(Workspace& workspace, ui::ImGuiSession& gui, const ui::Fonts& fonts);

    /// Left and Right move the pinned section, with Shift by a small step. False for other keys.
    bool handle_key(Session& session, const ui::Chord& chord);

private:
    void show_picture(Session& session, femoop::MemberId member, ui::ImGuiSession& gui, const ui::Fonts& fonts);
};

} // namespace frame
