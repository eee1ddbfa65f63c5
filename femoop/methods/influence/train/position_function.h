#pragma once

#include <cstddef>
#include <vector>

#include "femoop/element/polynomial.h"
#include "femoop/methods/influence/piecewise_line.h"
#include "femoop/model/expected.h"

namespace femoop::influence {

/// A function of a position along a path: a polynomial between breaks, a constant before the first and after the last,
/// and at a break a value on either side.
///
///      before   |  piece   |   piece  |   after
///   ------------+----------+----------+------------> x
///
/// Pieces that are shorter than `shortest` come of rounding where two breaks are one, and are left out: what is taken
/// at a break is then the limit of all terms together.
class PositionFunction {
public:
    struct Piece {
        double from = 0.0, to = 0.0;
        Polynomial value; ///< in t = x - from
    };
    /// factor times of(x - shift).
    struct Term {
        const PositionFunction* of = nullptr;
        double factor = 1.0;
        double shift = 0.0;
    };
    /// A place where the function may be largest: a side of a break, or a root of the derivative.
    struct Candidate {
        enum class Kind : std::uint8_t { BreakAfter, Root, BreakBefore }; ///< the + side, .., the - side of a break
        double x = 0.0, value = 0.0;
        Kind kind = Kind::Root;
    };

    PositionFunction() = default;
    explicit PositionFunction(const PiecewiseLine& line); ///< 0 beyond the line's ends
    PositionFunction(std::vector<Piece> pieces, double before, double after);

    static PositionFunction sum(const std::vector<Term>& terms, double shortest);

    /// x -> of(length - x).
    PositionFunction mirrored(double length) const;
    PositionFunction negated() const;

    /// x -> the integral of the function from its first break to x. \pre it is 0 before and after
    PositionFunction integral() const;

    /// x -> the largest value in [x - most, x - least], again a polynomial between breaks: the value at one end of the
    /// window, or a candidate within. \pre least < most
    PositionFunction largest_within(double least, double most, double shortest) const;

    std::vector<Candidate> candidates() const; ///< ascending; none of a constant
    double value(double x, Side side, double shortest) const;

    const std::vector<Piece>& pieces() const { return pieces_; }
    double before() const { return before_; }
    double after() const { return after_; }
    double largest_magnitude() const; ///< of the coefficients' sums: not less than any value

private:
    std::vector<Piece> pieces_;
    double before_ = 0.0, after_ = 0.0;
};

/// Where p has an extreme within (0, end), ascending: the roots of its derivative. \pre end > 0
std::vector<double> stationary_places(const Polynomial& p, double end);

} // namespace femoop::influence
