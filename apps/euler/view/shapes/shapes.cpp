#include "apps/euler/view/shapes/shapes.h"

#include <algorithm>
#include <limits>

namespace euler {

double thinning(std::size_t n_edges)
{
    constexpr double few = 100.0, many = 600.0;
    return std::clamp((static_cast<double>(n_edges) - few) / (many - few), 0.0, 1.0);
}

double typical_edge(const Shapes& shapes)
{
    std::vector<double> lengths;
    for (const Shapes::Edge& edge : shapes.edges)
        if (edge.line.size() == 2) lengths.push_back(ui::distance(edge.line.front(), edge.line.back()));
    if (lengths.empty()) return std::numeric_limits<double>::infinity();
    const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
    std::nth_element(lengths.begin(), middle, lengths.end());
    return *middle;
}

} // namespace euler
