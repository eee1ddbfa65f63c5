#pragma once

#include <optional>
#include <string>
#include <vector>

#include "femoop/methods/influence/train/train_analysis.h"

namespace femoop::influence {

/// What is printed of one train, or of one envelope of several.
struct TrainResults {
    /// The candidates of one effect.
    struct Proof {
        SearchProof max, min;
    };
    std::string id;
    bool is_envelope = false; ///< then each value names its train
    std::vector<TrainEffect> effects;
    std::vector<TrainExtreme> extremes;
    std::vector<Proof> proofs; ///< parallel to effects, or none
};

} // namespace femoop::influence
