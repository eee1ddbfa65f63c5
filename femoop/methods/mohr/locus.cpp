#include "femoop/methods/mohr/locus.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>

namespace femoop::mohr {

namespace {

using std::numbers::pi;

SpacePrincipal principal_in_order(std::array<double, 3> values)
{
    std::ranges::sort(values, std::greater{});
    return {.values = values};
}

/// The deviator of this size has principal values sqrt(2/3) size cos(lode - 2 k pi / 3).
SpacePrincipal deviated(double mean, double size, double lode)
{
    const double reach = std::sqrt(2.0 / 3.0) * size, turn = 2.0 * pi / 3.0;
    return principal_in_order(
        {mean + reach * std::cos(lode), mean + reach * std::cos(lode - turn), mean + reach * std::cos(lode + turn)});
}

} // namespace

std::vector<StressPair> failing_pairs(Criterion criterion, const Strength& strength, double share, double reach,
                                      std::size_t n)
{
    std::vector<StressPair> pairs;
    for (std::size_t i = 0; i < n; ++i) {
        const double t = 2.0 * pi * static_cast<double>(i) / static_cast<double>(n);
        const double a = std::cos(t), b = std::sin(t);
        const double factor =
            safety(criterion, strength, principal_in_order({a, b, share * (a + b)})).factor.value_or(reach);
        pairs.push_back({std::min(factor, reach) * a, std::min(factor, reach) * b});
    }
    return pairs;
}

std::optional<double> failing_deviator(Criterion criterion, const Strength& strength, double mean, double lode)
{
    // What a material bears holds the origin and has no dents, so a stress is borne if its factor is 1 or more.
    const auto is_borne = [&](double size) {
        return safety(criterion, strength, deviated(mean, size, lode)).factor.value_or(1.0) >= 1.0;
    };
    if (!is_borne(0.0)) return 0.0;
    const double largest = std::max({strength.fy, strength.ft, strength.fc, strength.c, strength.sci, std::abs(mean)});
    double low = 0.0, high = largest;
    for (int i = 0; is_borne(high); ++i, high *= 2.0)
        if (i == 40) return std::nullopt;
    for (int i = 0; i < 50; ++i) (is_borne(0.5 * (low + high)) ? low : high) = 0.5 * (low + high);
    return low;
}

} // namespace femoop::mohr
