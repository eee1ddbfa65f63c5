#include "apps/cross/view/bay_scale.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace cross {

namespace {

double interpolated(const std::vector<double>& from, const std::vector<double>& to, double x)
{
    if (from.size() < 2) return x;
    if (x <= from.front()) return to.front() + (x - from.front());
    if (x >= from.back()) return to.back() + (x - from.back());
    const auto i = static_cast<std::size_t>(std::ranges::upper_bound(from, x) - from.begin());
    const double share = (x - from[i - 1]) / (from[i] - from[i - 1]);
    return to[i - 1] + share * (to[i] - to[i - 1]);
}

std::vector<double> at_rate(const std::vector<double>& lengths, const std::vector<double>& needs, double rate)
{
    std::vector<double> all;
    for (std::size_t i = 0; i < lengths.size(); ++i) all.push_back(std::max(needs[i], rate * lengths[i]));
    return all;
}

double total(const std::vector<double>& values)
{
    double total = 0.0;
    for (const double value : values) total += value;
    return total;
}

} // namespace

BayScale::BayScale(std::vector<double> places, std::vector<double> drawn)
    : places_(std::move(places)), drawn_(std::move(drawn))
{}

double BayScale::operator()(double place) const { return interpolated(places_, drawn_, place); }

double BayScale::inverse(double drawn) const { return interpolated(drawn_, places_, drawn); }

std::vector<double> breadths(const std::vector<double>& lengths, const std::vector<double>& needs, double breadth)
{
    constexpr int halvings = 60; // to the last bit
    double low = 0.0, high = breadth / total(lengths);
    for (int i = 0; i < halvings; ++i) {
        const double rate = 0.5 * (low + high);
        (total(at_rate(lengths, needs, rate)) <= breadth ? low : high) = rate;
    }
    return at_rate(lengths, needs, high);
}

} // namespace cross
