#include "femoop/methods/influence/line_shape.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace femoop::influence {

namespace {

constexpr double rounding_share = 1e-6; // of the largest ordinate
constexpr double one_place = 1e-6;      // of the path: nearer ones are the same

class ShapeOfLine {
public:
    explicit ShapeOfLine(const InfluenceLine& line)
        : line_(line), pieces_(line.ordinates.pieces), rounding_(rounding_share * line.ordinates.largest())
    {}

    LineShape shape() const
    {
        LineShape shape;
        for (std::size_t i = 0; i < pieces_.size(); ++i) {
            if (i > 0) add_joint(pieces_[i - 1], pieces_[i], shape);
            add_stretch(i, shape.stretches);
        }
        for (std::size_t i = 0; i < pieces_.size(); ++i) add_zeros(i, shape);
        return shape;
    }

private:
    bool is_zero(const LinePiece& piece) const
    {
        const std::vector<double> turns = piece.turning_places();
        const auto vanishes = [&](double s) { return std::abs(piece.value(s)) <= rounding_; };
        return vanishes(piece.from) && vanishes(piece.to) && std::ranges::all_of(turns, vanishes);
    }

    /// Without what rounding leaves of higher terms.
    int degree(const LinePiece& piece) const
    {
        int degree = 0;
        for (std::size_t k = 1; k < piece.coefficients.size(); ++k)
            if (std::abs(piece.coefficients[k]) * std::pow(piece.length(), static_cast<double>(k)) > rounding_)
                degree = static_cast<int>(k);
        return degree;
    }

    bool is_series(const LinePiece& piece) const
    {
        return std::ranges::any_of(line_.stretches, [&](const LineStretch& stretch) {
            return stretch.is_series && stretch.from <= piece.from && piece.to <= stretch.to;
        });
    }

    /// The formula does not change from the one to the other.
    bool goes_on(const LinePiece& before, const LinePiece& after) const
    {
        const double middle = 0.5 * (after.from + after.to);
        return std::ranges::all_of(std::array{after.from, middle, after.to},
                                   [&](double s) { return std::abs(before.value(s) - after.value(s)) <= rounding_; });
    }

    void add_joint(const LinePiece& before, const LinePiece& after, LineShape& shape) const
    {
        const double s = after.from, left = before.value(s), right = after.value(s);
        const double turn = std::abs(after.slope(s) - before.slope(s));
        if (std::abs(right - left) > rounding_) shape.jumps.push_back({s, left, right});
        else if (turn * std::min(before.length(), after.length()) > rounding_) shape.kinks.push_back(s);
    }

    void add_stretch(std::size_t i, std::vector<LineShape::Stretch>& stretches) const
    {
        const LinePiece& piece = pieces_[i];
        const LineShape::Stretch own{.from = piece.from,
                                     .to = piece.to,
                                     .degree = degree(piece),
                                     .is_series = is_series(piece),
                                     .is_zero = is_zero(piece)};
        const bool is_like_last = !stretches.empty() && stretches.back().is_zero == own.is_zero &&
                                  stretches.back().is_series == own.is_series &&
                                  (own.is_series || stretches.back().degree == own.degree);
        if (!is_like_last) {
            stretches.push_back(own);
            return;
        }
        stretches.back().to = own.to;
        if (!own.is_series && !goes_on(pieces_[i - 1], piece)) ++stretches.back().n_pieces;
    }

    void add_zeros(std::size_t i, LineShape& shape) const
    {
        const LinePiece& piece = pieces_[i];
        if (is_zero(piece)) return;
        for (const double s : {piece.from, piece.to})
            if (std::abs(piece.value(s)) <= rounding_) add_zero(s, shape);
        for (const double s : piece.places_of(0.0)) add_zero(s, shape);
        std::ranges::sort(shape.zeros);
    }

    void add_zero(double s, LineShape& shape) const
    {
        const auto is_here = [&](double other) { return std::abs(other - s) <= one_place * line_.ordinates.length(); };
        const bool is_told = std::ranges::any_of(shape.zeros, is_here) ||
                             std::ranges::any_of(shape.jumps, is_here, &LineShape::Jump::s) ||
                             std::ranges::any_of(shape.stretches, [&](const LineShape::Stretch& stretch) {
                                 return stretch.is_zero && (is_here(stretch.from) || is_here(stretch.to));
                             });
        if (!is_told) shape.zeros.push_back(s);
    }

    const InfluenceLine& line_;
    const std::vector<LinePiece>& pieces_;
    double rounding_;
};

} // namespace

LineShape shape_of(const InfluenceLine& line) { return ShapeOfLine(line).shape(); }

} // namespace femoop::influence
