#pragma once

#include <filesystem>
#include <optional>
#include <system_error>
#include <vector>

#include "apps/frame/document/document.h"

namespace frame {

/// Unsaved work that a program left behind when it was killed.
struct Leftover {
    std::filesystem::path draft;                   ///< a model file
    std::optional<std::filesystem::path> original; ///< the file that was being edited
};

/// Where this person's programs keep such things: $XDG_STATE_HOME/cremona/frame, else ~/.local/state/cremona/frame.
/// Nothing where neither is known.
std::optional<std::filesystem::path> state_folder();

/// Keeps a copy of a document that is not saved yet, so that no crash costs it. Each program that runs has a draft of
/// its own, whose lock the system lifts when the program ends in whatever way; a draft without a lock is a leftover.
class Recovery {
public:
    /// The folder is made with the first draft.
    explicit Recovery(std::filesystem::path folder) : folder_(std::move(folder)) {}
    Recovery(const Recovery&) = delete;
    Recovery& operator=(const Recovery&) = delete;
    ~Recovery(); ///< the lock goes, the draft stays

    /// Writes the draft, whole or not at all. \returns what hindered it
    std::error_code keep(const Document& document, const std::optional<std::filesystem::path>& original);
    /// The document is saved or given up: no draft is needed.
    void forget();

    /// The newest first.
    std::vector<Leftover> leftovers() const;
    /// Deletes a leftover that was opened or is not wanted.
    static void discard(const Leftover& leftover);

private:
    std::error_code lock();

    std::filesystem::path folder_;
    std::filesystem::path draft_; ///< empty until the lock is held
    int lock_ = -1;
};

} // namespace frame
