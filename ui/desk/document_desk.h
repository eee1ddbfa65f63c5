#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "ui/desk/desk.h"
#include "ui/files/autosave.h"
#include "ui/paint/theme.h"
#include "ui/text/catalogue.h"

namespace ui {

/// The desk of an app that has one document open at a time; an app's own, `Own`, is derived from it. Its session knows
/// `path()`, `open(path)`, `save(path)`, `is_dirty()`, `tr()`, `look`, and
///
///     ui::Unsaved unsaved() const;                  the document, for a draft of it
///     bool recover(draft, original);                opens a draft, as a document that is not saved
///     void tell(const ui::Phrase&);                 shows a sentence
template <class Own, class Session> struct DocumentDesk : Desk {
    explicit DocumentDesk(Session first) : session(std::move(first)) {}
    ThemeName& theme() { return session.look.theme; }
    ThemeName theme() const { return session.look.theme; }
    const Catalogue& tr() const { return session.tr(); }
    void set_language(Language language) { session.look.tr = Catalogue(language); }
    void tell(const Phrase& sentence) { session.tell(sentence); }

    /// Goes on with what would lose changes: at once where there are none, else the window asks first.
    void leave_document(std::function<void(Own&)> then)
    {
        if (session.is_dirty()) after_question = std::move(then);
        else then(static_cast<Own&>(*this));
    }
    void open(const std::filesystem::path& path)
    {
        leave_document([path](Own& desk) { desk.session.open(path); });
    }

    std::vector<Unsaved> unsaved() const
    {
        return session.is_dirty() ? std::vector{session.unsaved()} : std::vector<Unsaved>{};
    }
    bool can_recover() const { return !session.is_dirty(); }
    std::optional<std::uint64_t> recover(const Leftover& leftover)
    {
        if (!session.recover(leftover.draft, leftover.original)) return std::nullopt;
        return session.unsaved().document;
    }

    Session session;
    /// What is to be done once the user has said what becomes of changes that are not saved.
    std::function<void(Own&)> after_question{};
};

} // namespace ui
