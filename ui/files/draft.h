#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

namespace ui {

/// Where the programs of an app keep drafts of their documents.
struct DraftFolder {
    std::filesystem::path path;
    std::string extension; ///< of the app's documents: ".json"
};

/// Where this person's programs keep such things: $XDG_STATE_HOME/cremona/APP, else ~/.local/state/cremona/APP.
/// Nothing where neither is known.
std::optional<DraftFolder> draft_folder(std::string_view app, std::string extension);

/// UnsavedDocument work that a program left behind when it was killed.
struct RecoverableFile {
    std::filesystem::path draft;                   ///< a file of the app's kind
    std::optional<std::filesystem::path> original; ///< the file that was being edited
    std::vector<std::string> about{};              ///< what it holds, in a few words, in each of `all_languages`
};
std::vector<RecoverableFile> recoverable_files(const DraftFolder& folder); ///< the newest first
/// When it was kept last, as people here write it: "2026-11-23 14:05"; empty where it is gone.
std::string time_of(const RecoverableFile& recoverable);

/// Writes a document as it stood when this was made. What stands beside it has its name with another ending:
/// 7-0.view.json beside 7-0.json. \returns what hindered it
using WriteDocument = std::function<std::error_code(const std::filesystem::path& draft)>;

/// Keeps a copy of a document that is not saved yet, so that no crash costs it. Each document of each program that runs
/// has a draft of its own, whose lock the system lifts when the program ends in whatever way; a draft without a lock is
/// a leftover.
class Draft {
public:
    /// The folder is made with the first draft.
    explicit Draft(DraftFolder folder) : folder_(std::move(folder)) {}
    /// A leftover becomes the draft of this program. \returns null where another one was faster
    static std::unique_ptr<Draft> taken_over(DraftFolder folder, const RecoverableFile& recoverable);
    Draft(const Draft&) = delete;
    Draft& operator=(const Draft&) = delete;
    ~Draft(); ///< the lock goes, the draft stays

    /// Writes it, whole or not at all. \param about  what it holds, in a few words in each of
    /// `all_languages`. \returns what hindered it
    std::error_code keep(const WriteDocument& write, const std::optional<std::filesystem::path>& original,
                         const std::vector<std::string>& about = {});
    /// The document is saved or given up: no draft is needed.
    void forget();

private:
    std::error_code lock();
    std::error_code keep_path(const std::optional<std::filesystem::path>& original) const;
    std::error_code keep_beside(const char* extension, const std::string& text) const;

    DraftFolder folder_;
    std::filesystem::path path_; ///< empty until the lock is held
    int lock_ = -1;
};

} // namespace ui
