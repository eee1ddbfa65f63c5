#pragma once

#include <optional>
#include <string>
#include <vector>

#include "femoop/model/expected.h"
#include "femoop/model/model.h"

namespace femoop::influence {

/// A place along a path: "4-" and "4+" are just before and just after it.
struct PathPosition {
    double s = 0.0;
    std::optional<Side> side;
    std::string text; ///< as the file has it
};

/// The largest or smallest value of a line that a file knows, and all places where it stands.
struct ExtremeCheck {
    std::optional<double> value;
    std::optional<std::vector<double>> positions;
};

/// A line, and what it should come to.
struct LineCheck {
    InfluenceLineDefinition line; ///< its id is its number in the block, from 1
    std::vector<PathPosition> positions;
    std::vector<double> values; ///< one for each position, or none
    std::optional<ExtremeCheck> max, min;
    double rtol = 1e-6, atol = 0.0;
};

/// The `influence` block of a model file: a case's inputs and answers.
struct Block {
    std::vector<LineCheck> lines;
};

/// Nothing if the model has no such block. \throws ModelError with every place that is wrong
std::optional<Block> block_of(const Model& model);

} // namespace femoop::influence
