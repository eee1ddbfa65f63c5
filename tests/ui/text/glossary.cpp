#include "tests/ui/text/glossary.h"

#include <algorithm>
#include <cctype>
#include <regex>
#include <sstream>

namespace {

using Words = std::vector<std::string>;

bool is_ascii_letter(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-'; }

// Accented letters are two bytes of UTF-8, of which 0xC3 is the first; capitals stand 0x20 before small ones.
bool is_accented(std::string_view text, std::size_t at)
{
    return text[at] == '\xC3' && at + 1 < text.size() && text[at + 1] != '\x97' && text[at + 1] != '\xB7';
}

std::string lowered_accent(char second)
{
    const auto byte = static_cast<unsigned char>(second);
    return {'\xC3', static_cast<char>(byte < 0xA0 ? byte + 0x20 : byte)};
}

// In lower case; what is no word is one of its own, so that no phrase reaches over it.
Words words_of(std::string_view text)
{
    Words words;
    bool goes_on = false;
    for (std::size_t at = 0; at < text.size(); ++at) {
        std::string letter;
        if (is_ascii_letter(text[at])) letter = static_cast<char>(std::tolower(static_cast<unsigned char>(text[at])));
        else if (is_accented(text, at)) letter = lowered_accent(text[++at]);
        if (!letter.empty() && goes_on) words.back() += letter;
        else if (!letter.empty()) words.push_back(letter);
        else if (text[at] != ' ') words.emplace_back(1, text[at]);
        goes_on = !letter.empty();
    }
    return words;
}

std::string stem(const std::string& word, std::size_t n) { return word.substr(0, word.size() - n); }

// A plural has -s or -es; for -y, -l and -ão there are -ies, -is and -ões.
bool is_form_of(const std::string& word, const std::string& listed)
{
    if (listed.size() > 1 && listed.ends_with('-')) return word.starts_with(stem(listed, 1));
    return word == listed || word == listed + "s" || word == listed + "es" ||
           (listed.ends_with("y") && word == stem(listed, 1) + "ies") ||
           (listed.ends_with("l") && word == stem(listed, 1) + "is") ||
           (listed.ends_with("ão") && word == stem(listed, 3) + "ões");
}

bool stands_at(const Words& words, std::size_t at, const Form& form)
{
    return form.size() <= words.size() - at &&
           std::equal(form.begin(), form.end(), words.begin() + static_cast<std::ptrdiff_t>(at),
                      [](const std::string& listed, const std::string& word) { return is_form_of(word, listed); });
}

bool has(const Words& words, const Form& form)
{
    for (std::size_t at = 0; at < words.size(); ++at)
        if (stands_at(words, at, form)) return true;
    return false;
}

bool has_any(const Words& words, const std::vector<Form>& forms)
{
    return std::any_of(forms.begin(), forms.end(), [&](const Form& form) { return has(words, form); });
}

// Without places, and without what is typed: in quotation marks, between ` and `, or joined by commas.
Words words_of_sentence(std::string_view sentence)
{
    static const std::regex no_text(R"(\{\w*\}|`[^`]*`|"[^"]*"|[^\s,]+,[^\s]+)");
    return words_of(std::regex_replace(std::string(sentence), no_text, "|"));
}

// How many words of the sentence the longest form of a term takes at a place.
std::size_t length_at(const Words& words, std::size_t at, const Term& term)
{
    std::size_t length = 0;
    for (const Form& form : term.english)
        if (stands_at(words, at, form)) length = std::max(length, form.size());
    return length;
}

// Of two terms in one place the longer one.
std::vector<const Term*> terms_in(const Words& words, const std::vector<Term>& terms)
{
    std::vector<const Term*> found;
    for (std::size_t at = 0; at < words.size();) {
        std::size_t longest = 0;
        for (const Term& term : terms) longest = std::max(longest, length_at(words, at, term));
        for (const Term& term : terms)
            if (longest > 0 && length_at(words, at, term) == longest) found.push_back(&term);
        at += std::max<std::size_t>(longest, 1);
    }
    return found;
}

std::vector<std::string> split(const std::string& text, const std::string& mark)
{
    std::vector<std::string> parts;
    std::size_t begin = 0;
    for (std::size_t end = 0; end != std::string::npos; begin = end + mark.size()) {
        end = text.find(mark, begin);
        parts.push_back(text.substr(begin, end == std::string::npos ? end : end - begin));
    }
    return parts;
}

std::vector<Form> forms_of(const std::string& cell)
{
    std::vector<Form> forms;
    for (const std::string& part : split(cell, ", "))
        if (Form form = words_of(part); !form.empty()) forms.push_back(std::move(form));
    return forms;
}

Term term_of(const std::string& row)
{
    const std::vector<std::string> cells = split(row, "|"); // the first is before the first stroke
    const std::string name = cells.at(1).substr(1, cells.at(1).size() - 2);
    const std::size_t remark = name.find(" (");
    return {.name = name,
            .is_everyday = remark != std::string::npos,
            .english = forms_of(name.substr(0, remark)),
            .not_english = forms_of(cells.at(2)),
            .portuguese = forms_of(cells.at(3)),
            .not_portuguese = forms_of(cells.at(4))};
}

} // namespace

std::vector<std::vector<Term>> read_glossary(std::string_view page)
{
    std::vector<std::vector<Term>> tables;
    std::istringstream lines{std::string(page)};
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("|---")) tables.emplace_back();
        else if (line.starts_with("| ") && !line.starts_with("| term ")) tables.back().push_back(term_of(line));
    }
    return tables;
}

std::string breaches(const std::vector<Term>& terms, std::string_view english, std::string_view portuguese)
{
    const Words source = words_of_sentence(english), translation = words_of_sentence(portuguese);
    std::string found;
    for (const Term* term : terms_in(source, terms))
        if (!term->is_everyday && !has_any(translation, term->portuguese))
            found += term->name + ": not translated so\n";
    for (const Term& term : terms) {
        if (has_any(source, term.not_english)) found += term.name + ": an English word for it is ruled out\n";
        if (has_any(translation, term.not_portuguese)) found += term.name + ": a Portuguese word for it is ruled out\n";
    }
    return found;
}
