#include "femoop/methods/influence/piecewise_line.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "femoop/methods/influence/polynomial_terms.h"

namespace femoop::influence {

namespace {

constexpr double equal_value = 1e-9; // of the largest value: less is rounding
constexpr double equal_place = 2e-5; // of the length: where a smooth extreme differs by no more than equal_value
constexpr double path_end = 1e-12;   // of the length: so far beyond an end is the end

std::vector<double> shifted(std::vector<double> places, double by)
{
    for (double& place : places) place += by;
    return places;
}

/// A place where a line is largest, or a stretch over which it stays so.
struct Summit {
    double from, to, value;

    bool is_point() const { return from == to; }
};

bool is_level(const LinePiece& piece, double begin, double end, double least)
{
    constexpr int n = 4; // a polynomial that is near its largest value there hardly leaves it between
    for (int i = 1; i < n; ++i)
        if (piece.value(begin + (end - begin) * i / n) < least) return false;
    return true;
}

void add_summits(const LinePiece& piece, double least, std::vector<Summit>& found)
{
    std::vector<double> places{piece.from};
    std::ranges::copy(piece.turning_places(), std::back_inserter(places));
    places.push_back(piece.to);
    for (std::size_t i = 0; i < places.size(); ++i) {
        const double s = places[i], value = piece.value(s);
        if (value < least) continue;
        const bool has_next = i + 1 < places.size() && piece.value(places[i + 1]) >= least;
        const bool goes_on = has_next && is_level(piece, s, places[i + 1], least);
        found.push_back({s, goes_on ? places[i + 1] : s, value});
    }
}

/// Stretches that touch are one; of places that are one but for rounding the best stays.
std::vector<Summit> distinct(const std::vector<Summit>& all, double length)
{
    std::vector<Summit> kept;
    for (const Summit& next : all) {
        if (kept.empty() || next.from - kept.back().to > equal_place * length) {
            kept.push_back(next);
            continue;
        }
        Summit& last = kept.back();
        if (!last.is_point() || !next.is_point()) last.to = std::max(last.to, next.to);
        else if (next.value > last.value) last = next;
    }
    return kept;
}

} // namespace

double LinePiece::value(double s) const
{
    double sum = 0.0;
    for (std::size_t i = coefficients.size(); i-- > 0;) sum = sum * (s - from) + coefficients[i];
    return sum;
}

double LinePiece::slope(double s) const
{
    double sum = 0.0;
    for (std::size_t i = coefficients.size(); i-- > 1;)
        sum = sum * (s - from) + static_cast<double>(i) * coefficients[i];
    return sum;
}

double LinePiece::integral(double begin, double end) const
{
    const auto up_to = [&](double s) {
        double sum = 0.0;
        for (std::size_t i = coefficients.size(); i-- > 0;)
            sum = (sum + coefficients[i] / static_cast<double>(i + 1)) * (s - from);
        return sum;
    };
    return up_to(end) - up_to(begin);
}

std::vector<double> LinePiece::places_of(double level) const
{
    std::vector<double> above = coefficients;
    if (!above.empty()) above[0] -= level;
    return shifted(polynomial_of(above).roots(length()), from);
}

std::vector<double> LinePiece::turning_places() const
{
    return shifted(polynomial_of(coefficients).derivative().roots(length()), from);
}

double PiecewiseLine::value(double s, Side side) const
{
    const double beyond = path_end * length();
    if (pieces.empty() || s < -beyond || s > length() + beyond) return 0.0;
    // The piece whose beginning is the last at s or before, also where rounding has put s a hair before it.
    const auto begins_after = [](double at, const LinePiece& piece) { return at < piece.from; };
    auto piece = std::upper_bound(pieces.begin(), pieces.end(), s + beyond, begins_after);
    if (piece != pieces.begin()) --piece;
    if (std::abs(s - piece->from) > beyond) return piece->value(s);
    const double at = piece->from;
    if (side == Side::Before && piece != pieces.begin()) --piece;
    return piece->value(at);
}

double PiecewiseLine::largest() const
{
    double found = 0.0;
    for (const LinePiece& piece : pieces) {
        for (const double s : {piece.from, piece.to}) found = std::max(found, std::abs(piece.value(s)));
        for (const double s : piece.turning_places()) found = std::max(found, std::abs(piece.value(s)));
    }
    return found;
}

std::vector<double> PiecewiseLine::jumps() const
{
    const double rounding = equal_value * largest();
    std::vector<double> places;
    for (std::size_t i = 1; i < pieces.size(); ++i) {
        const double s = pieces[i].from;
        if (std::abs(pieces[i].value(s) - pieces[i - 1].value(s)) > rounding) places.push_back(s);
    }
    return places;
}

LineExtreme PiecewiseLine::max() const
{
    if (pieces.empty()) return {};
    LineExtreme extreme{.value = pieces.front().value(0.0), .positions = {}, .is_level_after = {}};
    for (const LinePiece& piece : pieces) {
        for (const double s : {piece.from, piece.to}) extreme.value = std::max(extreme.value, piece.value(s));
        for (const double s : piece.turning_places()) extreme.value = std::max(extreme.value, piece.value(s));
    }
    const double least = extreme.value - equal_value * largest();
    std::vector<Summit> summits;
    for (const LinePiece& piece : pieces) add_summits(piece, least, summits);
    for (const Summit& summit : distinct(summits, length())) {
        extreme.positions.push_back(summit.from);
        extreme.is_level_after.push_back(!summit.is_point());
        if (summit.is_point()) continue;
        extreme.positions.push_back(summit.to);
        extreme.is_level_after.push_back(false);
    }
    return extreme;
}

LineExtreme PiecewiseLine::min() const
{
    PiecewiseLine mirrored = *this;
    for (LinePiece& piece : mirrored.pieces)
        for (double& c : piece.coefficients) c = -c;
    LineExtreme extreme = mirrored.max();
    extreme.value = extreme.value == 0.0 ? 0.0 : -extreme.value;
    return extreme;
}

LineAreas PiecewiseLine::areas() const
{
    LineAreas sum;
    for (const LinePiece& piece : pieces) {
        std::vector<double> ends = piece.places_of(0.0);
        ends.insert(ends.begin(), piece.from);
        ends.push_back(piece.to);
        for (std::size_t i = 1; i < ends.size(); ++i) {
            const double area = piece.integral(ends[i - 1], ends[i]);
            (area > 0.0 ? sum.positive : sum.negative) += area;
        }
    }
    return sum;
}

} // namespace femoop::influence
