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
///     Phrase{translatable("Move {part}"), {{"part", Phrase(translatable("Node {id}"), {{"id", "B"}})}}}
struct Phrase {
    struct Argument;

    std::string sentence;
    std::vector<Argument> arguments;

    Phrase();
    Phrase(std::string_view words); // NOLINT: a sentence without places is a phrase
    Phrase(const char* words);      // NOLINT
    Phrase(std::string_view words, std::vector<Argument> values);
    Phrase(const Phrase& other);
    Phrase(Phrase&& other) noexcept;
    Phrase& operator=(const Phrase& other);
    Phrase& operator=(Phrase&& other) noexcept;
    ~Phrase();

    friend bool operator==(const Phrase& a, const Phrase& b);
};

struct Phrase::Argument {
    std::string name;
    std::variant<std::string, Phrase> value;

    Argument(std::string place, std::string text) : name(std::move(place)), value(std::move(text)) {}
    Argument(std::string place, const char* text) : name(std::move(place)), value(std::string(text)) {}
    Argument(std::string place, Phrase phrase) : name(std::move(place)), value(std::move(phrase)) {}

    friend bool operator==(const Argument&, const Argument&) = default;
};

// A vector of arguments can be handled only here, where an argument is complete.
inline Phrase::Phrase() = default;
inline Phrase::Phrase(std::string_view words) : sentence(words) {}
inline Phrase::Phrase(const char* words) : sentence(words) {}
inline Phrase::Phrase(std::string_view words, std::vector<Argument> values)
    : sentence(words), arguments(std::move(values))
{}
inline Phrase::Phrase(const Phrase& other) = default;
inline Phrase::Phrase(Phrase&& other) noexcept = default;
inline Phrase& Phrase::operator=(const Phrase& other) = default;
inline Phrase& Phrase::operator=(Phrase&& other) noexcept = default;
inline Phrase::~Phrase() = default;

inline bool operator==(const Phrase& a, const Phrase& b)
{
    return a.sentence == b.sentence && a.arguments == b.arguments;
}

} // namespace ui
