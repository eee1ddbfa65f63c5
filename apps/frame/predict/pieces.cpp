// Of what degree a guess is, piece by piece.
#include "apps/frame/predict/aspects.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "apps/frame/predict/places.h"

namespace frame {

using namespace places;

namespace {

constexpr double eye = 0.025; // root mean square of a bend that is seen: its rise is a twelfth of the largest ordinate

/// A stretch of a profile as its straight line, by least squares, and what remains: its bend.
struct Bend {
    double rise = 0.0; ///< of the line, over the stretch
    std::vector<double> rest;

    double size() const { return std::sqrt(times(*this)); }
    double times(const Bend& other) const
    {
        return std::inner_product(rest.begin(), rest.end(), other.rest.begin(), 0.0) / static_cast<double>(rest.size());
    }
};

Bend bend_of(const Profile& profile, const std::vector<int>& places)
{
    const auto m = static_cast<double>(places.size());
    double mean_x = 0.0, mean = 0.0, xx = 0.0, xy = 0.0;
    for (const int i : places) {
        mean_x += i / m;
        mean += at(profile, i) / m;
    }
    for (const int i : places) {
        xx += (i - mean_x) * (i - mean_x);
        xy += (i - mean_x) * (at(profile, i) - mean);
    }
    const double slope = xy / xx;
    Bend bend{.rise = slope * (places.back() - places.front()), .rest = {}};
    for (const int i : places) bend.rest.push_back(at(profile, i) - mean - slope * (i - mean_x));
    return bend;
}

struct Verdict {
    double share = 0.0;
    Flaw flaw = Flaw::None;
};

Verdict curved(const Bend& wanted, const Bend& drawn)
{
    const double factor = drawn.times(wanted) / wanted.times(wanted);
    if (factor < -0.15) return {0.0, Flaw::OtherWay};
    double apart = 0.0;
    for (std::size_t i = 0; i < wanted.rest.size(); ++i)
        apart += std::pow(drawn.rest[i] - factor * wanted.rest[i], 2) / static_cast<double>(wanted.rest.size());
    const double unevenness = std::sqrt(apart) / (std::max(factor, 0.15) * wanted.size());
    const double share = ramp(factor, 0.2, 0.5) * ramp(factor, 4.0, 2.2) * ramp(unevenness, 1.0, 0.5);
    return {share, factor < 0.35 ? Flaw::Straight : Flaw::Uneven};
}

Verdict straight(const Truth::Piece& piece, const Bend& wanted, const Bend& drawn)
{
    double apart = 0.0;
    for (std::size_t i = 0; i < wanted.rest.size(); ++i)
        apart += std::pow(drawn.rest[i] - wanted.rest[i], 2) / static_cast<double>(wanted.rest.size());
    const double bent = ramp(std::sqrt(apart), 0.07, 0.03);
    if (bent < 0.6) return {bent, Flaw::Curved};
    if (piece.degree == 0) return {bent * ramp(std::abs(drawn.rise), 0.25, 0.1), Flaw::Sloping};
    if (piece.degree > 1 || std::abs(wanted.rise) < 0.15) return {bent, Flaw::Curved};
    const double ratio = drawn.rise / wanted.rise;
    return {bent * ramp(ratio, 0.15, 0.4), ratio < -0.15 ? Flaw::OtherWay : Flaw::Level};
}

std::vector<int> drawn_between(const Profile& guess, double from, double to)
{
    std::vector<int> places;
    for (int i = place_of(from); i <= place_of(to); ++i)
        if (is_drawn(guess, i)) places.push_back(i);
    return places;
}

Verdict stretch(const Truth& truth, const Profile& guess, const Truth::Piece& piece)
{
    constexpr std::size_t least_places = 8;
    const std::vector<int> places = drawn_between(guess, piece.from, piece.to);
    const int n_all = place_of(piece.to) - place_of(piece.from) + 1;
    const bool is_enough = places.size() >= least_places && static_cast<double>(places.size()) >= 0.8 * n_all;
    if (!is_enough) return {0.0, Flaw::NotDrawn};
    const Bend wanted = bend_of(truth.profile, places), drawn = bend_of(guess, places);
    return wanted.size() > eye ? curved(wanted, drawn) : straight(piece, wanted, drawn);
}

// Into how many stretches a piece is cut so that each is still seen to be curved: a triangle is like a parabola as a
// whole, but not in its parts.
int n_stretches(const Truth& truth, const Truth::Piece& piece)
{
    const double size = bend_of(truth.profile, drawn_between(truth.profile, piece.from, piece.to)).size();
    if (size > 9.0 * eye) return 3;
    return size > 4.4 * eye ? 2 : 1;
}

PieceMark marked(const Truth& truth, const Profile& guess, const Truth::Piece& piece)
{
    constexpr double border_of_piece = 0.035, good = 0.6;
    Truth::Piece inner = piece;
    inner.from += border_of_piece;
    inner.to -= border_of_piece;
    const int parts = n_stretches(truth, inner);
    PieceMark mark{.piece = piece};
    double worst = 2.0;
    for (int i = 0; i < parts; ++i) {
        Truth::Piece part = inner;
        part.from = std::lerp(inner.from, inner.to, static_cast<double>(i) / parts);
        part.to = std::lerp(inner.from, inner.to, static_cast<double>(i + 1) / parts);
        const Verdict verdict = stretch(truth, guess, part);
        mark.share += verdict.share / parts;
        if (verdict.share < worst) mark.flaw = verdict.flaw;
        worst = std::min(worst, verdict.share);
    }
    const Verdict whole = stretch(truth, guess, inner);
    if (whole.share < good) mark.flaw = whole.flaw;
    else if (mark.flaw == Flaw::OtherWay) mark.flaw = Flaw::Uneven; // in a part of it only
    if (mark.share >= good) mark.flaw = Flaw::None;
    return mark;
}

} // namespace

std::vector<PieceMark> pieces_marked(const Truth& truth, const Profile& guess)
{
    constexpr double shortest = 1.0 / 12.0;
    std::vector<PieceMark> marks;
    for (const Truth::Piece& piece : truth.pieces)
        if (piece.to - piece.from >= shortest) marks.push_back(marked(truth, guess, piece));
    return marks;
}

} // namespace frame
