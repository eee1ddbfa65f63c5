#include "ui/text/shortened.h"

#include <algorithm>

namespace ui {

std::string shortened(std::string_view utf8, std::size_t most)
{
    const auto begins_letter = [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; };
    std::size_t n_letters = 0, cut = 0;
    for (std::size_t i = 0; i < utf8.size(); ++i) {
        if (!begins_letter(utf8[i])) continue;
        if (n_letters + 1 == most) cut = i; // where the last letter gives way to "…"
        if (++n_letters > most) return std::string(utf8.substr(0, cut)) + "…";
    }
    return std::string(utf8);
}

std::string shortened_to_fit(std::string_view utf8, std::size_t least,
                             const std::function<bool(const std::string&)>& fits)
{
    if (std::string whole(utf8); fits(whole)) return whole;
    for (std::size_t most = utf8.size(); most >= std::max<std::size_t>(least, 1); --most)
        if (std::string beginning = shortened(utf8, most); beginning != utf8 && fits(beginning)) return beginning;
    return {};
}

std::string first_lines(const std::string& text, std::size_t most, const Catalogue& tr)
{
    const auto n = static_cast<std::size_t>(std::ranges::count(text, '\n')) + 1;
    if (n <= most) return text;
    std::size_t end = text.find('\n');
    for (std::size_t i = 1; i < most; ++i) end = text.find('\n', end + 1);
    return text.substr(0, end + 1) + tr("… and {count} more", {{"count", std::to_string(n - most)}});
}

} // namespace ui
