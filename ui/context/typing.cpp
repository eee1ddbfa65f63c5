#include "ui/context/typing.h"

#include <utility>

namespace ui {

namespace {

/// Whether the key writes what follows it as text.
bool is_writing(const KeyEvent& event)
{
    const bool has_letter = event.key <= Key::Digit9 || event.key == Key::Space || event.key == Key::Plus ||
                            event.key == Key::Minus;
    return has_letter && !event.modifiers.ctrl && !event.modifiers.alt;
}

/// What a frame has been given.
class TypedFrame {
public:
    TypedFrame(Input& input, Typing::Reader reader) : input_(input), goes_on_(reader == Typing::Reader::Field) {}

    bool takes(const KeyEvent& event) const
    {
        const bool is_first = !has_key_ && input_.text.empty();
        return !event.is_down || is_first || (goes_on_ && !is_done_ && is_writing(event));
    }
    bool takes(const std::string&) const { return !is_done_ && (goes_on_ || input_.text.empty()); }

    void take(const KeyEvent& event)
    {
        input_.keys.push_back(event);
        has_key_ = has_key_ || event.is_down;
        is_done_ = is_done_ || (event.is_down && !is_writing(event));
        held_ = event.modifiers;
    }
    void take(const std::string& text)
    {
        input_.text += text;
        held_.ctrl = false;
    }

    const Modifiers& held() const { return held_; }

private:
    Input& input_;
    bool goes_on_;         ///< a letter may follow another
    bool has_key_ = false; ///< went down
    bool is_done_ = false; ///< by a key that text must not follow
    Modifiers held_{};
};

} // namespace

void Typing::add(std::string_view text)
{
    if (!text.empty()) waiting_.emplace_back(std::string(text));
}

void Typing::put_back(std::string_view text)
{
    if (!text.empty()) waiting_.emplace_front(std::string(text));
}

void Typing::deliver_next(Input& input, Reader reader)
{
    TypedFrame frame(input, reader);
    const auto is_taken = [&](const auto& piece) {
        if (!frame.takes(piece)) return false;
        frame.take(piece);
        return true;
    };
    while (!waiting_.empty() && std::visit(is_taken, waiting_.front())) waiting_.pop_front();
    if (!waiting_.empty()) input.modifiers = frame.held();
}

} // namespace ui
