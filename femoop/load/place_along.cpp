#include "femoop/load/place_along.h"

#include <algorithm>

namespace femoop {

double written_place(const Position& position, double L)
{
    const auto* const percent = std::get_if<Percent>(&position);
    return percent ? percent->value / 100.0 * L : std::get<Quantity>(position).value();
}

double along(const Position& position, double L) { return std::clamp(written_place(position, L), 0.0, L); }

} // namespace femoop
