#pragma once

#include <vector>

#include "femoop/element/polynomial.h"
#include "femoop/methods/funicular/vertical_loads.h"
#include "femoop/result/curve.h"

namespace femoop::funicular {

/// The simple beam over the span of a chain, under its vertical loads.
///
///          P       q
///          v    vvvvvvv            M0  bending moment, positive where it sags
///    A o-------------------o B     V0 = dM0/dx
///      ^                   ^
///     R_A                 R_B      positive up
///
/// Units    any consistent set
/// Accuracy exact: a cubic between loads
class SimpleSpan {
public:
    /// \pre from < to, and the loads lie between them
    SimpleSpan(double from, double to, VerticalLoads loads);

    double from() const { return from_; }
    double to() const { return to_; }
    double length() const { return to_ - from_; }
    const VerticalLoads& loads() const { return loads_; }

    double left_reaction() const { return left_; }
    double right_reaction() const { return right_; }
    double moment(double x) const; ///< M0; 0 beyond the ends
    /// The M0 that is largest without its sign; of equal ones the first.
    const Extreme& largest_moment() const { return largest_; }
    std::vector<double> breaks() const; ///< ends and places where the loads change, ascending

private:
    struct Piece {
        double from, to;
        Polynomial M; ///< of x - from
    };
    void make_pieces();
    void find_largest();

    double from_, to_;
    VerticalLoads loads_;
    double left_ = 0.0, right_ = 0.0;
    std::vector<Piece> pieces_;
    Extreme largest_;
};

} // namespace femoop::funicular
