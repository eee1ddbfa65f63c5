#pragma once

#include <deque>
#include <string>
#include <string_view>
#include <variant>

#include "ui/context/input.h"

namespace ui {

/// What was typed and no frame has shown yet, in order. A frame tells keys and text apart, so of two strokes in one
/// frame nobody could say which came first, as of `Tab` and a letter: a frame gets one stroke, which is a key with the
/// text that it wrote. Letters alone go together where a field reads them.
class Typing {
public:
    enum class Reader { Field, Keys };

    void add(const KeyEvent& event) { waiting_.emplace_back(event); }
    void add(std::string_view text);
    /// Text that was given to a frame too early, before the field that will read it.
    void put_back(std::string_view text);
    bool is_empty() const { return waiting_.empty(); }

    /// The next stroke, with the releases that follow it. While more waits the modifiers are those of the stroke.
    void deliver_next(Input& input, Reader reader);

private:
    using Piece = std::variant<KeyEvent, std::string>;
    std::deque<Piece> waiting_;
};

} // namespace ui
