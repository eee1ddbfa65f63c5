#include "apps/frame/document/companion/companion_file.h"
#include "apps/frame/session/commands.h"
#include "apps/frame/session/tabs.h"
#include "femoop/files/whole_file.h"
#include "femoop/io/model_file.h"
#include "femoop/result/structure_words.h"

namespace frame {

namespace {

std::error_code write_draft(const Document& document, const std::filesystem::path& draft)
{
    if (const std::error_code error = save_companion_of(draft, document)) return error;
    return files::write_whole_file(draft, femoop::write_model(document.model));
}

ui::UnsavedDocument unsaved_of(const Session& session)
{
    return {.document = session.number(),
            .state = session.generation(),
            .original = session.path(),
            .copy =
                [&session] {
                    return [document = session.document()](const std::filesystem::path& draft) {
                        return write_draft(document, draft);
                    };
                },
            .about = [&session](const ui::Catalogue& tr) { return femoop::size_text(session.model(), tr); }};
}

} // namespace

std::vector<ui::UnsavedDocument> Workspace::unsaved() const
{
    std::vector<ui::UnsavedDocument> documents;
    for (std::size_t i = 0; i < n_tabs(*this); ++i)
        if (const Session& in = frame::tab(*this, i); in.is_dirty()) documents.push_back(unsaved_of(in));
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
