#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <future>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "ui/files/draft.h"
#include "ui/text/catalogue.h"
#include "ui/text/message.h"

namespace ui {

/// A document that is not saved, as it stands.
struct UnsavedDocument {
    std::uint64_t document = 0; ///< tells the documents of one program apart
    std::uint64_t state = 0;    ///< another one when there is something new to keep
    std::optional<std::filesystem::path> original{};
    std::function<WriteDocument()> copy{}; ///< takes a copy, which is written while the document goes on changing
    std::function<std::string(const Catalogue&)> about{}; ///< what it holds, in a few words: "4 nodes, 3 members"
};

/// The one document of a program, which is small enough to be written as a text whenever it may have changed.
UnsavedDocument unsaved_text(std::string text, const std::optional<std::filesystem::path>& original,
                             std::function<std::string(const Catalogue&)> about = {});

/// Keeps drafts of all documents of a program that are not saved, a few seconds after each change, and finds those that
/// a program left behind when it was killed. They are written beside the program's work, which waits for no disk.
class Autosave {
public:
    static constexpr double interval = 2.0; ///< [s]

    explicit Autosave(DraftFolder folder) : folder_(std::move(folder)) {}

    /// Call once a frame: begins to keep what has changed since it was kept last, forgets what is saved or closed.
    /// \returns what to tell where drafts cannot be kept: once, until they can be
    std::optional<Message> tick(const std::function<std::vector<UnsavedDocument>()>& unsaved, double seconds);
    void wait() const; ///< until all that is being written is on the disk
    /// Everything is saved or given up.
    void forget_all();

    /// What a program left behind and was not told before. A program that is being killed may hold its draft for a
    /// moment still, so one asks again.
    std::vector<RecoverableFile> new_recoverable_files();
    /// A leftover is the draft of this document from now on.
    void adopt(std::uint64_t document, std::unique_ptr<Draft> recoverable);
    const DraftFolder& folder() const { return folder_; }

private:
    struct Kept {
        std::unique_ptr<Draft> draft;
        std::optional<std::uint64_t> state{}; ///< that was kept, or is being written
        std::future<std::error_code> writing{};
        bool is_hindered = false;

        bool is_writing() const { return writing.valid(); }
    };
    void keep(const UnsavedDocument& document);
    std::optional<Message> collect();
    std::optional<Message> note_written(Kept& kept, const std::error_code& hindrance);
    void forget_all_but(const std::vector<UnsavedDocument>& documents);

    DraftFolder folder_;
    std::map<std::uint64_t, Kept> kept_;   ///< by the document
    double waited_ = 0.0;                  ///< [s]
    std::set<std::filesystem::path> told_; ///< leftovers
};

} // namespace ui
