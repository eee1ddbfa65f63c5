// Where a guess meets the axis.
#include "apps/frame/predict/aspects.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "apps/frame/predict/places.h"

namespace frame {

using namespace places;

namespace {

// Where the guess goes from one side to the other, by more than a hand trembles.
std::vector<double> crossings(const Profile& guess)
{
    constexpr double tremble = 0.05;
    std::vector<double> places;
    int last = -1;
    for (int i = 0; i < n; ++i) {
        if (!is_drawn(guess, i) || std::abs(at(guess, i)) <= tremble) continue;
        if (last >= 0 && at(guess, last) * at(guess, i) < 0.0) places.push_back(0.5 * (x(last) + x(i)));
        last = i;
    }
    return places;
}

double distance_to_zero(const Profile& guess, const std::vector<double>& crossings, double zero)
{
    constexpr double on_axis = 0.06;
    double least = 1.0;
    for (int i = 0; i < n; ++i) {
        const double away = std::abs(x(i) - zero);
        if (is_drawn(guess, i) && std::abs(at(guess, i)) <= on_axis) least = std::min(least, away);
    }
    for (const double place : crossings) least = std::min(least, std::abs(place - zero));
    return least;
}

// Takes the nearest of the places within reach out of the list.
bool take_near(std::vector<double>& places, double x, double reach)
{
    const auto away = [x](double place) { return std::abs(place - x); };
    const auto nearest = std::ranges::min_element(places, {}, away);
    if (nearest == places.end() || away(*nearest) > reach) return false;
    places.erase(nearest);
    return true;
}

// A crossing for which the true diagram has neither a zero nor a jump.
int n_needless(const Truth& truth, const std::vector<double>& crossings)
{
    constexpr double reach = 0.15, zero = 0.02;
    std::vector<double> reasons = truth.zeros;
    for (const Truth::Jump& jump : truth.jumps) reasons.push_back(jump.x);
    const auto is_zero = [&](int i) { return std::abs(at(truth.profile, i)) <= zero; };
    return static_cast<int>(std::ranges::count_if(
        crossings, [&](double x) { return !take_near(reasons, x, reach) && !holds_near(place_of(x), 0.0, is_zero); }));
}

// Where the guess meets an end, going on straight from what is drawn a little before it: a line that only closes the
// diagram at the end does not count.
std::optional<double> value_at(int end, const Profile& guess)
{
    constexpr int from = 8, to = 18;
    const auto inward = [end](int i) { return end == 0 ? i : end - i; };
    for (int i = from; i <= to; ++i)
        if (!is_drawn(guess, inward(i))) return std::nullopt;
    double near = 0.0, far = 0.0; // means of both halves
    constexpr int half = (from + to) / 2;
    for (int i = from; i < half; ++i) near += at(guess, inward(i)) / (half - from);
    for (int i = half + 1; i <= to; ++i) far += at(guess, inward(i)) / (to - half);
    constexpr double near_place = 0.5 * (from + half - 1), far_place = 0.5 * (half + 1 + to);
    return near - (far - near) * near_place / (far_place - near_place);
}

// A guess that meets the axis where the true diagram is large, as at a fixed end.
bool is_falsely_zero_at(int end, const Truth& truth, const Profile& guess)
{
    constexpr double on_axis = 0.08, large = 0.25;
    const auto value = value_at(end, guess);
    return value && std::abs(*value) <= on_axis && std::abs(at(truth.profile, end)) >= large;
}

} // namespace

PlaceCount zeros_found(const Truth& truth, const Profile& guess)
{
    constexpr double good = 0.05, bad = 0.15;
    const std::vector<double> crossed = crossings(guess);
    PlaceCount count{.n_true = static_cast<int>(truth.zeros.size())};
    double sum = 0.0;
    for (const double x : truth.zeros) {
        const double share = ramp(distance_to_zero(guess, crossed, x), bad, good);
        sum += share;
        if (share >= 0.5) ++count.n_found;
    }
    count.n_extra = n_needless(truth, crossed);
    for (const int end : {0, n - 1}) count.n_extra += is_falsely_zero_at(end, truth, guess) ? 1 : 0;
    if (count.is_about_something()) count.share = sum / (count.n_true + count.n_extra);
    return count;
}

} // namespace frame
