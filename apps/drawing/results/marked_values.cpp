#include "apps/drawing/results/marked_values.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace drawing {

namespace {

using femoop::Side;

bool are_equal(double a, double b, double least) { return std::abs(a - b) <= least; }

class Collector {
public:
    Collector(const LineFunction& function, double least) : function_(function), least_(least) {}

    std::vector<MarkedValue> collect()
    {
        add_ends_and_breaks();
        add_extremes();
        std::stable_sort(found_.begin(), found_.end(), [](const auto& a, const auto& b) { return a.x < b.x; });
        merge_plateaus();
        std::erase_if(found_, [&](const MarkedValue& m) { return !(std::abs(m.value) > least_); });
        return std::move(found_);
    }

private:
    double at(double x, Side side = Side::After) const { return function_.value(x, side); }

    void add(double x, double value, bool is_peak)
    {
        for (MarkedValue& other : found_) {
            if (std::abs(other.x - x) > 1e-6 * function_.length() || !are_equal(other.value, value, least_)) continue;
            other.is_peak = other.is_peak || is_peak;
            return;
        }
        found_.push_back({x, value, is_peak});
    }

    void add_ends_and_breaks()
    {
        const std::vector<double> breaks = function_.breaks();
        for (std::size_t i = 0; i < breaks.size(); ++i) {
            const double x = breaks[i];
            const double before = at(x, Side::Before);
            const double after = at(x, Side::After);
            if (i == 0) add(x, after, false);
            else if (i + 1 == breaks.size()) add(x, before, false);
            else if (!are_equal(before, after, least_)) {
                add(x, before, false);
                add(x, after, false);
            } else if (has_kink(x)) {
                add(x, after, true);
            }
        }
    }

    // Where the slope jumps, as that of a bending moment does where its shear force jumps.
    bool has_kink(double x) const
    {
        const auto before = function_.slope(x, Side::Before), after = function_.slope(x, Side::After);
        return before && after && std::abs(*after - *before) * function_.length() > 1e-3 * least_;
    }

    void add_extremes()
    {
        for (const double x : function_.level_places()) add(x, at(x), true);
        const femoop::Extremes extremes = function_.extremes();
        add(extremes.max.x, extremes.max.value, true);
        add(extremes.min.x, extremes.min.value, true);
    }

    void merge_plateaus()
    {
        std::vector<MarkedValue> merged;
        for (const MarkedValue& next : found_) {
            if (!merged.empty() && is_plateau(merged.back(), next)) {
                MarkedValue& first = merged.back();
                const double begin = first.others.empty() ? first.x : first.others.front();
                first.others = {begin, next.x};
                first.x = 0.5 * (begin + next.x);
                first.is_peak = first.is_peak || next.is_peak;
            } else {
                merged.push_back(next);
            }
        }
        found_ = std::move(merged);
    }

    bool is_plateau(const MarkedValue& a, const MarkedValue& b) const
    {
        const double end = a.others.empty() ? a.x : a.others.back();
        return b.x > end && are_equal(a.value, b.value, least_) && are_equal(at(0.5 * (end + b.x)), a.value, least_);
    }

    const LineFunction& function_;
    double least_;
    std::vector<MarkedValue> found_;
};

} // namespace

std::vector<MarkedValue> marked_values(const LineFunction& function, double least)
{
    return Collector(function, least).collect();
}

} // namespace drawing
