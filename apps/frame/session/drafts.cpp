#include "apps/frame/session/commands.h"
#include "apps/frame/session/tabs.h"

namespace frame {

std::vector<ui::UnsavedDocument> Workspace::unsaved() const
{
    std::vector<ui::UnsavedDocument> documents;
    for (std::size_t i = 0; i < n_tabs(*this); ++i)
        if (const Session& in = frame::tab(*this, i); in.is_dirty()) documents.push_back(in.unsaved());
    return documents;
}

std::optional<std::uint64_t> Workspace::recover(const ui::RecoverableFile& recoverable)
{
    Session recovered{Document{}};
    if (!recovered.recover(recoverable.draft, recoverable.original)) {
        session.refuse(recoverable.draft, *recovered.notice);
        return std::nullopt;
    }
    add_tab(*this, std::move(recovered));
    return session.number();
}

void Workspace::open(const std::filesystem::path& path) { open_file(*this, path); }

} // namespace frame
