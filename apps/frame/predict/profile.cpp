#include "apps/frame/predict/profile.h"

#include <algorithm>
#include <cmath>

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

} // namespace frame
