#include "topology/text/line_error.h"

#include <algorithm>
#include <utility>

namespace topology {

namespace {

std::string filled(std::string_view pattern, const std::vector<std::string>& words)
{
    std::string text;
    for (std::size_t i = 0; i < pattern.size(); ++i) {
        const bool is_place = pattern[i] == '{' && i + 2 < pattern.size() && pattern[i + 2] == '}';
        const auto place = is_place ? static_cast<std::size_t>(pattern[i + 1] - '0') : words.size();
        if (place < words.size()) {
            text += words[place];
            i += 2;
        } else {
            text += pattern[i];
        }
    }
    return text;
}

/// The user's own text for a terminal: control characters as ?, and no more of it than fits two lines.
std::string shown(std::string_view text)
{
    constexpr std::size_t most = 160;
    std::size_t end = std::min(most, text.size());
    while (end < text.size() && end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) --end;
    std::string clean(text.substr(0, end)); // no letter is cut in two
    for (char& c : clean)
        if (static_cast<unsigned char>(c) < 0x20U || c == 0x7F) c = '?';
    return text.size() > most ? clean + "..." : clean;
}

std::vector<std::string> all_shown(std::vector<std::string> words)
{
    for (std::string& word : words) word = shown(word);
    return words;
}

} // namespace

LineError::LineError(std::string_view pattern, const std::vector<std::string>& words)
    : std::runtime_error(filled(pattern, all_shown(words))), pattern_(pattern), words_(all_shown(words))
{}

namespace {

std::string placed(std::size_t number, const std::string& line, const std::string& reason, const std::string& word)
{
    return number == 0 ? reason : word + " " + std::to_string(number) + ": " + line + ": " + reason;
}

} // namespace

LineError::LineError(const LineError& fault, std::size_t number, std::string line)
    : std::runtime_error(placed(number, line, fault.what(), "line")),
      pattern_(fault.pattern_),
      words_(fault.words_),
      number_(number),
      line_(std::move(line))
{}

std::string LineError::sentence(const PatternTranslator& tr) const
{
    return placed(number_, line_, filled(tr(pattern_), words_), tr("line"));
}

LineError LineError::at(std::size_t number, std::string_view line) const { return {*this, number, shown(line)}; }

} // namespace topology
