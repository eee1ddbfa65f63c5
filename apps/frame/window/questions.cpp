#include "apps/frame/window/questions.h"

#include "apps/frame/session/tabs.h"

namespace frame {

namespace {

// The first document that has something to lose; the present one, if it has.
std::optional<std::size_t> unsaved_tab(const Workspace& workspace)
{
    if (workspace.session.is_dirty()) return workspace.tab;
    for (std::size_t i = 0; i < n_tabs(workspace); ++i)
        if (tab(workspace, i).is_dirty()) return i;
    return std::nullopt;
}

} // namespace

bool Questions::show(Workspace& workspace, ui::Dialogs& dialogs)
{
    if (purpose_ == Purpose::None) return false;
    if (unsaved_changes_.is_naming() || workspace.session.is_dirty()) {
        ask(workspace, dialogs);
        return false;
    }
    return go_on(workspace);
}

bool Questions::go_on(Workspace& workspace)
{
    if (purpose_ == Purpose::Close) {
        close_tab(workspace);
        purpose_ = Purpose::None;
        return false;
    }
    const std::optional<std::size_t> unsaved = unsaved_tab(workspace);
    if (unsaved) show_tab(workspace, *unsaved);
    else purpose_ = Purpose::None;
    return !unsaved;
}

void Questions::ask(Workspace& workspace, ui::Dialogs& dialogs)
{
    using enum ui::UnsavedChanges::Fate;
    const auto fate = unsaved_changes_.ask(workspace.session, dialogs, workspace.session.view.tr);
    if (fate == Kept) purpose_ = Purpose::None;
    if (fate != GivenUp) return;
    close_tab(workspace);
    if (purpose_ == Purpose::Close) purpose_ = Purpose::None;
}

} // namespace frame
