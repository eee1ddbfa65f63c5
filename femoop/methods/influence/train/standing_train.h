#pragma once

#include <optional>
#include <string>
#include <vector>

#include "femoop/methods/influence/load_path.h"
#include "femoop/methods/influence/train/train_search.h"
#include "femoop/model/load.h"

namespace femoop::influence {

/// A single force of a train that stands on the path: an axle, or a concentrated force.
struct StandingForce {
    double s = 0.0, force = 0.0;
    std::optional<std::size_t> axle; ///< counted from 0, the leading one; nothing for a concentrated force
};

/// Those of a placing: the axles from the leading one, without those off the path; then the concentrated forces.
/// \param length  of the path
std::vector<StandingForce> standing_forces(const MovingTrain& train, const Placing& placing, double length);

/// A train where it was placed, as loads on the structure: what an analysis of them finds is the placing's value.
/// \param load  the unit load, global axes  \pre the placing is of a line along the path
LoadCase standing_train(std::string id, const PathLayout& path, const NodeVector& load, const MovingTrain& train,
                        const Placing& placing);

} // namespace femoop::influence
