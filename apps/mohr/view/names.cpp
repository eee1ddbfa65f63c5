#include "apps/mohr/view/names.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

namespace mohr {

Names names_of(Subject subject)
{
    switch (subject) {
    case Subject::Strain:
    case Subject::Rosette: return {"ε", "γ/2", "ε1", "ε2", "ε3"};
    case Subject::Inertia: return {"I", "−Ixy", "I1", "I2", ""};
    default: return {"σ", "τ", "σ1", "σ2", "σ3"};
    }
}

std::string printed_unit(const std::string& unit)
{
    constexpr std::array<std::string_view, 5> raised{"⁰", "¹", "²", "³", "⁴"};
    std::string printed;
    for (std::size_t i = 0; i < unit.size(); ++i) {
        const bool is_power = unit[i] == '^' && i + 1 < unit.size() && unit[i + 1] >= '0' && unit[i + 1] <= '4';
        if (is_power) printed += raised[static_cast<std::size_t>(unit[++i] - '0')];
        else if (unit[i] == '*') printed += "·";
        else printed += unit[i];
    }
    return printed;
}

std::string unit_power(const std::string& unit, int power)
{
    if (unit.empty()) return "";
    const bool is_plain = std::ranges::all_of(unit,
                                              [](char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; });
    return (is_plain ? unit : "(" + unit + ")") + "^" + std::to_string(power);
}

std::string with_unit(const std::string& number, const std::string& unit)
{
    return number + (unit.empty() || unit == "°" ? "" : " ") + printed_unit(unit);
}

} // namespace mohr
