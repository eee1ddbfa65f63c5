#pragma once

#include <cstdint>
#include <optional>

#include "ui/app/dialogs.h"
#include "ui/text/catalogue.h"
#include "ui/widgets/unsaved_question.h"

namespace ui {

/// What becomes of changes that are not saved, before something goes on that would lose them: a question, and for a
/// document that has no file yet the dialog for its name.
class UnsavedChanges {
public:
    enum class Fate : std::uint8_t {
        Saved,   ///< what was asked for goes on
        GivenUp, ///< likewise
        Kept     ///< by the user, or since they could not be saved: what was asked for is given up
    };

    /// Call it once a frame, after the dialog, until the fate is known. The session, whose changes they are, knows
    /// `name()`, `path()`, `is_dirty()` and `save(path)`.
    template <class Session> std::optional<Fate> ask(Session& session, Dialogs& dialogs, const Catalogue& tr)
    {
        if (is_naming_) return named(session.is_dirty(), dialogs);
        const std::optional<UnsavedAnswer> answer = ask_about_unsaved(session.name(), tr);
        if (!answer) return std::nullopt;
        if (*answer == UnsavedAnswer::GiveUp) return Fate::GivenUp;
        if (*answer == UnsavedAnswer::Cancel) return Fate::Kept;
        if (session.path()) return session.save(*session.path()) ? Fate::Saved : Fate::Kept;
        is_naming_ = dialogs.handle_request(Request::SaveDialog, std::nullopt, tr);
        return std::nullopt;
    }

    bool is_naming() const { return is_naming_; } ///< the dialog is open

private:
    /// The dialog saves what it names.
    std::optional<Fate> named(bool is_dirty, const Dialogs& dialogs)
    {
        is_naming_ = dialogs.shows_dialog();
        if (is_naming_) return std::nullopt;
        return is_dirty ? Fate::Kept : Fate::Saved;
    }

    bool is_naming_ = false;
};

} // namespace ui
