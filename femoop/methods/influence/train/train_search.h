#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "femoop/methods/influence/piecewise_line.h"
#include "femoop/methods/influence/train/position_function.h"
#include "femoop/model/moving_load.h"

namespace femoop::influence {

/// Loads that move along a path together, as numbers: forces along the line's unit load.
///
///   forwards     P3      P2        P1 -->         p is the place of the leading axle P1;
///                |       |         |              the others stand at smaller s, reversed at greater s
///   ---+---------+-------+---------+------------> s
///                 <- s2 -> <- s1 ->
///
/// Signs  a positive force has the direction of the unit load
/// Units  the model's base units
struct MovingTrain {
    struct Spacing {
        double least = 0.0, most = 0.0; ///< equal where it does not vary
    };
    std::vector<double> axles;     ///< from the leading one, impact included
    std::vector<Spacing> spacings; ///< one fewer; behind each axle but the last
    bool both_directions = false;
    double uniform = 0.0; ///< per length of path
    UniformExtent extent = UniformExtent::Adverse;
    double gap = 0.0;                 ///< of UniformExtent::Outside
    std::vector<double> concentrated; ///< each once, where it is worst
};

/// A part of a path.
struct Stretch {
    double from = 0.0, to = 0.0;
};

/// How a train stands, and what that comes to.
struct Placing {
    double value = 0.0;
    std::optional<double> position; ///< of the leading axle; nothing when the axles are away
    bool reversed = false;
    std::vector<double> spacings;                    ///< none when the axles are away
    std::vector<Stretch> uniform;                    ///< ascending
    std::vector<std::optional<double>> concentrated; ///< nothing for a force that is away
};

struct WorstPlacings {
    Placing max, min;
};

/// What the search for a largest or least value looked at.
struct SearchProof {
    struct Entry {
        PositionFunction::Candidate candidate; ///< x: the position of the leading axle; the value without what stays
        bool reversed = false;
    };
    std::vector<Entry> entries;
    std::optional<Entry> best;                ///< the one that the placing names; nothing when the axles are best away
    double uniform = 0.0, concentrated = 0.0; ///< what does not depend on the position
    double scale = 0.0;                       ///< what all loads together may come to

    /// All that counts where an entry stands.
    double sum(const Entry& entry) const;
    /// Whether it is as good as the best one, or as no axle on the path.
    bool is_best(const Entry& entry) const;
};

/// Where a train is worst on an influence line, exactly.
///
/// The effect of the axles at p is the sum of the line's polynomials, shifted: a polynomial between the positions at
/// which an axle passes the end of a piece. Its extremes are at these breaks, on either side, or at roots of its
/// derivative; all are looked at. A spacing that varies parts the train into groups; what the groups behind it add at
/// most is the largest value of their own function within a moving window, which is again a polynomial between breaks.
///
/// Accuracy  values to rounding; a place to the square root of it at a flat extreme
/// Assumes   axles off the path do not count; all others count together
class TrainSearch {
public:
    /// \pre the line's pieces are ascending and contiguous from 0; `ends` are the ends of the path's members: 0, .., L
    TrainSearch(const PiecewiseLine& line, std::vector<double> ends, MovingTrain train);

    WorstPlacings worst() const;
    Placing largest() const;
    Placing least() const;

    /// The effect with the leading axle at a place, the spacings given, or those that make it larger
    /// (ExtremeKind::Max) or less where none are; the uniform load and the concentrated forces likewise. At a jump the
    /// larger of the two limits, or the less. \pre the train has axles
    struct Stand {
        double position = 0.0;
        bool reversed = false;
        std::vector<double> spacings{};
    };
    Placing at(const Stand& stand, ExtremeKind kind) const;

    /// The same over all positions, as one function: with what does not depend on them.
    PositionFunction over_positions(ExtremeKind kind, bool reversed) const;
    /// Where some axle is on the path, or at its ends. \pre the train has axles
    Stretch positions(bool reversed) const;

    SearchProof proof(ExtremeKind kind) const;

private:
    PiecewiseLine line_;
    std::vector<double> ends_;
    MovingTrain train_;
};

} // namespace femoop::influence
