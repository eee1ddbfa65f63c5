#pragma once

#include "apps/drawing/sketch/symbols.h"
#include "femoop/model/dof.h"

#include <cstdint>

namespace drawing {

/// Which symbol stands for what a support of the plane blocks, apart from springs.
enum class SupportSymbol : std::uint8_t { None, Wall, Pin, RollerX, RollerY, SliderX, SliderY, NoRotation };

SupportSymbol support_symbol(femoop::DofSet blocked);
/// Below the frame's origin, which is held; its y points out of the ground.
void draw(Sketch& sketch, SupportSymbol symbol, const SymbolFrame& frame);

} // namespace drawing
