#pragma once

#include "apps/drawing/draw_options.h"
#include "apps/drawing/results/influence_picture.h"
#include "apps/drawing/results/train_picture.h"
#include "femoop/methods/influence/train/train_search.h"
#include "femoop/model/model.h"

#include <string>

namespace drawing {

/// An influence line for readers who cannot see it: what it is of and under what, its largest and its least value with
/// all their places, and its areas; a title and lines below it, as those of femoop `describe`.
std::string influence_words(const femoop::Model& model, const DrawOptions& options, const InfluencePicture& picture);

/// Likewise a train that stands on it: where it is worst, what of it stands where, and what that comes to.
std::string train_words(const femoop::Model& model, const DrawOptions& options, const InfluencePicture& picture,
                        const StandingTrain& standing, const femoop::influence::WorstPlacings& worst);

} // namespace drawing
