#include "ui/text/shortened.h"

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

} // namespace ui
