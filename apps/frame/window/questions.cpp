#include "apps/frame/window/questions.h"

#include "apps/frame/session/tabs.h"
#include "ui/widgets/unsaved_question.h"

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

bool Questions::show(Desk& desk)
{
    if (purpose_ == Purpose::None) return false;
    if (desk.session.is_dirty()) {
        ask(desk);
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

void Questions::ask(Desk& desk)
{
    const auto answer = ui::ask_about_unsaved(desk.session.file_name(), desk.session.view.tr);
    const bool wants_to_save = answer == ui::UnsavedAnswer::Save;
    const bool needs_a_name = wants_to_save && !desk.session.path();
    const bool is_hindered = wants_to_save && !needs_a_name && !desk.session.save(*desk.session.path());
    if (needs_a_name) desk.asked.push_back(ui::Request::SaveDialog);
    if (needs_a_name || is_hindered || answer == ui::UnsavedAnswer::Cancel) purpose_ = Purpose::None;
    if (answer != ui::UnsavedAnswer::GiveUp) return;
    close_tab(desk);
    if (purpose_ == Purpose::Close) purpose_ = Purpose::None;
}

} // namespace frame
