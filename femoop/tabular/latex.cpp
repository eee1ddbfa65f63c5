#include "femoop/tabular/latex.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

namespace tabular {

namespace {

using Sign = std::pair<std::string_view, std::string_view>;

/// Letters that take what follows them as an index.
constexpr auto latex_letters = std::to_array<Sign>({{"σ", "\\sigma"},
                                                    {"β", "\\beta"},
                                                    {"τ", "\\tau"},
                                                    {"ε", "\\varepsilon"},
                                                    {"γ", "\\gamma"},
                                                    {"η", "\\eta"},
                                                    {"θ", "\\theta"},
                                                    {"δ", "\\delta"},
                                                    {"ν", "\\nu"},
                                                    {"φ", "\\varphi"},
                                                    {"μ", "\\mu"},
                                                    {"Δ", "\\Delta"},
                                                    {"Σ", "\\Sigma"}});

/// What is written otherwise between two $.
constexpr auto formula_signs = std::to_array<Sign>(
    {{"−", "-"}, {"·", "\\cdot "}, {"…", "\\ldots"}, {"²", "^2"}, {"³", "^3"}, {"⁴", "^4"}, {"⁵", "^5"}});

constexpr auto latex_signs = std::to_array<Sign>({
    {"′", "\\ensuremath{'}"},
    {"″", "\\ensuremath{''}"},
    {"⟂", "\\ensuremath{\\perp}"},
    {"›", "\\ensuremath{>}"},
    {"≈", "\\ensuremath{\\approx}"},
    {"×", "\\ensuremath{\\times}"},
    {"<", "\\textless{}"},
    {">", "\\textgreater{}"},
    {"|", "\\textbar{}"},
    {"\n", " "},
    {"°", "\\ensuremath{^\\circ}"},
    {"−", "\\ensuremath{-}"},
    {"·", "\\ensuremath{\\cdot}"},
    {"√", "\\ensuremath{\\surd}"},
    {"∫", "\\ensuremath{\\int}"},
    {"⁰", "\\ensuremath{^0}"},
    {"¹", "\\ensuremath{^1}"},
    {"²", "\\ensuremath{^2}"},
    {"³", "\\ensuremath{^3}"},
    {"⁴", "\\ensuremath{^4}"},
    {"⁵", "\\ensuremath{^5}"},
    {"⁻", "\\ensuremath{^{-}}"},
    {"⁶", "\\ensuremath{^{6}}"},
    {"ᵀ", "\\ensuremath{^{\\mathsf T}}"},
    {"–", "--"},
    {"…", "\\ldots{}"},
    {"_", "\\_"},
    {"%", "\\%"},
    {"&", "\\&"},
    {"#", "\\#"},
    {"$", "\\$"},
    {"{", "\\{"},
    {"}", "\\}"},
    {"^", "\\textasciicircum{}"},
    {"~", "\\textasciitilde{}"},
    {"\\", "\\textbackslash{}"},
});

template <std::size_t N> const Sign* sign_at(std::string_view text, const std::array<Sign, N>& signs)
{
    const auto found = std::ranges::find_if(signs, [&](const Sign& sign) { return text.starts_with(sign.first); });
    return found == signs.end() ? nullptr : &*found;
}

/// The letters, digits and primes at the beginning of a text: an index. They are taken from it.
std::string index_of(std::string_view& text)
{
    constexpr std::string_view prime = "′";
    std::string index;
    while (!text.empty()) {
        const bool is_prime = text.starts_with(prime);
        const bool is_plain = std::isalnum(static_cast<unsigned char>(text.front())) != 0;
        if (!is_prime && !is_plain) break;
        index += is_prime ? '\'' : text.front();
        text.remove_prefix(is_prime ? prime.size() : 1);
    }
    return index;
}

bool is_letter_or_digit(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0; }

/// A hyphen before a number, not one inside a name: -3, but N-3.
bool is_minus(std::string_view text, char before)
{
    const bool is_before_digit = text.size() > 1 && text[0] == '-' && text[1] >= '0' && text[1] <= '9';
    return is_before_digit && !is_letter_or_digit(before);
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// "e+06" behind a digit; it is taken from the text. Nothing where there is no power of ten.
std::string power_of_ten(std::string_view& text, char before)
{
    const bool has_sign = text.size() > 2 && text[0] == 'e' && (text[1] == '+' || text[1] == '-');
    if (!has_sign || !is_digit(before) || !is_digit(text[2])) return {};
    std::size_t end = 2;
    while (end < text.size() && is_digit(text[end])) ++end;
    if (end < text.size() && is_letter_or_digit(text[end])) return {};
    std::string_view digits = text.substr(2, end - 2);
    digits.remove_prefix(std::min(digits.find_first_not_of('0'), digits.size() - 1));
    const std::string power = (text[1] == '-' ? "-" : "") + std::string(digits);
    text.remove_prefix(end);
    return "\\cdot 10^{" + power + "}";
}

/// After the end of a line, [ and * would be options of it.
std::string row_text(const std::vector<std::string>& cells)
{
    const bool begins_option = cells.front().starts_with('[') || cells.front().starts_with('*');
    std::string text = begins_option ? "{}" : "";
    for (std::size_t i = 0; i < cells.size(); ++i) text += (i == 0 ? "" : " & ") + latex_text(cells[i]);
    return text + " \\\\\n";
}

} // namespace

std::string latex_text(std::string_view text)
{
    std::string out;
    char before = ' ';
    while (!text.empty()) {
        if (const Sign* letter = sign_at(text, latex_letters)) {
            text.remove_prefix(letter->first.size());
            const std::string index = index_of(text);
            out += "\\ensuremath{" + std::string(letter->second) + (index.empty() ? "" : "_{" + index + "}") + "}";
            before = 'x';
            continue;
        }
        if (const std::string power = power_of_ten(text, before); !power.empty()) {
            out += "\\ensuremath{" + power + "}";
            before = ' ';
            continue;
        }
        const Sign* const sign = sign_at(text, latex_signs);
        if (sign != nullptr) out += sign->second;
        else out += is_minus(text, before) ? "\\ensuremath{-}" : std::string(1, text.front());
        before = text.front();
        text.remove_prefix(sign != nullptr ? sign->first.size() : 1);
    }
    return out;
}

std::string latex_formula(std::string_view text)
{
    std::string out;
    char before = ' ';
    while (!text.empty()) {
        if (const std::string power = power_of_ten(text, before); !power.empty()) {
            out += power;
            before = ' ';
            continue;
        }
        const Sign* const sign = sign_at(text, formula_signs);
        const bool is_decimal = text.size() > 1 && text[0] == ',' && is_digit(before) && is_digit(text[1]);
        if (sign != nullptr) out += sign->second;
        else out += is_decimal ? "{,}" : std::string(1, text.front());
        before = text.front();
        text.remove_prefix(sign != nullptr ? sign->first.size() : 1);
    }
    return out;
}

std::string latex(const Table& table)
{
    std::string text = "\\begin{tabular}{";
    for (std::size_t i = 0; i < table.columns.size(); ++i) text += alignment(table, i) == Alignment::Right ? 'r' : 'l';
    text += "}\n";
    const std::string rule = has_headings(table) ? "\\hline\n" : "";
    if (!rule.empty()) text += rule + row_text(labels(table)) + rule;
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
        if (table.n_sums > 0 && i + table.n_sums == table.rows.size()) text += "\\hline\n";
        text += row_text(shown_texts(table.rows[i]));
    }
    return text + rule + "\\end{tabular}\n";
}

} // namespace tabular
