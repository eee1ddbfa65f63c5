#include "ui/paint/style.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace ui {

DashPattern::DashPattern(std::initializer_list<double> lengths) : count_(lengths.size())
{
    if (lengths.size() > max_lengths) throw std::invalid_argument("dash pattern: more than 6 lengths");
    if (lengths.size() % 2 != 0) throw std::invalid_argument("dash pattern: each drawn length needs a skipped one");
    const auto is_bad = [](double l) { return !std::isfinite(l) || l < 0.0; };
    if (std::any_of(lengths.begin(), lengths.end(), is_bad))
        throw std::invalid_argument("dash pattern: a length is negative or not finite");
    std::copy(lengths.begin(), lengths.end(), lengths_.begin());
    if (!is_solid() && period() <= 0.0) throw std::invalid_argument("dash pattern: all lengths are zero");
}

double DashPattern::period() const
{
    const auto all = lengths();
    return std::accumulate(all.begin(), all.end(), 0.0);
}

DashPattern DashPattern::scaled(double factor) const
{
    DashPattern result = *this;
    for (double& length : result.lengths_) length *= factor;
    return result;
}

} // namespace ui
