#include "topology/planar/edge_grid.h"

namespace topology {

namespace {

constexpr std::size_t most_cells = 4'000'000;

} // namespace

EdgeGrid::EdgeGrid(const FlatBox& box, std::size_t n) : box_(box)
{
    const double size = std::max(box.high.x - box.low.x, box.high.y - box.low.y);
    const double cells = static_cast<double>(std::clamp<std::size_t>(n, 16, most_cells));
    const double w = std::max(box.high.x - box.low.x, 1e-3 * size), h = std::max(box.high.y - box.low.y, 1e-3 * size);
    const double step = std::sqrt(w * h / cells);
    n_columns_ = std::clamp<std::size_t>(static_cast<std::size_t>(w / step), 1, most_cells);
    n_rows_ = std::clamp<std::size_t>(static_cast<std::size_t>(h / step), 1, most_cells);
    width_ = w / static_cast<double>(n_columns_);
    height_ = h / static_cast<double>(n_rows_);
    firsts_.assign(n_columns_ * n_rows_, none);
}

bool EdgeGrid::covers(const FlatBox& box) const { return !firsts_.empty() && box_.has(box.low) && box_.has(box.high); }

} // namespace topology
