#include "femoop/model/quantity/dimension.h"

#include <array>
#include <string_view>
#include <utility>

#include "femoop/model/fault/translator.h"

namespace femoop {

namespace {

constexpr std::array<std::pair<Dimension, std::string_view>, 20> dimension_names{{
    {dimension::none, translatable("plain number")},
    {dimension::length, translatable("length")},
    {dimension::area, translatable("area")},
    {{.length = 3}, translatable("volume or section modulus")},
    {dimension::second_moment, translatable("second moment of area")},
    {dimension::angle, translatable("angle")},
    {dimension::force, translatable("force")},
    {dimension::moment, translatable("moment")},
    {dimension::force_per_length, translatable("force per length")},
    {dimension::moment_per_angle, translatable("rotational stiffness")},
    {dimension::stress, translatable("stress or force per area")},
    {{.length = -3, .force = 1}, translatable("weight per volume")},
    {dimension::mass, translatable("mass")},
    {dimension::rotary_mass, translatable("rotary mass")},
    {dimension::density, translatable("density")},
    {{.length = -2, .force = 1, .time = 2}, translatable("mass per length")},
    {{.time = 1}, translatable("time")},
    {dimension::frequency, translatable("frequency")},
    {dimension::temperature, translatable("temperature")},
    {dimension::expansion, translatable("coefficient of thermal expansion")},
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
    for (const auto& [known, name] : dimension_names)
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
