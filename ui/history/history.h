#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <string>
#include <utility>

#include "ui/text/message.h"

namespace ui {

/// The states that a document went through, each with the label of the step that made it.
///
///     state   start -- add node -- move load -- (open gesture)
///     place     0         1            2              3
///
/// A step is a click (`apply`) or a gesture: `drag` again and again while the mouse is down, then `settle`. A gesture
/// is one step however often it changed the document, and none if the document came back to what it was. A new step
/// after an undo forgets what could have been redone.
///
/// The states together take no more memory than a limit: a step that would go beyond it forgets the oldest of them, so
/// that undo reaches less far back. The present state and the one before it stay however large they are. A document
/// tells its size by a function `memory_footprint(document)` [bytes] beside its type; without one it counts by sizeof.
template <class Document> class History {
public:
    static constexpr std::size_t usual_limit = std::size_t{256} << 20; ///< [bytes]

    explicit History(Document start, Message label = {}, std::size_t limit = usual_limit) : limit_(limit)
    {
        push_state(std::move(start), std::move(label));
    }

    /// The document as it is now, an open gesture included. The reference holds until the next call that is not const.
    const Document& current() const { return states_[place_].document; }
    /// The document as it was before the open gesture; the current one where none is open.
    const Document& settled() const { return states_[is_dragging_ ? place_ - 1 : place_].document; }

    /// One step. A document equal to the current one is no step.
    void apply(Document next, Message label)
    {
        settle();
        if (next != current()) push(std::move(next), std::move(label));
    }

    /// Opens a gesture or continues the open one.
    void drag(Document next, Message label)
    {
        if (is_dragging_) {
            pop();
            push(std::move(next), std::move(label));
        } else if (next != current()) {
            push(std::move(next), std::move(label));
            is_dragging_ = true;
        }
    }

    /// Closes the open gesture; nothing happens if there is none.
    void settle()
    {
        if (!std::exchange(is_dragging_, false)) return;
        if (current() == states_[place_ - 1].document) pop();
    }

    /// Closes the open gesture and takes back what it did.
    void cancel()
    {
        if (std::exchange(is_dragging_, false)) pop();
    }

    bool is_dragging() const { return is_dragging_; }
    bool can_undo() const { return place_ > 0; }
    bool can_redo() const { return place_ + 1 < states_.size(); }

    /// Takes one step back; an open gesture is taken back as a whole. Nothing happens at the start.
    void undo()
    {
        settle();
        if (can_undo()) --place_;
    }
    void redo()
    {
        settle();
        if (can_redo()) ++place_;
    }

    /// The step that `undo` would take back, that `redo` would do again.
    std::optional<Message> undo_label() const { return can_undo() ? std::optional(label(place_)) : std::nullopt; }
    std::optional<Message> redo_label() const { return can_redo() ? std::optional(label(place_ + 1)) : std::nullopt; }

    std::size_t memory() const { return memory_; } ///< of all states [bytes], as their documents tell it
    std::size_t n_states() const { return states_.size(); }
    std::size_t place() const { return place_; } ///< of the current state, from 0
    const Message& label(std::size_t place) const { return states_.at(place).label; }
    /// Makes that state the current one; those after it can still be reached. \throws std::out_of_range
    void jump(std::size_t place)
    {
        settle();
        (void)states_.at(place);
        place_ = place;
    }

private:
    struct State {
        Document document;
        Message label;
        std::size_t memory; ///< [bytes]
    };

    static std::size_t footprint(const Document& document)
    {
        if constexpr (requires { memory_footprint(document); }) return memory_footprint(document);
        else return sizeof(Document);
    }

    void push(Document next, Message label)
    {
        while (states_.size() > place_ + 1) pop_state();
        push_state(std::move(next), std::move(label));
        ++place_;
        while (memory_ > limit_ && place_ > 1) forget_oldest();
    }
    void pop()
    {
        pop_state();
        --place_;
    }

    void push_state(Document document, Message label)
    {
        const std::size_t memory = footprint(document);
        states_.push_back({std::move(document), std::move(label), memory});
        memory_ += memory;
    }
    void pop_state()
    {
        memory_ -= states_.back().memory;
        states_.pop_back();
    }
    void forget_oldest()
    {
        memory_ -= states_.front().memory;
        states_.pop_front();
        --place_;
    }

    std::size_t limit_;
    std::deque<State> states_;
    std::size_t memory_ = 0;
    std::size_t place_ = 0;
    bool is_dragging_ = false;
};

} // namespace ui
