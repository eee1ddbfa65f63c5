#include "ui/command/match.h"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <sstream>
#include <string>

namespace ui {

namespace {

struct Fold {
    std::string_view accented;
    char plain;
};
constexpr Fold folds[] = {{"áàâãä", 'a'}, {"ÁÀÂÃÄ", 'a'}, {"éèêë", 'e'}, {"ÉÈÊË", 'e'}, {"íìîï", 'i'}, {"ÍÌÎÏ", 'i'},
                          {"óòôõö", 'o'}, {"ÓÒÔÕÖ", 'o'}, {"úùûü", 'u'}, {"ÚÙÛÜ", 'u'}, {"çÇ", 'c'}};

char plain_letter(std::string_view two_bytes)
{
    for (const Fold& fold : folds) {
        if (two_bytes.size() == 2 && fold.accented.find(two_bytes) != std::string_view::npos) return fold.plain;
    }
    return '?';
}

// Lower case without accents; anything else that is not ASCII becomes one '?' a character.
std::string folded(std::string_view utf8)
{
    std::string plain;
    for (std::size_t i = 0; i < utf8.size(); ++i) {
        const auto byte = static_cast<unsigned char>(utf8[i]);
        if (byte < 0x80) {
            plain += static_cast<char>(std::tolower(byte));
        } else if (byte >= 0xC0) {
            plain += plain_letter(utf8.substr(i, 2));
        }
    }
    return plain;
}

/// Of a word: the s of "one's" is none of its own.
bool is_letter(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '\''; }

int rank_at(std::size_t at, std::string_view word, std::string_view text)
{
    const std::size_t end = at + word.size();
    const bool begins = at == 0 || !is_letter(text[at - 1]);
    const bool ends = end == text.size() || !is_letter(text[end]);
    if (!begins) return worst_rank_of_words;
    return ends ? 2 : 3;
}

std::optional<int> rank_at_beginning(const std::string& wanted, const std::string& text)
{
    if (wanted.empty() || !text.starts_with(wanted)) return std::nullopt;
    const bool ends = text.size() == wanted.size() || !is_letter(text[wanted.size()]);
    return ends ? 0 : 1;
}

// Of all places where the word stands, the best.
std::optional<int> rank_of_word(std::string_view word, std::string_view text)
{
    std::optional<int> best;
    for (std::size_t at = text.find(word); at != std::string_view::npos; at = text.find(word, at + 1)) {
        const int rank = rank_at(at, word, text);
        if (!best || rank < *best) best = rank;
    }
    return best;
}

std::optional<int> rank_of_words(const std::string& wanted, const std::string& text)
{
    if (const auto rank = rank_at_beginning(wanted, text)) return rank;
    std::istringstream words(wanted);
    int worst = 2;
    for (std::string word; words >> word;) {
        const std::optional<int> rank = rank_of_word(word, text);
        if (!rank) return std::nullopt;
        worst = std::max(worst, *rank);
    }
    return worst;
}

std::optional<int> rank_of_letters(const std::string& wanted, const std::string& text)
{
    std::size_t place = 0;
    std::size_t first = 0;
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        place = text.find(wanted[i], place);
        if (place == std::string::npos) return std::nullopt;
        if (i == 0) first = place;
        ++place;
    }
    return worst_rank_of_words + 1 + static_cast<int>(place - first - wanted.size());
}

} // namespace

std::optional<int> match_rank(std::string_view typed, std::string_view name)
{
    const std::string wanted = folded(typed);
    const std::string text = folded(name);
    const std::optional<int> rank = rank_of_words(wanted, text);
    return rank ? rank : rank_of_letters(wanted, text);
}

} // namespace ui
