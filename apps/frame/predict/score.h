#pragma once

#include <cstdint>
#include <vector>

#include "apps/frame/predict/aspects.h"

namespace frame {

/// How good a sketched diagram is. The size of the sketch does not matter: both diagrams are compared with their
/// largest ordinate as 1.
///
/// Points   the sign counts as much as all the rest: zeros 2, degree 2, jumps 2, place of the largest 1
///          zeros and jumps count only where the true diagram has some, or the guess has some too many
/// Mirrored where nearly all lies on the wrong side the sign is lost, and the rest is judged as if it were turned over
struct Score {
    double share = 0.0; ///< of all points, 0 to 1
    double drawn = 0.0; ///< share of the length
    double sign = 0.0;
    bool is_mirrored = false;
    PlaceCount zeros, jumps;
    std::vector<PieceMark> pieces;
    double degree = 0.0; ///< of the pieces, by their lengths
    double extreme = 0.0;
};

/// \pre truth.largest > 0. A guess that is empty or zero everywhere gets nothing.
Score score(const Truth& truth, const Guess& guess);

} // namespace frame
