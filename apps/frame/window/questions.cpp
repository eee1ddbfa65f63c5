#include "apps/frame/window/questions.h"

#include "apps/frame/session/tabs.h"

namespace frame {

namespace {

// The first document that has something to lose; the present one, if it has.
std::optional<std::size_t> unsaved_tab(const Desk& desk)
{
    if (desk.session.is_dirty()) return desk.tab;
    for (std::size_t i = 0; i < n_tabs(desk); ++i)
        if (tab(desk, i).is_dirty()) return i;
    return std::nullopt;
}

} // namespace

bool Questions::show(Desk& desk, ui::Overlays& overlays)
{
    if (purpose_ == Purpose::None) return false;
    if (unsaved_changes_.is_naming() || desk.session.is_dirty()) {
        ask(desk, overlays);
        return false;
    }
    return go_on(desk);
}

bool Questions::go_on(Desk& desk)
{
    if (purpose_ == Purpose::Close) {
        close_tab(desk);
        purpose_ = Purpose::None;
        return false;
    }
    const std::optional<std::size_t> unsaved = unsaved_tab(desk);
    if (unsaved) show_tab(desk, *unsaved);
    else purpose_ = Purpose::None;
    return !unsaved;
}

void Questions::ask(Desk& desk, ui::Overlays& overlays)
{
    using enum ui::UnsavedChanges::Fate;
    const auto fate = unsaved_changes_.ask(desk.session, overlays, desk.session.view.tr);
    if (fate == Kept) purpose_ = Purpose::None;
    if (fate != GivenUp) return;
    close_tab(desk);
    if (purpose_ == Purpose::Close) purpose_ = Purpose::None;
}

} // namespace frame
