#pragma once

#include "femoop/methods/influence/train/position_function.h"
#include "femoop/methods/influence/train/train_search.h"
#include "ui/paint/painter.h"
#include "ui/paint/theme.h"
#include "ui/text/catalogue.h"
#include "ui/text/display_units.h"

#include <optional>
#include <vector>

namespace drawing {

/// What a train does to an effect over the position of its leading axle.
struct PositionCurve {
    /// Running one way.
    struct Run {
        femoop::influence::PositionFunction effect;
        double from = 0.0, to = 0.0; ///< positions with some axle on the path
        bool is_reversed = false;
    };
    /// A position and what the train does there.
    struct Place {
        double position = 0.0, value = 0.0;
    };
    std::vector<Run> runs;           ///< forwards, and reversed where it runs that way too
    std::vector<Place> candidates{}; ///< where it may be worst
    std::optional<Place> worst;      ///< nothing where the axles are best away
    Place now;                       ///< where it stands
    double path_length = 0.0;
    ui::Role role = ui::Role::BendingMoment;
    ui::Measure measure = ui::Measure::Moment; ///< of the effect
};

/// Where a level path stands on the sheet: x of its beginning and of its end [logical pixels].
struct PathOnSheet {
    double begin = 0.0, end = 0.0;
};

/// How it is drawn.
struct CurveLook {
    const ui::Theme& theme;
    const ui::DisplayUnits& units;
    const ui::Catalogue& tr;
    std::optional<PathOnSheet> path{}; ///< positions stand below its places where all of them have room
};

/// Positions with some axle on the path, of all runs.
femoop::influence::Stretch positions(const PositionCurve& curve);

/// That it takes of a sheet; 0 where the sheet is too low for it.
double curve_height(const ui::Theme& theme, ui::Size sheet);

/// A diagram of its own, below the path or across the box: a reversed run is dashed, small discs stand at the candidates, a ring at the
/// critical place, a line and a disc where the train stands. Positive values are above.
void draw_position_curve(ui::Painter& painter, const PositionCurve& curve, const ui::Box& box, const CurveLook& look);

} // namespace drawing
