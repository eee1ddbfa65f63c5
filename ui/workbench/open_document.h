#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>

#include "femoop/files/whole_file.h"
#include "ui/files/autosave.h"
#include "ui/text/notice.h"
#include "ui/workbench/file_sentences.h"

namespace ui {

/// The document that a session has open: its file, what of it is saved, and what is told of that. A session says how
/// its documents are read and written. `AnyNotice`: Notice, or what the app has in its place.
template <class Document, class AnyNotice = Notice> class OpenDocument {
public:
    virtual ~OpenDocument() = default;

    /// False, with a notice, where it cannot be read; then nothing changes.
    bool open(const std::filesystem::path& path)
    {
        notice.reset(); // of another file
        return note_opened(path, read(path));
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
        Written written = write_file(path);
        notice = std::move(written.notice);
        if (!written.is_whole) return false;
        path_ = path;
        is_partial_ = false;
        saved_ = current();
        note_saved();
        return true;
    }
    /// Opens a draft of a file's document, or of one that has no file yet, as one that is not saved.
    bool recover(const std::filesystem::path& draft, const std::optional<std::filesystem::path>& original)
    {
        if (!note_opened(draft, read_draft(draft))) return false;
        path_ = original;
        forget_saved();
        return true;
    }

    /// The file that `save` would write; none of a document that has no file, or of which its file has more.
    std::optional<std::filesystem::path> path() const { return is_partial_ ? std::nullopt : path_; }
    std::string file_name() const { return ui::file_name(path_, tr()); }
    /// What windows and questions call it: its file, and without one what the document itself is called, if anything.
    virtual std::string name() const { return file_name(); }
    virtual bool is_dirty() const { return differs_from_saved(); } ///< has what is not saved; asked in every frame
    virtual UnsavedDocument unsaved() const
    {
        return unsaved_text(file_text(), path(), [this](const Catalogue& tr) { return about(tr); });
    }

    std::optional<AnyNotice> notice;
    void notify(const Message& sentence) { notice = AnyNotice{Notice{sentence}}; }

    std::string document_text() const { return file_text(); } ///< what its file would hold

    virtual const Catalogue& tr() const = 0;

protected:
    explicit OpenDocument(Document saved) : saved_(std::move(saved)) {}
    OpenDocument(const OpenDocument&) = default;
    OpenDocument(OpenDocument&&) noexcept = default;
    OpenDocument& operator=(const OpenDocument&) = default;
    OpenDocument& operator=(OpenDocument&&) noexcept = default;

    /// Puts the file's document in the place of this one, by `begin`. \returns what to tell where it cannot
    virtual std::optional<AnyNotice> read(const std::filesystem::path& path) = 0;
    /// The same of a draft, of which more may be wrong than of a file.
    virtual std::optional<AnyNotice> read_draft(const std::filesystem::path& path) { return read(path); }
    /// \param refusal  what `read` told of it. \returns whether it told nothing
    bool note_opened(const std::filesystem::path& path, const std::optional<AnyNotice>& refusal)
    {
        if (refusal) notice = refusal;
        else path_ = path;
        return !refusal;
    }
    struct Written {
        bool is_whole;
        AnyNotice notice; ///< that it is, or why not
    };
    virtual Written write_file(const std::filesystem::path& path)
    {
        const std::error_code hindrance = files::write_whole_file(path, file_text());
        if (hindrance) return {false, AnyNotice{lasting(not_saved(path, hindrance))}};
        return {true, AnyNotice{Notice{ui::saved(path)}}};
    }
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
    std::optional<std::filesystem::path> path_;
    bool is_partial_ = false;
    std::optional<Document> saved_; ///< none of what a crash has left
};

} // namespace ui
