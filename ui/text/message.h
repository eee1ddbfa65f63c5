#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace ui {

/// A sentence that is not said yet: the source's English and the values of its places. It is kept where the language
/// may change before it is shown, as in the steps of a history; `tr(phrase)` says it. A value is a name, which no
/// language changes, or a phrase itself.
///
///     Message{translatable("Move {part}"), {{"part", Message(translatable("Node {id}"), {{"id", "B"}})}}}
struct Message {
    struct Argument;

    std::string sentence;
    std::vector<Argument> arguments;

    Message();
    Message(std::string_view words); // NOLINT: a sentence without places is a phrase
    Message(const char* words);      // NOLINT
    Message(std::string_view words, std::vector<Argument> values);
    Message(const Message& other);
    Message(Message&& other) noexcept;
    Message& operator=(const Message& other);
    Message& operator=(Message&& other) noexcept;
    ~Message();

    friend bool operator==(const Message& a, const Message& b);
};

struct Message::Argument {
    std::string name;
    std::variant<std::string, Message> value;

    Argument(std::string place, std::string text) : name(std::move(place)), value(std::move(text)) {}
    Argument(std::string place, const char* text) : name(std::move(place)), value(std::string(text)) {}
    Argument(std::string place, Message message) : name(std::move(place)), value(std::move(message)) {}

    friend bool operator==(const Argument&, const Argument&) = default;
};

// A vector of arguments can be handled only here, where an argument is complete.
inline Message::Message() = default;
inline Message::Message(std::string_view words) : sentence(words) {}
inline Message::Message(const char* words) : sentence(words) {}
inline Message::Message(std::string_view words, std::vector<Argument> values)
    : sentence(words), arguments(std::move(values))
{}
inline Message::Message(const Message& other) = default;
inline Message::Message(Message&& other) noexcept = default;
inline Message& Message::operator=(const Message& other) = default;
inline Message& Message::operator=(Message&& other) noexcept = default;
inline Message::~Message() = default;

inline bool operator==(const Message& a, const Message& b)
{
    return a.sentence == b.sentence && a.arguments == b.arguments;
}

} // namespace ui
