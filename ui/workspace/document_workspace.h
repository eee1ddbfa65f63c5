#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "ui/files/autosave.h"
#include "ui/paint/theme.h"
#include "ui/text/catalogue.h"
#include "ui/workspace/workspace.h"

namespace ui {

/// The workspace of an app that has one document open at a time; an app's own, `Own`, is derived from it. Its session
/// knows `path()`, `open(path)`, `save(path)`, `is_dirty()`, `tr()`, `look`, and
///
///     ui::UnsavedDocument unsaved() const;          the document, for a draft of it
///     bool recover(draft, original);                opens a draft, as a document that is not saved
///     void notify(const ui::Message&);              shows a sentence
template <class Own, class Session> struct DocumentWorkspace : Workspace {
    explicit DocumentWorkspace(Session first) : session(std::move(first)) {}
    ThemeName& theme() { return session.look.theme; }
    ThemeName theme() const { return session.look.theme; }
    const Catalogue& tr() const { return session.tr(); }
    void set_language(Language language) { session.look.tr = Catalogue(language); }
    void notify(const Message& sentence) { session.notify(sentence); }

    /// Goes on with what would lose changes: at once where there are none, else the window asks first.
    void leave_document(std::function<void(Own&)> then)
    {
        if (session.is_dirty()) after_question = std::move(then);
        else then(static_cast<Own&>(*this));
    }
    void open(const std::filesystem::path& path)
    {
        leave_document([path](Own& workspace) { workspace.session.open(path); });
    }

    std::vector<UnsavedDocument> unsaved() const
    {
        return session.is_dirty() ? std::vector{session.unsaved()} : std::vector<UnsavedDocument>{};
    }
    bool can_recover() const { return !session.is_dirty(); }
    std::optional<std::uint64_t> recover(const RecoverableFile& recoverable)
    {
        if (!session.recover(recoverable.draft, recoverable.original)) return std::nullopt;
        return session.unsaved().document;
    }

    Session session;
    /// What is to be done once the user has said what becomes of changes that are not saved.
    std::function<void(Own&)> after_question{};
};

} // namespace ui
