#include "topology/meshing/quadtree.h"

namespace topology {

void Quadtree::quarter(Index leaf)
{
    const Square whole = squares_[leaf];
    squares_[leaf].first_quarter = static_cast<Index>(squares_.size());
    const Step half = whole.side() / 2;
    for (const Step up : {Step{0}, half})
        for (const Step across : {Step{0}, half})
            squares_.push_back({.x = whole.x + across, .y = whole.y + up, .level = whole.level + 1});
}

Quadtree::Index Quadtree::leaf_at(Step x, Step y) const
{
    Index square = 0;
    while (!squares_[square].is_leaf()) {
        const Square& here = squares_[square];
        const Step half = here.side() / 2;
        square = here.first_quarter + (x >= here.x + half ? 1U : 0U) + (y >= here.y + half ? 2U : 0U);
    }
    return square;
}

FlatBox Quadtree::box(Index square) const
{
    const Square& here = squares_[square];
    return {place(here.x, here.y), place(here.x + here.side(), here.y + here.side())};
}

} // namespace topology
