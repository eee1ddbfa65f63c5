#pragma once

#include "apps/drawing/draw_options.h"
#include "femoop/io/train/train_results.h"
#include "femoop/model/model.h"

#include <string>

namespace drawing {

/// What trains bring a structure to, for readers who cannot see it: of each component of the members the largest and the
/// least value of all of them, of each reaction both, with the section and the place of the train that makes it; of one
/// effect both. The title and lines below it, as those of `influence_words`.
/// \pre the results have a train for each value
std::string range_words(const femoop::Model& model, const DrawOptions& options,
                        const femoop::influence::TrainResults& results, const std::string& title);

/// "G + 1.35 × (HS20, lane)"
std::string load_name(const femoop::Model& model, const DrawOptions& options, const femoop::MovingEnvelope& envelope);

/// What was looked at to find the largest and the least value of an effect: how many places of which kind, the best and
/// the next to it, and what is added to them.
std::string proof_words(const femoop::Model& model, const DrawOptions& options, const femoop::MovingEffect& effect,
                        const femoop::influence::TrainResults::Proof& proof);

} // namespace drawing
