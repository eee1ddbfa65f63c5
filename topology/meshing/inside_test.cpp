#include "topology/meshing/inside_test.h"

#include <algorithm>

#include "topology/geometry/flat_point.h"

namespace topology {

InsideTest::InsideTest(const MeshDomain& domain)
{
    constexpr std::size_t most_bands = 512; // an edge from bottom to top is in all of them
    std::vector<Edge> edges;
    FlatBox box;
    for (const auto& loop : domain.loops)
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const Edge edge{domain.nodes[loop[i]], domain.nodes[loop[(i + 1) % loop.size()]]};
            box.add(edge.a);
            if (edge.a.y != edge.b.y) edges.push_back(edge); // a level one passes by no place
        }
    bands_.resize(std::clamp<std::size_t>(edges.size() / 2, 1, most_bands));
    const double height = box.high.y - box.low.y;
    low_ = box.low.y;
    bands_per_height_ = height > 0.0 ? static_cast<double>(bands_.size()) / height : 0.0;
    for (const Edge& edge : edges) {
        const std::size_t last = band_of(std::max(edge.a.y, edge.b.y));
        for (std::size_t band = band_of(std::min(edge.a.y, edge.b.y)); band <= last; ++band)
            bands_[band].push_back(edge);
    }
}

/// Never falls where y grows, rounding included, so that an edge is in the bands of all heights that it has.
std::size_t InsideTest::band_of(double y) const
{
    const double band = (y - low_) * bands_per_height_;
    return band > 0.0 ? std::min(static_cast<std::size_t>(band), bands_.size() - 1) : 0;
}

bool InsideTest::has_inside(const FlatPoint& at) const
{
    bool is_inside = false;
    for (const auto& [a, b] : bands_[band_of(at.y)]) {
        if ((a.y > at.y) == (b.y > at.y)) continue;
        if (a.x + (at.y - a.y) / (b.y - a.y) * (b.x - a.x) > at.x) is_inside = !is_inside;
    }
    return is_inside;
}

} // namespace topology
