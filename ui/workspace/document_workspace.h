#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "ui/files/autosave.h"
#include "ui/paint/theme.h"
#include "ui/text/catalogue.h"
#include "ui/workspace/workspace.h"

namespace ui {

/// The workspace of an app that has one document open at a time; an app's own, `Own`, is derived from it, and may have
/// a `leave_document` of its own. Its session is an OpenDocument (ui/workbench/open_document.h) with `look`,
/// `tick(seconds)` and `is_moving()`.
template <class Own, class Session> struct DocumentWorkspace : Workspace {
    explicit DocumentWorkspace(Session first) : session(std::move(first)) {}
    ThemeName& theme() { return session.look.theme; }
    ThemeName theme() const { return session.look.theme; }
    const Catalogue& tr() const { return session.tr(); }
    void set_language(Language language) { session.look.tr = Catalogue(language); }
    std::string name() const { return session.name(); }
    void notify(const Message& sentence) { session.notify(sentence); }
    void tick(double seconds) { session.tick(seconds); }
    bool is_moving() const { return session.is_moving(); }

    /// Goes on with what would lose changes: at once where there are none, else the window asks first.
    void leave_document(std::function<void(Own&)> then)
    {
        if (session.is_dirty()) after_question = std::move(then);
        else then(own());
    }
    void leave_all(std::function<void(Own&)> then) { own().leave_document(std::move(then)); }
    void open(const std::filesystem::path& path)
    {
        own().leave_document([path](Own& workspace) { workspace.open_at_once(path); });
    }
    void open_dropped(const std::vector<std::string>& files)
    {
        if (!files.empty()) own().open(files.front());
    }
    bool open_at_once(const std::filesystem::path& path) { return session.open(path); }
    bool save_as(const std::filesystem::path& path) { return session.save(path); }

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

private:
    Own& own() { return static_cast<Own&>(*this); }
};

} // namespace ui
