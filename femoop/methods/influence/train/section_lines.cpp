#include "femoop/methods/influence/train/section_lines.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "femoop/methods/influence/polynomial_terms.h"

namespace femoop::influence {

namespace {

constexpr double one_border = 1e-9;   ///< of the path
constexpr double one_ordinate = 1e-9; ///< of the largest ordinate

Polynomial combined(const Polynomial& p, const Polynomial& q, double factor)
{
    Polynomial result;
    for (std::size_t i = 0; i < std::max(p.n_terms(), q.n_terms()); ++i) result.append(p[i] + factor * q[i]);
    return result;
}

/// p (a + b t).
Polynomial times_linear(const Polynomial& p, double a, double b)
{
    Polynomial result;
    for (std::size_t i = 0; i <= p.n_terms(); ++i) result.append(a * p[i] + (i > 0 ? b * p[i - 1] : 0.0));
    return result;
}

/// The polynomial through values at places.
Polynomial through(const std::vector<double>& places, const std::vector<double>& values)
{
    Polynomial result{0.0};
    for (std::size_t i = 0; i < places.size(); ++i) {
        Polynomial one{1.0};
        double scale = 1.0;
        for (std::size_t j = 0; j < places.size(); ++j) {
            if (j == i) continue;
            one = times_linear(one, -places[j], 1.0);
            scale *= places[i] - places[j];
        }
        result = combined(result, one, values[i] / scale);
    }
    return result;
}

/// The piece's polynomial in s - origin.
Polynomial piece_about(const LinePiece& piece, double origin)
{
    return polynomial_of(piece.coefficients).shifted(origin - piece.from);
}

} // namespace

SectionLines::SectionLines(Source source, double length, std::size_t degree)
    : source_(std::move(source)), length_(length), degree_(degree)
{
    std::vector<PiecewiseLine> lines;
    for (const double x : nodes()) lines.push_back(source_(x));
    const bool are_alike = std::ranges::all_of(
        lines, [&](const PiecewiseLine& line) { return line.pieces.size() == lines.front().pieces.size(); });
    if (!are_alike || lines.front().pieces.empty()) return;
    fit(lines);
    const double other = 0.83 * length_;
    is_polynomial_ = is_as(source_(other), other);
}

/// Inside the member, so that the section always parts its own piece.
std::vector<double> SectionLines::nodes() const
{
    std::vector<double> places;
    const std::size_t n = degree_ + 1;
    for (std::size_t i = 0; i < n; ++i)
        places.push_back(length_ * static_cast<double>(i + 1) / static_cast<double>(n + 1));
    return places;
}

void SectionLines::fit(const std::vector<PiecewiseLine>& lines)
{
    for (std::size_t i = 0; i < lines.front().pieces.size(); ++i) fit_region(i, lines);
}

void SectionLines::fit_region(std::size_t i, const std::vector<PiecewiseLine>& lines)
{
    const std::vector<double> x = nodes();
    const double path = lines.front().pieces.back().to;
    const LinePiece &first = lines.front().pieces[i], &last = lines.back().pieces[i];
    const auto border = [&](double here, double there) {
        if (std::abs(there - here) <= one_border * path) return Border{here, 0.0};
        const double b = there > here ? 1.0 : -1.0;
        return Border{here - b * x.front(), b};
    };
    Region region{border(first.from, last.from), border(first.to, last.to), 0.0, {}};
    region.origin = region.from.b == 0.0 ? region.from.a : region.to.a;
    std::vector<Polynomial> polynomials;
    std::size_t n_terms = 0;
    for (const PiecewiseLine& line : lines) {
        polynomials.push_back(piece_about(line.pieces[i], region.origin));
        n_terms = std::max(n_terms, polynomials.back().n_terms());
    }
    for (std::size_t k = 0; k < n_terms; ++k) {
        std::vector<double> values;
        for (const Polynomial& p : polynomials) values.push_back(p[k]);
        region.coefficients.push_back(through(x, values));
    }
    regions_.push_back(std::move(region));
}

bool SectionLines::is_as(const PiecewiseLine& line, double x) const
{
    if (line.pieces.size() != regions_.size()) return false;
    double largest = 0.0, difference = 0.0;
    for (std::size_t i = 0; i < regions_.size(); ++i) {
        const LinePiece own = piece(regions_[i], x), &other = line.pieces[i];
        const double path = line.pieces.back().to;
        if (std::abs(own.from - other.from) > one_border * path || std::abs(own.to - other.to) > one_border * path)
            return false;
        const Polynomial p = polynomial_of(own.coefficients), q = polynomial_of(other.coefficients);
        for (const double part : {0.0, 0.3, 0.5, 0.8, 1.0}) {
            const double t = part * (other.to - other.from);
            largest = std::max(largest, std::abs(q(t)));
            difference = std::max(difference, std::abs(p(t) - q(t)));
        }
    }
    return difference <= one_ordinate * largest;
}

LinePiece SectionLines::piece(const Region& region, double x) const
{
    LinePiece piece{region.from.at(x), region.to.at(x), {}};
    Polynomial about_origin;
    for (const Polynomial& coefficient : region.coefficients) about_origin.append(coefficient(x));
    const Polynomial moved = about_origin.shifted(piece.from - region.origin);
    for (std::size_t k = 0; k < moved.n_terms(); ++k) piece.coefficients.push_back(moved[k]);
    return piece;
}

PiecewiseLine SectionLines::at(double x) const
{
    if (!is_polynomial_) return source_(x);
    PiecewiseLine line;
    for (const Region& region : regions_) line.pieces.push_back(piece(region, x));
    return line;
}

/// The section's own places on the path, one for each pass.
std::vector<SectionLines::Border> SectionLines::sections() const
{
    std::vector<Border> places;
    for (const Region& region : regions_)
        if (region.to.b != 0.0) places.push_back(region.to);
    return places;
}

std::vector<PositionFunction> SectionLines::with_axle_at_section(const MovingTrain& train, double shortest) const
{
    std::vector<PositionFunction> all;
    if (!is_polynomial_) return all;
    std::vector<double> behind{0.0}; // the leading axle
    for (const MovingTrain::Spacing& spacing : train.spacings) behind.push_back(behind.back() + spacing.least);
    for (const Border& section : sections())
        for (const double direction : {1.0, -1.0}) {
            if (direction < 0.0 && !train.both_directions) continue;
            for (std::size_t i = 0; i < train.axles.size(); ++i) {
                std::vector<double> distances; // of the axles from the section, along s
                for (std::size_t j = 0; j < train.axles.size(); ++j)
                    distances.push_back(direction * (behind[i] - behind[j]));
                for (const Side side : {Side::Before, Side::After})
                    all.push_back(along_section(section, train.axles, distances, side, shortest));
            }
        }
    return all;
}

/// Where an axle passes a border that does not go with the section.
std::vector<double> SectionLines::breaks(const Border& section, const std::vector<double>& distances) const
{
    std::vector<double> places{0.0, length_};
    const auto add = [&](const Border& border) {
        if (border.b == section.b) return;
        for (const double distance : distances) {
            const double x = (border.a - section.a - distance) / (section.b - border.b);
            if (x > 0.0 && x < length_) places.push_back(x);
        }
    };
    for (const Region& region : regions_) {
        add(region.from);
        add(region.to);
    }
    std::sort(places.begin(), places.end());
    return places;
}

const SectionLines::Region* SectionLines::region_at(double s, double x) const
{
    for (const Region& region : regions_)
        if (s > region.from.at(x) && s < region.to.at(x)) return &region;
    return nullptr;
}

PositionFunction SectionLines::along_section(const Border& section, const std::vector<double>& forces,
                                             const std::vector<double>& distances, Side side, double shortest) const
{
    std::vector<PositionFunction::Piece> pieces;
    const std::vector<double> places = breaks(section, distances);
    for (std::size_t i = 0; i + 1 < places.size(); ++i) {
        const double from = places[i], to = places[i + 1], middle = 0.5 * (from + to);
        if (to - from <= shortest) continue;
        Polynomial effect{0.0};
        for (std::size_t j = 0; j < forces.size(); ++j) {
            const double beside = side == Side::After ? 0.25 * shortest : -0.25 * shortest;
            const Region* const region = region_at(section.at(middle) + distances[j] + beside, middle);
            if (region == nullptr) continue;
            const double start = section.at(from) + distances[j] - region->origin;
            Polynomial ordinate{0.0};
            for (std::size_t k = region->coefficients.size(); k-- > 0;)
                ordinate = combined(times_linear(ordinate, start, section.b), region->coefficients[k].shifted(from),
                                    1.0);
            effect = combined(effect, ordinate, forces[j]);
        }
        pieces.push_back({from, to, effect});
    }
    return {std::move(pieces), 0.0, 0.0};
}

} // namespace femoop::influence
