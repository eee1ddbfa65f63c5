#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>

namespace ui {

/// A question with two answers; `no`, which changes nothing, stands first, and Escape means it.
struct YesOrNo {
    std::string heading, sentence; ///< translated, as are the answers
    std::string no, yes;
};

/// Asks over everything else; call it in every frame until it is answered.
std::optional<bool> ask_yes_or_no(const YesOrNo& question);

/// The same of what waits for the answer: it is done, or forgotten.
template <class Workspace>
void ask_before(std::function<void(Workspace&)>& waiting, Workspace& workspace, const YesOrNo& question)
{
    const auto answer = ask_yes_or_no(question);
    if (!answer) return;
    const auto then = std::exchange(waiting, {});
    if (*answer) then(workspace);
}

} // namespace ui
