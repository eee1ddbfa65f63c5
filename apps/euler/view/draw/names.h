#pragma once

#include "apps/euler/view/draw/palette.h"
#include "apps/euler/view/shapes/shapes.h"
#include "ui/paint/painter.h"

namespace euler {

/// Writes the names that the look asks for beside what they name, none over another. Where there is no room a name is
/// left out, that of a hidden or small thing first; those of a step, a selection and the pointer are the last to go.
void write_names(ui::Painter& painter, const Shapes& shapes, std::span<const Subject> subjects, const Palette& palette,
                 const Look& look);

} // namespace euler
