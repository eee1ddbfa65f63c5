#pragma once

#include <string>
#include <string_view>
#include <vector>

/// What keeps LaTeX from setting a text as the body of a document: braces, environments, formulas that do not close, or
/// a letter that is no accent of our languages. Empty where nothing does.
inline std::string fault_of_latex(std::string_view text)
{
    std::vector<std::string> open;
    bool is_inline = false;
    const auto close = [&](const std::string& what) {
        if (open.empty() || open.back() != what) return false;
        open.pop_back();
        return true;
    };
    const auto begins = [&](std::size_t i, std::string_view what) { return text.substr(i).starts_with(what); };
    const auto named = [&](std::size_t i) {
        const std::size_t from = text.find('{', i) + 1;
        return std::string(text.substr(from, text.find('}', from) - from));
    };
    for (std::size_t i = 0; i < text.size(); ++i) {
        const std::string place = " before \"" + std::string(text.substr(i, 24)) + "\"";
        const auto byte = static_cast<unsigned char>(text[i]);
        if (byte >= 0x80) {
            if (byte != 0xC3) return "no accent" + place;
            ++i;
        } else if (begins(i, "\\begin{")) {
            open.push_back(named(i));
            i = text.find('}', i);
        } else if (begins(i, "\\end{")) {
            if (!close(named(i))) return "an environment ends that is not open" + place;
            i = text.find('}', i);
        } else if (begins(i, "\\[") || begins(i, "\\left")) {
            open.emplace_back(begins(i, "\\[") ? "\\]" : "\\right");
            ++i;
        } else if (begins(i, "\\]") || begins(i, "\\right")) {
            if (!close(begins(i, "\\]") ? "\\]" : "\\right")) return "a formula ends that is not open" + place;
            ++i;
        } else if (text[i] == '\\') {
            ++i;
        } else if (text[i] == '{') {
            open.emplace_back("}");
        } else if (text[i] == '}') {
            if (!close("}")) return "a brace closes that is not open" + place;
        } else if (text[i] == '$') {
            is_inline = !is_inline;
            if (is_inline) open.emplace_back("$");
            else if (!close("$")) return "a formula closes over what is open" + place;
        }
    }
    return open.empty() ? std::string() : "not closed: " + open.back();
}
