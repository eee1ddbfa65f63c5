#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace ui {

/// A question with two answers; `no`, which changes nothing, stands first, and Escape means it.
struct YesOrNo {
    std::string heading, sentence; ///< translated, as are the answers
    std::string no, yes;
};

/// Asks over everything else; call it in every frame until it is answered.
std::optional<bool> ask_yes_or_no(const YesOrNo& question);

/// While something waits in `after_exercise` for the end of an exercise that is not done: asks whether it ends, and does
/// what waits, or forgets it.
/// \param cost  what the end means, to be translated
template <class Workspace> void ask_to_end_exercise(Workspace& workspace, std::string_view cost)
{
    if (!workspace.after_exercise) return;
    const auto& tr = workspace.tr();
    const auto answer = ask_yes_or_no({.heading = tr("The exercise"),
                                       .sentence = tr(cost),
                                       .no = tr("Go on with it"),
                                       .yes = tr("End the exercise")});
    if (!answer) return;
    const auto then = std::exchange(workspace.after_exercise, {});
    if (*answer) then(workspace);
}

} // namespace ui
