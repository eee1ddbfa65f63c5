#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>

#include "ui/files/autosave.h"
#include "ui/files/write_whole.h"
#include "ui/text/notice.h"
#include "ui/workbench/file_sentences.h"

namespace ui {

/// The document that a session has open: its file, what of it is saved, and what is told of that. A session says how
/// its documents are read and written.
template <class Document> class OpenDocument {
public:
    virtual ~OpenDocument() = default;

    bool open(
        const std::filesystem::path& path) ///< false, with a notice, where it cannot be read; then nothing changes
    {
        if (const std::optional<Message> reason = read(path)) {
            notice = Notice{not_opened(path, *reason), until_closed};
            return false;
        }
        path_ = path;
        return true;
    }
    bool open_copy(const std::filesystem::path& path) ///< the same as a document without a file
    {
        if (!open(path)) return false;
        path_.reset();
        return true;
    }
    bool save(const std::filesystem::path& path) ///< whole or not at all; false, with a notice, if that fails
    {
        settle();
        if (const std::error_code hindrance = write_(path, file_text())) {
            notice = Notice{not_saved(path, hindrance), until_closed};
            return false;
        }
        path_ = path;
        is_partial_ = false;
        saved_ = current();
        note_saved();
        notify(ui::saved(path));
        return true;
    }
    /// Opens a draft of a file's document, or of one that has no file yet, as one that is not saved.
    bool recover(const std::filesystem::path& draft, const std::optional<std::filesystem::path>& original)
    {
        if (!open(draft)) return false;
        path_ = original;
        forget_saved();
        return true;
    }

    /// The file that `save` would write; none of a document that has no file, or of which its file has more.
    std::optional<std::filesystem::path> path() const { return is_partial_ ? std::nullopt : path_; }
    std::string file_name() const { return ui::file_name(path_, tr()); }
    virtual bool is_dirty() const { return differs_from_saved(); } ///< has what is not saved; asked in every frame
    virtual UnsavedDocument unsaved() const
    {
        return unsaved_text(file_text(), path(), write_, [this](const Catalogue& tr) { return about(tr); });
    }

    std::optional<Notice> notice;
    void notify(const Message& sentence) { notice = Notice{sentence}; }

    virtual const Catalogue& tr() const = 0;

protected:
    OpenDocument(Document saved, WriteWhole write) : saved_(std::move(saved)), write_(write) {}
    OpenDocument(const OpenDocument&) = default;
    OpenDocument(OpenDocument&&) noexcept = default;
    OpenDocument& operator=(const OpenDocument&) = default;
    OpenDocument& operator=(OpenDocument&&) noexcept = default;

    /// Puts the file's document in the place of this one, by `begin`. \returns why it cannot
    virtual std::optional<Message> read(const std::filesystem::path& path) = 0;
    virtual const Document& current() const = 0;
    virtual std::string file_text() const = 0;
    virtual std::string about(const Catalogue& tr) const = 0; ///< what a draft holds, in a few words
    virtual void settle() {}                                  ///< ends a gesture
    virtual bool is_same(const Document& a, const Document& b) const { return a == b; }

    /// Another document takes this one's place, without a file.
    void begin(const Document& document)
    {
        path_.reset();
        is_partial_ = false;
        saved_ = document;
        note_saved();
    }
    /// Whether the file that is open holds more than was understood, so that it is not to be written over.
    void set_partial(bool is_partial) { is_partial_ = is_partial; }

    void forget_saved() ///< what is open differs from its file
    {
        saved_.reset();
        note_saved();
    }
    bool differs_from_saved() const { return !saved_ || !is_same(current(), *saved_); }
    virtual void note_saved() {} ///< what is saved is another one, for sessions that keep whether they are dirty

private:
    static constexpr std::nullopt_t until_closed = std::nullopt;

    std::optional<std::filesystem::path> path_;
    bool is_partial_ = false;
    std::optional<Document> saved_; ///< none of what a crash has left
    WriteWhole write_;
};

} // namespace ui
