#include "femoop/model/quantity/six_digits.h"

#include <array>
#include <cstdio>

#include "femoop/model/quantity/number_text.h"
#include "femoop/tabular/halves.h"

namespace femoop {

std::string six_digits(double value, const Translator& tr)
{
    std::array<char, 32> text{};
    static_cast<void>(std::snprintf(text.data(), text.size(), "%.6g", value == 0.0 ? 0.0 : tabular::off_half(value)));
    return localized(text.data(), tr);
}

std::string place_text(std::span<const double> coordinates, const Translator& tr)
{
    std::string text;
    for (const double one : coordinates) {
        if (!text.empty()) text += decimal_mark(tr) == ',' ? "; " : ", ";
        text += six_digits(one, tr);
    }
    return "(" + text + ")";
}

} // namespace femoop
