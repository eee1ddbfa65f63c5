#pragma once

#include <string>
#include <vector>

#include "apps/plane/view/plate_picture.h"
#include "femoop/model/ids.h"

namespace plane {

/// What a picture of a plane model shows, for a reader who cannot see it: a sentence a line. Extremes with their places,
/// the error, states at probes, and what acts on cuts beside what beam theory says of it.
std::string in_words(const PlateInput& input, const PlateOptions& options);

/// The body once, then of each of these cases its loads and everything that it does.
std::string cases_in_words(const PlateInput& input, PlateOptions options, const std::vector<femoop::CaseId>& cases);

/// Of it what the results are: empty where there are none.
std::string results_in_words(const PlateInput& input, const PlateOptions& options);

} // namespace plane
