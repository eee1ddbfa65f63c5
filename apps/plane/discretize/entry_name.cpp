#include "apps/plane/discretize/entry_name.h"

#include <array>
#include <cstdio>

namespace discretize {

std::string rounded(double value)
{
    std::array<char, 32> text{};
    static_cast<void>(std::snprintf(text.data(), text.size(), "%.6g", value == 0.0 ? 0.0 : value));
    return text.data();
}

std::string place_text(const PlaneModel& model, const topology::FlatPoint& at)
{
    return "(" + rounded(at.x) + ", " + rounded(at.y) + ") " + std::string(femoop::name(model.units.length));
}

} // namespace discretize
