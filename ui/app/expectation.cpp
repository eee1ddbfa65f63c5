#include "ui/app/expectation.h"

#include <algorithm>
#include <fstream>
#include <iterator>

#include "ui/paint/surface/golden_text.h"
#include "ui/scenario/words.h"

namespace ui {

namespace {

bool is_drawn(const std::optional<Picture>& picture, const std::string& text)
{
    return picture && golden_text(*picture).find(" \"" + text + "\"\n") != std::string::npos;
}

Mismatch drawn(const std::optional<Picture>& picture, std::string_view text)
{
    const std::string wanted = unquoted(text);
    if (is_drawn(picture, wanted)) return std::nullopt;
    return "drawn: found no string \"" + wanted + "\" in the picture";
}

/// A file and words that it should have, or lack.
struct WrittenWords {
    std::string name, words;
    std::optional<std::string> content; ///< nothing where there is no such file
    bool has_words() const { return content->find(words) != std::string::npos; }
};

// extremes.csv "Member;N max"
WrittenWords written_words(std::string_view text)
{
    const std::size_t blank = std::min(text.find(' '), text.size());
    WrittenWords found{std::string(text.substr(0, blank)), unquoted(text.substr(std::min(blank + 1, text.size()))), {}};
    std::ifstream file(found.name, std::ios::binary);
    if (file) found.content.emplace(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
    return found;
}

Mismatch written(std::string_view text)
{
    const WrittenWords file = written_words(text);
    if (!file.content) return "written: found no file " + file.name;
    if (file.has_words()) return std::nullopt;
    return "written: found no \"" + file.words + "\" in " + file.name;
}

// drawn "58.52", written portal.html "58.52"
Mismatch not_there(const std::optional<Picture>& picture, std::string_view text)
{
    if (constexpr std::string_view prefix = "drawn "; text.starts_with(prefix)) {
        const std::string unwanted = unquoted(text.substr(prefix.size()));
        if (!is_drawn(picture, unwanted)) return std::nullopt;
        return "not drawn: found the string \"" + unwanted + "\" in the picture";
    }
    if (constexpr std::string_view prefix = "written "; text.starts_with(prefix)) {
        const WrittenWords file = written_words(text.substr(prefix.size()));
        if (!file.content) return "not written: found no file " + file.name;
        if (!file.has_words()) return std::nullopt;
        return "not written: found \"" + file.words + "\" in " + file.name;
    }
    return "not: wanted drawn \"TEXT\" or written FILE \"TEXT\"";
}

} // namespace

Mismatch compared(std::string_view what, const std::string& found, const std::string& wanted)
{
    if (found == wanted) return std::nullopt;
    return std::string(what) + ": found " + found + ", wanted " + wanted;
}

std::pair<std::string_view, std::string_view> first_word(std::string_view words)
{
    const std::size_t blank = std::min(words.find(' '), words.size());
    return {words.substr(0, blank), words.substr(std::min(blank + 1, words.size()))};
}

std::optional<Mismatch> common_mismatch(std::string_view expectation, const App& app,
                                        const std::optional<Picture>& picture)
{
    const auto [what, rest] = first_word(expectation);
    if (what == "drawn") return drawn(picture, rest);
    if (what == "written") return written(rest);
    if (what == "ends") return compared(what, yes_or_no(app.wants_to_quit()), std::string(rest));
    if (what == "not") return not_there(picture, rest);
    return std::nullopt;
}

} // namespace ui
