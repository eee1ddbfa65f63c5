#include "femoop/model/dimension.h"

#include <array>
#include <string_view>
#include <utility>

namespace femoop {

namespace {

constexpr std::array<std::pair<Dimension, std::string_view>, 20> names{{
    {dimension::none, "plain number"},
    {dimension::length, "length"},
    {dimension::area, "area"},
    {{.length = 3}, "volume or section modulus"},
    {dimension::second_moment, "second moment of area"},
    {dimension::angle, "angle"},
    {dimension::force, "force"},
    {dimension::moment, "moment"},
    {dimension::force_per_length, "force per length"},
    {dimension::moment_per_angle, "rotational stiffness"},
    {dimension::stress, "stress or force per area"},
    {{.length = -3, .force = 1}, "weight per volume"},
    {dimension::mass, "mass"},
    {dimension::rotary_mass, "rotary mass"},
    {dimension::density, "density"},
    {{.length = -2, .force = 1, .time = 2}, "mass per length"},
    {{.time = 1}, "time"},
    {dimension::frequency, "frequency"},
    {dimension::temperature, "temperature"},
    {dimension::expansion, "coefficient of thermal expansion"},
}};

void append(std::string& text, std::string_view name, int exponent)
{
    if (exponent == 0) return;
    if (!text.empty()) text += '*';
    text += name;
    if (exponent != 1) text += '^' + std::to_string(exponent);
}

} // namespace

std::string description(Dimension dimension)
{
    for (const auto& [known, name] : names)
        if (known == dimension) return std::string(name);
    std::string text;
    append(text, "force", dimension.force);
    append(text, "length", dimension.length);
    append(text, "time", dimension.time);
    append(text, "temperature", dimension.temperature);
    append(text, "angle", dimension.angle);
    return text;
}

} // namespace femoop
