#pragma once

#include <cstddef>
#include <optional>

#include "femoop/model/moving_load.h"
#include "femoop/model/quantity/quantity.h"
#include "femoop/model/quantity/units.h"

namespace frame {

/// Two axles of some 100 kN, some 2 m apart, in round numbers of the units: what one's own train begins with.
femoop::Train usual_train(const femoop::Units& units, femoop::LoadPathReference path);

/// Behind the last axle, of its force and as far from it as that is from the one before; the first one as in the usual
/// train.
void add_axle(femoop::Train& train, const femoop::Units& units);
/// Those beside it stay where they are. \pre the train has it
void erase_axle(femoop::Train& train, std::size_t axle);

/// The distance behind an axle; the least one where it varies. \pre 0 or more, and the axle is not the last
void set_spacing(femoop::Train& train, std::size_t axle, const femoop::Quantity& spacing);
/// It may have any value from its present one to this; not above it: it does not vary. \pre the axle is not the last
void set_longest_spacing(femoop::Train& train, std::size_t axle, const femoop::Quantity& longest);
/// Where it varies. \pre the axle is not the last
std::optional<femoop::SpacingRange> spacing_range(const femoop::Train& train, std::size_t axle);
/// How far behind the leading axle one stands at least.
double place_of_axle(const femoop::Train& train, std::size_t axle);

/// The trains behind it move up, and envelopes are without it, or gone where it was their last.
/// \pre there is such a train
void erase_train(femoop::MovingLoads& loads, femoop::TrainId train);

} // namespace frame
