#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "femoop/methods/influence/piecewise_line.h"
#include "femoop/methods/influence/train/position_function.h"
#include "femoop/methods/influence/train/train_search.h"

namespace femoop::influence {

/// The influence lines of one component at all sections x of a member, as one function of s and x.
///
///   s ^  |   fixed    |          Between nodes of the path the line is a polynomial in s whose coefficients are
///     |  |------------|          polynomials in x: linear ones for a force, cubic for a displacement. Only the
///     |  |   own    / |          section itself, s = a + b x with b = 1 or -1, parts a piece anew for each x.
///     |  |        /   |
///     |  |------------|
///     +---------------------> x  0 .. length
///
/// It is made from the lines at some sections, and held against one more: a member on a foundation is no such
/// polynomial, and then each line is asked for anew.
class SectionLines {
public:
    using Source = std::function<PiecewiseLine(double x)>; ///< the line at 0 <= x <= length

    SectionLines(Source source, double length, std::size_t degree);

    double length() const { return length_; }
    PiecewiseLine at(double x) const;

    /// The effect of axles of which one stands at the section, over x: where a force is largest, an axle stands there
    /// or the section is at an end. One function for each axle, side of the section and pass of the path over it; none
    /// where the lines are no polynomials of x.
    std::vector<PositionFunction> with_axle_at_section(const MovingTrain& train, double shortest) const;

    bool is_linear() const { return is_polynomial_ && degree_ == 1; } ///< in x

private:
    /// The place of a break: a + b x.
    struct Border {
        double a = 0.0, b = 0.0;
        double at(double x) const { return a + b * x; }
    };
    /// Between two borders: the sum of coefficients[k](x) (s - origin)^k.
    struct Region {
        Border from, to;
        double origin = 0.0;
        std::vector<Polynomial> coefficients;
    };

    std::vector<double> nodes() const;
    void fit(const std::vector<PiecewiseLine>& lines);
    void fit_region(std::size_t i, const std::vector<PiecewiseLine>& lines);
    bool is_as(const PiecewiseLine& line, double x) const;
    LinePiece piece(const Region& region, double x) const;
    std::vector<Border> sections() const;
    PositionFunction along_section(const Border& section, const std::vector<double>& forces,
                                   const std::vector<double>& distances, Side side, double shortest) const;
    std::vector<double> breaks(const Border& section, const std::vector<double>& distances) const;
    const Region* region_at(double s, double x) const;

    Source source_;
    double length_;
    std::size_t degree_;
    bool is_polynomial_ = false;
    std::vector<Region> regions_;
};

} // namespace femoop::influence
