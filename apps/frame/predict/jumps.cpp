// Where a guess jumps.
#include "apps/frame/predict/aspects.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "apps/frame/predict/places.h"

namespace frame {

using namespace places;

namespace {

constexpr int half = 5;       // places on either side across which a jump is seen
constexpr int closing = 8;    // places at the ends: a line from the axis to the first ordinate is no jump
constexpr int border = 14;    // places at the ends where none is looked for
constexpr double seen = 0.15; // of the largest ordinate

/// By how much a profile jumps about a place: its change across it, less what the slopes on both sides make of it.
double step_at(const Profile& profile, int place)
{
    constexpr int least = 4; // places that a slope is taken over
    const int left = place - half, right = place + half;
    const int far_left = std::max(closing, left - 2 * half), far_right = std::min(n - 1 - closing, right + 2 * half);
    for (int i = far_left; i <= far_right; ++i)
        if (!is_drawn(profile, i)) return 0.0;
    const auto slope = [&](int from, int to) { return (at(profile, to) - at(profile, from)) / (to - from); };
    const bool has_left = left - far_left >= least, has_right = far_right - right >= least;
    const double before = has_left ? slope(far_left, left) : slope(right, far_right);
    const double after = has_right ? slope(right, far_right) : slope(far_left, left);
    return at(profile, right) - at(profile, left) - half * (before + after);
}

struct Steps {
    explicit Steps(const Profile& profile)
    {
        for (int i = border; i < n - border; ++i) size.at(static_cast<std::size_t>(i)) = step_at(profile, i);
    }
    double operator[](int place) const { return size[static_cast<std::size_t>(place)]; }
    double largest_near(int place) const
    {
        double largest = 0.0;
        for (int i = std::max(0, place - 2 * half); i <= std::min(n - 1, place + 2 * half); ++i)
            largest = std::max(largest, std::abs((*this)[i]));
        return largest;
    }
    bool is_peak(int place) const
    {
        const double own = std::abs((*this)[place]);
        if (own <= seen) return false;
        for (int i = std::max(0, place - 2 * half); i <= std::min(n - 1, place + 2 * half); ++i) {
            const double other = std::abs((*this)[i]);
            if (other > own || (other == own && i < place)) return false;
        }
        return true;
    }

    std::array<double, Guess::n_places> size{};
};

std::vector<Truth::Jump> jumps_of(const Steps& steps)
{
    std::vector<Truth::Jump> jumps;
    for (int i = border; i < n - border; ++i)
        if (steps.is_peak(i)) jumps.push_back({x(i), steps[i]});
    return jumps;
}

double likeness(const Truth::Jump& wanted, const Truth::Jump& found)
{
    const double ratio = found.size / wanted.size;
    return ramp(std::abs(found.x - wanted.x), 0.12, 0.05) * ramp(ratio, 0.15, 0.45) * ramp(ratio, 5.0, 2.5);
}

} // namespace

PlaceCount jumps_found(const Truth& truth, const Profile& guess)
{
    const Steps true_steps(truth.profile);
    std::vector<Truth::Jump> drawn = jumps_of(Steps(guess));
    PlaceCount count;
    double sum = 0.0;
    for (const Truth::Jump& jump : truth.jumps) {
        if (place_of(jump.x) < border || place_of(jump.x) >= n - border) continue;
        ++count.n_true;
        const auto like = [&](const Truth::Jump& found) { return likeness(jump, found); };
        const auto best = std::ranges::max_element(drawn, {}, like);
        if (best == drawn.end() || like(*best) == 0.0) continue;
        sum += like(*best);
        if (like(*best) >= 0.5) ++count.n_found;
        drawn.erase(best);
    }
    count.n_extra = static_cast<int>(std::ranges::count_if(drawn, [&](const Truth::Jump& jump) {
        return std::abs(jump.size) - true_steps.largest_near(place_of(jump.x)) > seen;
    }));
    if (count.is_about_something()) count.share = sum / (count.n_true + count.n_extra);
    return count;
}

} // namespace frame
