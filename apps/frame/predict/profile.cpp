#include "apps/frame/predict/profile.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "femoop/result/expression.h"

namespace frame {

namespace {

using femoop::Curve;
using femoop::MemberComponent;
using femoop::Side;

constexpr double rounding = 1e-6;   // of the largest value: below it a number is zero
constexpr double faint_jump = 0.05; // of the largest value: a jump that no eye sees

void bridge(Profile& profile, std::size_t left, std::size_t right)
{
    for (std::size_t i = left + 1; i < right; ++i) {
        const double t = static_cast<double>(i - left) / static_cast<double>(right - left);
        profile[i] = std::lerp(*profile[left], *profile[right], t);
    }
}

void bridge_small_gaps(Profile& profile)
{
    constexpr std::size_t widest = Guess::n_places / 25;
    std::optional<std::size_t> last;
    for (std::size_t i = 0; i < profile.size(); ++i) {
        if (!profile[i]) continue;
        if (last && i - *last <= widest) bridge(profile, *last, i);
        last = i;
    }
}

double largest_of(const Curve& curve, MemberComponent component)
{
    const femoop::Extremes extremes = curve.extremes(component);
    return std::max(std::abs(extremes.max.value), std::abs(extremes.min.value));
}

Profile sampled(const Curve& curve, MemberComponent component, double largest)
{
    Profile profile;
    std::size_t place = 0;
    for (const Curve::Piece& piece : curve.pieces()) {
        const femoop::Polynomial p = curve.polynomial(component, piece);
        const bool is_last = &piece == &curve.pieces().back();
        for (; place < profile.size(); ++place) {
            const double x = Guess::x(place) * curve.length();
            if (x >= piece.load.end && !is_last) break;
            const double share = p(x - piece.load.begin) / largest;
            profile[place] = std::abs(share) < rounding ? 0.0 : share;
        }
    }
    return profile;
}

// Those inside, and the ends where the diagram begins or ends at the axis.
std::vector<double> zeros_of(const Curve& curve, MemberComponent component, const Truth& truth)
{
    constexpr double edge = 0.01;
    std::vector<double> zeros;
    if (std::abs(*truth.profile.front()) < edge) zeros.push_back(0.0);
    for (const double place : curve.zeros(component)) {
        const double x = place / curve.length();
        const bool is_jump = std::ranges::any_of(truth.jumps, [&](const auto& j) { return std::abs(j.x - x) < 1e-6; });
        if (x > edge && x < 1.0 - edge && !is_jump) zeros.push_back(x);
    }
    if (std::abs(*truth.profile.back()) < edge) zeros.push_back(1.0);
    return zeros;
}

std::vector<Truth::Jump> jumps_of(const Curve& curve, MemberComponent component, double largest)
{
    std::vector<Truth::Jump> jumps;
    for (const double x : curve.breaks()) {
        const double size = curve.value(component, x, Side::After) - curve.value(component, x, Side::Before);
        if (x > 0.0 && x < curve.length() && std::abs(size) > faint_jump * largest)
            jumps.push_back({x / curve.length(), size / largest});
    }
    return jumps;
}

std::vector<Truth::Piece> pieces_of(const Curve& curve, MemberComponent component)
{
    std::vector<Truth::Piece> pieces;
    for (const femoop::Expression& e : femoop::expressions(curve, component)) {
        const int degree = std::max(0, static_cast<int>(e.coefficients.size()) - 1);
        pieces.push_back({e.from / curve.length(), e.to / curve.length(), degree, e.is_series});
    }
    return pieces;
}

} // namespace

Profile profile(const Guess& guess)
{
    Profile profile;
    const double largest = guess.largest();
    if (!(largest > 0.0)) return profile;
    for (std::size_t i = 0; i < profile.size(); ++i)
        if (guess[i]) profile[i] = *guess[i] / largest;
    bridge_small_gaps(profile);
    return profile;
}

Truth truth(const Curve& curve, MemberComponent component)
{
    Truth truth;
    truth.largest = largest_of(curve, component);
    if (!(truth.largest > 0.0)) return truth;
    truth.profile = sampled(curve, component, truth.largest);
    truth.jumps = jumps_of(curve, component, truth.largest);
    truth.zeros = zeros_of(curve, component, truth);
    truth.pieces = pieces_of(curve, component);
    return truth;
}

namespace {

using femoop::influence::InfluenceLine;
using femoop::influence::LinePiece;
using femoop::influence::PathMember;

/// An influence line along one member of its path, from the member's first end on; places in lengths of the member.
class LineOnMember {
public:
    LineOnMember(const InfluenceLine& line, const PathMember& on) : line_(line), on_(on)
    {
        for (const LinePiece& piece : line.ordinates.pieces) {
            const double begin = std::max(piece.from, on.begin), end = std::min(piece.to, on.end());
            if (end - begin > rounding * on.length) parts_.push_back({&piece, begin, end});
        }
        for (const Part& part : parts_)
            for (const double s : places_to_look_at(part))
                largest_ = std::max(largest_, std::abs(part.piece->value(s)));
    }

    double largest() const { return largest_; }

    Profile profile() const
    {
        Profile profile;
        for (std::size_t i = 0; i < profile.size(); ++i) {
            const double share = value(Guess::x(i)) / largest_;
            profile[i] = std::abs(share) < rounding ? 0.0 : share;
        }
        return profile;
    }

    std::vector<Truth::Jump> jumps() const
    {
        std::vector<Truth::Jump> jumps;
        for (std::size_t i = 1; i < parts_.size(); ++i) {
            const double s = parts_[i].begin, size = parts_[i].piece->value(s) - parts_[i - 1].piece->value(s);
            if (std::abs(size) > faint_jump * largest_)
                jumps.push_back({x_of(s), (on_.is_reversed ? -size : size) / largest_});
        }
        return in_order(std::move(jumps), &Truth::Jump::x);
    }

    /// But for those where it jumps, and at the ends.
    std::vector<double> zeros(const std::vector<Truth::Jump>& jumps) const
    {
        std::vector<double> zeros;
        for (const Part& part : parts_)
            for (const double s : part.piece->places_of(0.0)) {
                const double x = x_of(s);
                const auto is_near = [&](double other) { return std::abs(other - x) < edge; };
                const bool is_jump = std::ranges::any_of(jumps, is_near, &Truth::Jump::x);
                const bool is_known = std::ranges::any_of(zeros, is_near);
                if (x > edge && x < 1.0 - edge && !is_jump && !is_known) zeros.push_back(x);
            }
        std::ranges::sort(zeros);
        return zeros;
    }

    std::vector<Truth::Piece> pieces() const
    {
        std::vector<Truth::Piece> pieces;
        for (std::size_t i = 0; i < parts_.size(); ++i) {
            const Part& part = parts_[i];
            if (i > 0 && goes_on(parts_[i - 1], part)) {
                widen(pieces.back(), part);
                continue;
            }
            const auto [from, to] = std::minmax({x_of(part.begin), x_of(part.end)});
            pieces.push_back({from, to, degree(part), is_series(part)});
        }
        return in_order(std::move(pieces), &Truth::Piece::from);
    }

    static constexpr double edge = 0.01;

private:
    struct Part {
        const LinePiece* piece;
        double begin, end; ///< s
    };

    double x_of(double s) const { return on_.x_of(s) / on_.length; }

    double value(double x) const
    {
        const double s = on_.s_of(x * on_.length);
        for (const Part& part : parts_)
            if (s < part.end || &part == &parts_.back()) return part.piece->value(s);
        return 0.0;
    }

    static std::vector<double> places_to_look_at(const Part& part)
    {
        std::vector<double> places{part.begin, part.end};
        for (const double s : part.piece->turning_places())
            if (s > part.begin && s < part.end) places.push_back(s);
        return places;
    }

    /// The formula does not change from the one to the other.
    bool goes_on(const Part& before, const Part& after) const
    {
        const double middle = 0.5 * (after.begin + after.end);
        return std::ranges::all_of(std::array{after.begin, middle, after.end}, [&](double s) {
            return std::abs(before.piece->value(s) - after.piece->value(s)) <= rounding * largest_;
        });
    }

    void widen(Truth::Piece& piece, const Part& part) const
    {
        piece.from = std::min({piece.from, x_of(part.begin), x_of(part.end)});
        piece.to = std::max({piece.to, x_of(part.begin), x_of(part.end)});
    }

    /// Without what rounding leaves of higher terms.
    int degree(const Part& part) const
    {
        const std::vector<double>& c = part.piece->coefficients;
        int degree = 0;
        for (std::size_t k = 1; k < c.size(); ++k)
            if (std::abs(c[k]) * std::pow(part.piece->length(), static_cast<double>(k)) > rounding * largest_)
                degree = static_cast<int>(k);
        return degree;
    }

    bool is_series(const Part& part) const
    {
        return std::ranges::any_of(line_.stretches, [&](const auto& stretch) {
            return stretch.is_series && stretch.from <= part.begin && part.end <= stretch.to;
        });
    }

    template <class List, class Place> static List in_order(List list, Place place)
    {
        std::ranges::sort(list, {}, place);
        return list;
    }

    const InfluenceLine& line_;
    PathMember on_;
    std::vector<Part> parts_;
    double largest_ = 0.0;
};

} // namespace

Truth truth(const InfluenceLine& line, const PathMember& on)
{
    const LineOnMember along(line, on);
    Truth truth;
    truth.largest = along.largest();
    if (!(truth.largest > 0.0)) return truth;
    truth.profile = along.profile();
    truth.jumps = along.jumps();
    truth.pieces = along.pieces();
    if (std::abs(*truth.profile.front()) < LineOnMember::edge) truth.zeros.push_back(0.0);
    for (const double x : along.zeros(truth.jumps)) truth.zeros.push_back(x);
    if (std::abs(*truth.profile.back()) < LineOnMember::edge) truth.zeros.push_back(1.0);
    return truth;
}

} // namespace frame
