#pragma once

#include <optional>
#include <string>
#include <vector>

#include "femoop/methods/influence/influence_line.h"
#include "femoop/methods/influence/load_path.h"
#include "femoop/methods/influence/piecewise_line.h"
#include "femoop/methods/influence/train/train_search.h"
#include "femoop/model/load.h"

namespace femoop::influence {

/// A single force of a train that stands on the path: an axle, or a concentrated force.
struct StandingForce {
    double s = 0.0, force = 0.0;
    double ordinate = 0.0; ///< of the line there; at a jump the side that counts
    /// Where the line jumps: it stands just before that place, or just after it.
    std::optional<Side> beside{};
};

/// Those of a placing: the axles from the leading one, without those off the path; then the concentrated forces. Each
/// times its ordinate, and the uniform load times the area that it covers, make the placing's value.
/// \param kind  what the placing was sought for
std::vector<StandingForce> standing_forces(const MovingTrain& train, const Placing& placing, const PiecewiseLine& line,
                                           ExtremeKind kind);

/// The uniform load's share of it, stretch by stretch: the areas between the line and the path.
std::vector<double> covered_areas(const Placing& placing, const PiecewiseLine& line);

/// A train where it was placed, as loads on the structure: what an analysis of them finds is the placing's value. Beside
/// a jump a force stands by a hair.
/// \param load  the unit load, global axes  \pre the placing is of the line, which is along the path
LoadCase standing_train(std::string id, const PathLayout& path, const NodeVector& load, const MovingTrain& train,
                        const Placing& placing, const InfluenceLine& line, ExtremeKind kind);

} // namespace femoop::influence
