#pragma once

#include <algorithm>
#include <cmath>

#include "apps/frame/predict/profile.h"

/// How the aspects of a diagram look at its places.
namespace frame::places {

inline constexpr int n = static_cast<int>(Guess::n_places);

/// 0 up to a, 1 from b on, straight between them; for a > b it falls.
inline double ramp(double value, double a, double b) { return std::clamp((value - a) / (b - a), 0.0, 1.0); }

inline double x(int place) { return Guess::x(static_cast<std::size_t>(place)); }
inline int place_of(double x) { return std::clamp(static_cast<int>(std::lround(x * (n - 1))), 0, n - 1); }

/// The ordinate; 0 where nothing is drawn.
inline double at(const Profile& profile, int place) { return profile[static_cast<std::size_t>(place)].value_or(0.0); }
inline bool is_drawn(const Profile& profile, int place) { return profile[static_cast<std::size_t>(place)].has_value(); }

/// Whether it holds at some place within `reach` lengths of this one.
template <class Condition> bool holds_near(int place, double reach, const Condition& is_so)
{
    const int width = place_of(reach);
    for (int i = std::max(0, place - width); i <= std::min(n - 1, place + width); ++i)
        if (is_so(i)) return true;
    return false;
}

} // namespace frame::places
