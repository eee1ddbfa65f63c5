#pragma once

#include "femoop/model/moving_load.h"
#include "ui/paint/painter.h"
#include "ui/paint/theme.h"
#include "ui/text/catalogue.h"
#include "ui/text/display_units.h"

namespace drawing {

/// How a train is drawn.
struct TrainLook {
    ui::Theme theme;
    ui::DisplayUnits units;
    const ui::Catalogue& tr;
};

/// Draws a train on the painter's whole sheet, to scale along its path: each axle as a wheel with its force, arrows as
/// long as their forces are large; the distances as dimensions; the uniform load above the wheels. The leading axle
/// stands at the right, and the train runs to the right.
///
///      P3            P2       P1
///       |             |        |   -->
///       v             v        v
///       o             o        o
///       |-- 14…30 ft -|- 14 ft-|       where it varies the least one is drawn, and what more it may be is dashed
void draw_train(ui::Painter& painter, const femoop::Train& train, const TrainLook& look);

} // namespace drawing
