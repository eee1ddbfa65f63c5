#include "ui/text/catalogue.h"

#include <algorithm>
#include <utility>

#include "ui/text/compiled_translations.h"
#include "ui/text/number_format.h"

namespace ui {

std::string_view code(Language language) { return language == Language::Portuguese ? "pt" : "en"; }

std::string_view native_name(Language language)
{
    return language == Language::Portuguese ? "Português (Brasil)" : "English";
}

std::optional<Language> language_named(std::string_view name)
{
    const std::string_view bare = name.substr(0, name.find_first_of("_-."));
    for (const Language language : all_languages) {
        if (bare == code(language)) return language;
    }
    return std::nullopt;
}

Catalogue::Catalogue(Language language) : Catalogue(language, compiled_entries(language)) {}

Catalogue::Catalogue(Language language, const std::vector<PoEntry>& entries) : language_(language)
{
    auto sentences = std::make_shared<Sentences>();
    for (const PoEntry& entry : entries) sentences->emplace(entry.id, entry.text);
    sentences_ = std::move(sentences);
}

bool Catalogue::has(std::string_view sentence) const { return sentences_ && sentences_->contains(sentence); }

std::string Catalogue::operator()(std::string_view sentence) const
{
    if (sentences_) {
        if (const auto found = sentences_->find(sentence); found != sentences_->end()) return found->second;
    }
    return std::string(sentence);
}

std::string Catalogue::operator()(std::string_view sentence, std::initializer_list<Argument> arguments) const
{
    return filled((*this)(sentence), std::span(arguments.begin(), arguments.size()));
}

namespace {

std::size_t end_of_digits(std::string_view text, std::size_t begin)
{
    return std::min(text.find_first_not_of("0123456789", begin), text.size());
}

/// "-12.5", "1.2e-5", "-180 mm": where its number ends; 0 where it begins with none.
std::size_t end_of_number(std::string_view text)
{
    const std::size_t begin = text.starts_with('-') ? 1 : 0;
    std::size_t end = end_of_digits(text, begin);
    if (end == begin) return 0;
    if (end < text.size() && (text[end] == '.' || text[end] == ',')) end = end_of_digits(text, end + 1);
    if (text.substr(end).starts_with("e-")) end = end_of_digits(text, end + 2);
    return end == text.size() || text[end] == ' ' ? end : 0;
}

/// With true minus signs.
std::string said(const std::string& value)
{
    const std::size_t end = end_of_number(value);
    return with_minus_signs(value.substr(0, end)) + value.substr(end);
}

} // namespace

std::string Catalogue::operator()(const Message& message) const
{
    const std::string sentence = (*this)(message.sentence);
    std::vector<std::string> values; // said first, since the arguments only look at them
    for (const Message::Argument& argument : message.arguments) {
        const auto* const inner = std::get_if<Message>(&argument.value);
        const bool is_quoted = sentence.find("\"{" + argument.name + "}") !=
                               std::string::npos; // it stays as it is typed
        if (inner != nullptr) values.push_back((*this)(*inner));
        else
            values.push_back(is_quoted ? std::get<std::string>(argument.value)
                                       : said(std::get<std::string>(argument.value)));
    }
    std::vector<Argument> arguments;
    for (std::size_t i = 0; i < values.size(); ++i) arguments.push_back({message.arguments[i].name, values[i]});
    return filled(sentence, arguments);
}

namespace {

// The end of the place that opens at `begin`, or npos if what stands there is no place.
std::size_t end_of_place(std::string_view sentence, std::size_t begin)
{
    const auto is_letter = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
    };
    std::size_t end = begin + 1;
    while (end < sentence.size() && is_letter(sentence[end])) ++end;
    const bool is_place = end > begin + 1 && end < sentence.size() && sentence[end] == '}';
    return is_place ? end : std::string_view::npos;
}

} // namespace

std::vector<std::string> places(std::string_view sentence)
{
    std::vector<std::string> names;
    for (std::size_t i = 0; i < sentence.size(); ++i) {
        if (sentence[i] != '{') continue;
        const std::size_t end = end_of_place(sentence, i);
        if (end != std::string_view::npos) names.emplace_back(sentence.substr(i + 1, end - i - 1));
    }
    std::sort(names.begin(), names.end());
    return names;
}

std::string filled(std::string_view sentence, std::span<const Catalogue::Argument> arguments)
{
    std::string text;
    for (std::size_t i = 0; i < sentence.size(); ++i) {
        const std::size_t end = sentence[i] == '{' ? end_of_place(sentence, i) : std::string_view::npos;
        const std::string_view name = end == std::string_view::npos ? "" : sentence.substr(i + 1, end - i - 1);
        const auto argument = std::find_if(arguments.begin(), arguments.end(),
                                           [&](const Catalogue::Argument& a) { return a.name == name; });
        if (name.empty() || argument == arguments.end()) {
            text += sentence[i];
        } else {
            text += argument->value;
            i = end;
        }
    }
    return text;
}

std::vector<PoEntry> compiled_entries(Language language)
{
    std::vector<PoEntry> all;
    if (language == Language::English) return all;
    for (const std::string_view file : compiled_portuguese()) {
        const std::vector<PoEntry> entries = read_po(file);
        all.insert(all.end(), entries.begin(), entries.end());
    }
    return all;
}

} // namespace ui
