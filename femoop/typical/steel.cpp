#include "femoop/typical/steel.h"

#include <string>
#include <variant>

#include "femoop/model/quantity/dimension.h"
#include "femoop/model/quantity/quantity_parser.h"

namespace femoop {

Material steel(const Units& units, std::string_view E)
{
    const auto typed = [&](std::string_view text, Dimension dimension) {
        return Quantity(std::get<double>(parse_quantity(text, dimension, units)), std::string(text));
    };
    return {.id = "steel",
            .E = typed(E, dimension::stress),
            .alpha = typed("1.2e-5 1/K", dimension::expansion),
            .density = typed("7850 kg/m^3", dimension::density)};
}

} // namespace femoop
