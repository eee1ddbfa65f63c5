#include "femoop/methods/mohr/loading_path.h"

#include <algorithm>
#include <cmath>

namespace femoop::mohr {

PlaneState state_on(const LoadingPath& path, double t)
{
    const double place = std::clamp(t, 0.0, 1.0) * static_cast<double>(path.size() - 1);
    const auto before = std::min(static_cast<std::size_t>(place), path.size() - 1);
    const PlaneState &a = path[before], &b = path[std::min(before + 1, path.size() - 1)];
    const double share = place - static_cast<double>(before);
    return {std::lerp(a.x, b.x, share), std::lerp(a.y, b.y, share), std::lerp(a.xy, b.xy, share)};
}

std::vector<CirclePoint> stress_path(const LoadingPath& path, std::size_t n)
{
    std::vector<CirclePoint> points;
    if (path.empty()) return points;
    const std::size_t n_pieces = n * (path.size() - 1);
    for (std::size_t i = 0; i <= n_pieces; ++i) {
        const double t = n_pieces == 0 ? 0.0 : static_cast<double>(i) / static_cast<double>(n_pieces);
        const auto [centre, radius] = circle(state_on(path, t));
        points.push_back({centre, radius});
    }
    return points;
}

} // namespace femoop::mohr
