#pragma once

#include "femoop/methods/dice.h"
#include "femoop/methods/influence/train/train_search.h"

/// A line with jumps and kinks, and a train for it.
struct RandomTrain {
    explicit RandomTrain(std::uint32_t seed);

    double ordinate(double s) const;           ///< 0 off the path
    double area(double from, double to) const; ///< under the line
    /// Of everything where it stands, axles away from jumps; single forces on the side that makes it larger, or less.
    double effect(const femoop::influence::Placing& placing, femoop::ExtremeKind kind) const;

    femoop::influence::PiecewiseLine line;
    std::vector<double> ends{0.0};
    femoop::influence::MovingTrain train;
};

/// Any place that the train may have, the spacings too. The uniform load and the single forces are not placed.
femoop::influence::Placing thrown(const RandomTrain& random, femoop::Dice& dice);
