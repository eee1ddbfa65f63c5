#include "apps/mohr/view/axis.h"

#include "apps/mohr/document/edit.h"
#include "apps/mohr/view/names.h"

namespace mohr {

double tick_step(double pixels_per_unit, double least_pixels) { return round_step(least_pixels / pixels_per_unit); }

std::string axis_title(const std::string& name, const std::string& unit)
{
    return unit.empty() ? name : name + " [" + printed_unit(unit) + "]";
}

} // namespace mohr
