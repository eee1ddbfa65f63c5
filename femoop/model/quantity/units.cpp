#include "femoop/model/quantity/units.h"

#include <array>
#include <cstddef>
#include <utility>

namespace femoop {

namespace {

constexpr std::array<std::string_view, 6> length_names{"m", "mm", "cm", "km", "in", "ft"};
constexpr std::array<double, 6> length_in_m{1.0, 1e-3, 1e-2, 1e3, 0.0254, 0.3048};
constexpr std::array<std::string_view, 7> force_unit_names{"N", "kN", "MN", "lbf", "kip", "tf", "kgf"};
constexpr std::array<double, 7> force_in_N{1.0, 1e3, 1e6, 4.4482216152605, 4448.2216152605, 9806.65, 9.80665};

template <class Unit, std::size_t N>
std::optional<Unit> find(const std::array<std::string_view, N>& names, std::string_view name)
{
    for (std::size_t i = 0; i < N; ++i)
        if (names[i] == name) return static_cast<Unit>(i);
    return std::nullopt;
}

std::string power(std::string_view unit, int exponent)
{
    return std::string(unit) + (exponent == 1 ? "" : "^" + std::to_string(exponent));
}

} // namespace

double metres(LengthUnit unit) { return length_in_m[static_cast<std::size_t>(unit)]; }
double newtons(ForceUnit unit) { return force_in_N[static_cast<std::size_t>(unit)]; }
std::string_view name(LengthUnit unit) { return length_names[static_cast<std::size_t>(unit)]; }
std::string_view name(ForceUnit unit) { return force_unit_names[static_cast<std::size_t>(unit)]; }

std::optional<LengthUnit> find_length_unit(std::string_view name) { return find<LengthUnit>(length_names, name); }
std::optional<ForceUnit> find_force_unit(std::string_view name) { return find<ForceUnit>(force_unit_names, name); }

std::string unit_text(Dimension dimension, const Units& units)
{
    const std::array<std::pair<std::string_view, int>, 5> factors{{{name(units.force), dimension.force},
                                                                   {name(units.length), dimension.length},
                                                                   {"s", dimension.time},
                                                                   {"K", dimension.temperature},
                                                                   {"rad", dimension.angle}}};
    std::string text;
    for (const auto& [unit, exponent] : factors)
        if (exponent > 0) text += (text.empty() ? "" : "*") + power(unit, exponent);
    for (const auto& [unit, exponent] : factors)
        if (exponent < 0) text += (text.empty() ? "1/" : "/") + power(unit, -exponent);
    return text;
}

} // namespace femoop
