#pragma once

#include <cstdint>
#include <string>

namespace femoop {

/// The dimension of a quantity: exponents of length, force, time, temperature and angle.
/// A mass is force x time^2 / length. An angle is told apart from a plain number so that degrees can be typed.
struct Dimension {
    std::int8_t length = 0;
    std::int8_t force = 0;
    std::int8_t time = 0;
    std::int8_t temperature = 0;
    std::int8_t angle = 0;

    friend constexpr bool operator==(const Dimension&, const Dimension&) = default;
};

namespace dimension {
inline constexpr Dimension none{};
inline constexpr Dimension length{.length = 1};
inline constexpr Dimension area{.length = 2};
inline constexpr Dimension second_moment{.length = 4};
inline constexpr Dimension angle{.angle = 1};
inline constexpr Dimension force{.force = 1};
inline constexpr Dimension moment{.length = 1, .force = 1};
inline constexpr Dimension force_per_length{.length = -1, .force = 1}; ///< also the stiffness of a spring
inline constexpr Dimension moment_per_length{.force = 1};
inline constexpr Dimension moment_per_angle{.length = 1, .force = 1, .angle = -1};
inline constexpr Dimension stress{.length = -2, .force = 1}; ///< also the modulus of a foundation
inline constexpr Dimension mass{.length = -1, .force = 1, .time = 2};
inline constexpr Dimension rotary_mass{.length = 1, .force = 1, .time = 2};
inline constexpr Dimension density{.length = -4, .force = 1, .time = 2};
inline constexpr Dimension frequency{.time = -1};
inline constexpr Dimension temperature{.temperature = 1};
inline constexpr Dimension expansion{.temperature = -1};
} // namespace dimension

/// "force per length", "moment", "stress"; a dimension without a name of its own is spelled out: "force^2*length".
std::string description(Dimension dimension);

} // namespace femoop
