#include "apps/cli/plane_input.h"

namespace cli {

std::unique_ptr<const discretize::Drawing> drawing_of(femoop::plane::PlaneReading& reading)
{
    if (!reading.model.is_drawn || !reading.is_sound()) return nullptr;
    auto drawing = std::make_unique<const discretize::Drawing>(reading.model);
    reading.faults.insert(reading.faults.end(), drawing->faults().begin(), drawing->faults().end());
    return drawing;
}

} // namespace cli
