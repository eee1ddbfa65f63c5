#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <utility>

#include "ui/history/history.h"
#include "ui/workbench/open_document.h"

namespace ui {

/// An open document that is changed by steps, each of which can be taken back. A session makes its steps by `history_`
/// and says what else a way through them changes.
template <class Document, class AnyNotice = Notice> class EditedDocument : public OpenDocument<Document, AnyNotice> {
public:
    const Document& document() const { return history_.current(); }
    const History<Document>& history() const { return history_; }
    void undo()
    {
        go([this] { history_.undo(); });
    }
    void redo()
    {
        go([this] { history_.redo(); });
    }
    void go_to_state(std::size_t place) ///< of the history. \throws std::out_of_range
    {
        go([this, place] { history_.jump(place); });
    }

protected:
    explicit EditedDocument(const Document& first) : Base(first), history_(first, beginning) {}

    /// Another document takes this one's place, without a file and with nothing to be taken back.
    void begin(Document document)
    {
        history_ = History<Document>(std::move(document), beginning);
        Base::begin(history_.current());
    }

    virtual void prepare_to_go() {}                                              ///< ends what is under way
    virtual std::optional<Message> why_not_here() const { return std::nullopt; } ///< goes back, with a notice
    virtual void follow(const Document& before) = 0;                             ///< the document is another one

    History<Document> history_;

private:
    using Base = OpenDocument<Document, AnyNotice>;
    static constexpr std::string_view beginning = translatable("Begin"); ///< what the history calls it

    template <class Go> void go(const Go& there)
    {
        prepare_to_go();
        outdate(this->notice);
        history_.settle();
        const Document before = document();
        const std::size_t place = history_.place();
        there();
        if (const auto reason = why_not_here()) {
            history_.jump(place);
            this->notify(*reason);
        }
        follow(before);
    }
    const Document& current() const override { return document(); }
};

} // namespace ui
