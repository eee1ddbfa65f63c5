#include "apps/frame/predict/aspects.h"

#include <algorithm>
#include <cmath>

#include "apps/frame/predict/places.h"

namespace frame {

using namespace places;

double sign_share(const Truth& truth, const Profile& guess)
{
    constexpr double reach = 0.025, zero = 0.01, near_axis = 0.04, on_axis = 0.12, enough = 0.97;
    int n_right = 0, n_wrong = 0;
    for (int place = 0; place < n; ++place) {
        const double g = at(guess, place);
        const auto is_same = [&](int i) {
            return std::abs(at(truth.profile, i)) > zero && at(truth.profile, i) * g > 0.0;
        };
        const auto is_like = [&](int i) {
            return is_same(i) || (std::abs(at(truth.profile, i)) <= near_axis && std::abs(g) <= on_axis);
        };
        if (!is_drawn(guess, place)) ++n_wrong;
        else if (is_same(place) && std::abs(at(truth.profile, place)) > near_axis) ++n_right;
        else if (!holds_near(place, reach, is_like)) ++n_wrong; // else beside a zero or a jump either side is right
    }
    return n_right > 0 ? ramp(static_cast<double>(n_right) / (n_right + n_wrong), 0.0, enough) : 0.0;
}

double extreme_share(const Truth& truth, const Profile& guess)
{
    constexpr double reach = 0.04;
    int largest = 0;
    for (int i = 1; i < n; ++i)
        if (std::abs(at(guess, i)) > std::abs(at(guess, largest))) largest = i;
    const double side = at(guess, largest) < 0.0 ? -1.0 : 1.0;
    double best = 0.0;
    const int width = place_of(reach);
    for (int i = std::max(0, largest - width); i <= std::min(n - 1, largest + width); ++i)
        best = std::max(best, side * at(truth.profile, i));
    const auto n_drawn = std::ranges::count_if(guess, [](const auto& value) { return value.has_value(); });
    return ramp(best, 0.6, 0.9) * static_cast<double>(n_drawn) / n;
}

} // namespace frame
