#include "ui/command/match.h"

#include <array>
#include <cctype>
#include <cstddef>
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

} // namespace

std::optional<int> match_rank(std::string_view typed, std::string_view name)
{
    const std::string wanted = folded(typed);
    const std::string text = folded(name);
    if (const std::size_t at = text.find(wanted); at != std::string::npos) {
        const bool begins_word = at == 0 || text[at - 1] == ' ';
        return begins_word ? 0 : 1;
    }
    std::size_t place = 0;
    std::size_t first = 0;
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        place = text.find(wanted[i], place);
        if (place == std::string::npos) return std::nullopt;
        if (i == 0) first = place;
        ++place;
    }
    return 2 + static_cast<int>(place - first - wanted.size());
}

} // namespace ui
