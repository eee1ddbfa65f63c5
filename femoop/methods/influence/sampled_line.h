#pragma once

#include <cstddef>
#include <vector>

#include "femoop/methods/influence/piecewise_line.h"

namespace femoop::influence {

/// A stretch of a line that is found from its values at so many places as its degree wants: the polynomial through
/// them is the line itself. They lie where rounding in a value grows least between them (zeros of a Chebyshev
/// polynomial), and never at the ends, where a line may jump.
/// Source  [Higham2002, ch. 22]
class SampledStretch {
public:
    SampledStretch(double from, double to, std::size_t degree);

    double from() const { return from_; }
    double to() const { return to_; }
    std::vector<double> places() const;                       ///< degree + 1 of them
    LinePiece piece(const std::vector<double>& values) const; ///< \pre as many as places

private:
    double from_, to_;
    std::vector<double> nodes_; ///< in -1 .. 1
};

} // namespace femoop::influence
