#pragma once

#include <optional>
#include <string>
#include <vector>

#include "femoop/model/model.h"

namespace femoop::influence {

/// One answer of a file's block `train`: the largest or least of an effect, and of an `extreme` the sections where.
struct TrainCheck {
    MovingEffect effect;
    ExtremeKind which = ExtremeKind::Max;
    Quantity value;
    std::optional<double> rtol;
    std::optional<Quantity> atol;
    std::vector<Position> sections; ///< all that there are; none where the file is silent
    std::string place;              ///< as faults name it
};

/// The block `train` of a model file: a train with its answers.
struct TrainBlock {
    Train train; ///< its id is the block's `name`, else "train"
    std::vector<TrainCheck> checks;
};

/// Nothing if the model has no such block. \throws ModelError with everything that is wrong in it
std::optional<TrainBlock> train_block_of(const Model& model);

} // namespace femoop::influence
