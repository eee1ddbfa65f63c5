#include "apps/frame/session/autosave.h"

#include <algorithm>
#include <utility>

#include "apps/frame/session/tabs.h"

namespace frame {

void Autosave::tick(const Desk& desk, double seconds)
{
    waited_ += seconds;
    if (waited_ < interval) return;
    waited_ = 0.0;
    std::vector<std::uint64_t> dirty;
    for (std::size_t i = 0; i < n_tabs(desk); ++i) {
        const Session& session = tab(desk, i);
        if (!session.is_dirty()) continue;
        dirty.push_back(session.number());
        keep(session);
    }
    std::erase_if(drafts_, [&](auto& entry) {
        const bool is_over = std::ranges::find(dirty, entry.first) == dirty.end();
        if (is_over) entry.second.recovery->forget();
        return is_over;
    });
}

void Autosave::keep(const Session& session)
{
    Draft& draft = drafts_[session.number()];
    if (!draft.recovery) draft.recovery = std::make_unique<Recovery>(folder_);
    else if (draft.generation == session.generation()) return;
    // What hinders it (a full disk, a folder that is not writable) must not hinder the work: the next tick tries again.
    if (!draft.recovery->keep(session.document(), session.path())) draft.generation = session.generation();
}

std::vector<Leftover> Autosave::new_leftovers()
{
    std::vector<Leftover> found = Recovery(folder_).leftovers();
    std::erase_if(found, [&](const Leftover& leftover) { return !told_.insert(leftover.draft).second; });
    return found;
}

void Autosave::forget_all()
{
    for (auto& [number, draft] : drafts_) draft.recovery->forget();
    drafts_.clear();
}

bool open_leftover(Desk& desk, const Leftover& leftover)
{
    Session session{Document{}};
    if (!session.recover(leftover.draft, leftover.original)) {
        desk.session.refuse(leftover.draft, *session.notice);
        return false;
    }
    add_tab(desk, std::move(session));
    Recovery::discard(leftover);
    return true;
}

} // namespace frame
