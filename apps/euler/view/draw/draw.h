#pragma once

#include "apps/euler/view/look.h"
#include "apps/euler/view/shapes/shapes.h"
#include "ui/paint/painter.h"

#include <span>

namespace euler {

/// Paints what stands where: the one hand for all kinds of picture of a solid. The subjects are those that the shapes
/// were made of.
///
/// Where things get tiny there is less of them: no hatching on small faces, no dots on crowded vertices, no hidden
/// edges of thousands, no names where there is no room. From a hundred edges on there is less and less of it, so that a
/// frame takes about 15 ms whatever the solid, most of it the renderer's (tests/bench/euler_view_bench.cpp). Names
/// never cover one another.
void draw(ui::Painter& painter, const Shapes& shapes, std::span<const Subject> subjects, const Look& look);

/// The same as a picture of its own.
ui::Picture picture(const Shapes& shapes, std::span<const Subject> subjects, const Look& look, ui::Size sheet,
                    const ui::Fonts& fonts);

/// The sheet's colour under the look's theme.
ui::Color background(const Look& look);

} // namespace euler
