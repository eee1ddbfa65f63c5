#include "apps/euler/window/player_bar.h"

#include "ui/widgets/player_bar.h"

namespace euler {

void player_bar(Workspace& workspace, const CommandTable& commands, ui::ImGuiSession& gui, const ui::Fonts& fonts)
{
    Session& session = workspace.session;
    const ui::PlayerCommands names{"step.first", "step.back", "step.play", "step.forward", "step.last"};
    const ui::PlayerSteps steps{.place = session.place(), .n = session.n_steps(), .speed = session.speed};
    const ui::PlayerChange change = ui::player_bar(workspace, commands, names, session.is_playing, steps,
                                                   ui::Theme(session.look.theme), gui, fonts);
    if (change.speed) session.speed = *change.speed;
    if (!change.place) return;
    session.is_playing = false;
    session.go_to(*change.place);
}

} // namespace euler
