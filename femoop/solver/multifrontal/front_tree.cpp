#include "femoop/solver/multifrontal/front_tree.h"

#include <algorithm>
#include <utility>

#include "femoop/solver/index.h"
#include "femoop/solver/multifrontal/block_groups.h"

namespace femoop {

double elimination_work(std::int32_t n_pivots, std::int32_t n_rows)
{
    const double p = n_pivots, u = n_rows - n_pivots;
    return p * p * p / 6.0 + 0.5 * p * p * u + 0.5 * p * u * u;
}

/// Gives the fronts of a tree their rows.
class FrontTree::Builder {
public:
    Builder(FrontTree& tree, const LowerPattern& pattern)
        : tree_(tree),
          blocks_(pattern),
          front_of_(at(blocks_.n())),
          place_(at(blocks_.n())),
          seen_by_(at(blocks_.n()), none)
    {
        const BlockGroups groups(blocks_, BlockElimination(blocks_));
        gather_pivots(groups, postorder(groups));
        for (std::int32_t f = 0; f < static_cast<std::int32_t>(tree_.fronts_.size()); ++f) {
            touch(f);
            list_rows(f);
            join_parent(f);
        }
    }

private:
    void gather_pivots(const BlockGroups& groups, const std::vector<std::int32_t>& heads)
    {
        tree_.fronts_.resize(heads.size());
        std::vector<std::int32_t> front_of_head(at(groups.n()), none);
        for (std::size_t f = 0; f < heads.size(); ++f) front_of_head[at(heads[f])] = static_cast<std::int32_t>(f);
        Lists front;
        for (std::int32_t block = 0; block < blocks_.n(); ++block) {
            front_of_[at(block)] = front_of_head[at(groups.head_of(block))];
            front.items.push_back(front_of_[at(block)]);
            front.close();
        }
        pivots_ = transposed(front, heads.size());
        for (std::size_t i = 0; i < pivots_.items.size(); ++i)
            place_[at(pivots_.items[i])] = static_cast<std::int32_t>(i);
    }

    /// The places of the blocks that are left to the parent: neighbours of pivots, and what children left.
    void touch(std::int32_t f)
    {
        for (const std::int32_t block : pivots_[f])
            for (const std::int32_t other : blocks_.lower[block]) touch(f, place_[at(other)]);
        for (std::int32_t child = tree_.fronts_[at(f)].first_child; child != none;
             child = tree_.fronts_[at(child)].next_sibling) {
            for (std::size_t i = touched_.begin(child); i < touched_.end(child); ++i) touch(f, touched_.items[i]);
        }
        std::sort(touched_.items.begin() + touched_.start.back(), touched_.items.end());
        touched_.close();
    }
    void touch(std::int32_t f, std::int32_t place)
    {
        if (front_of_[at(pivots_.items[at(place)])] == f || std::exchange(seen_by_[at(place)], f) == f) return;
        touched_.items.push_back(place);
    }

    void list_rows(std::int32_t f)
    {
        Front& front = tree_.fronts_[at(f)];
        front.first_row = tree_.rows_.size();
        front.first_entry = tree_.n_entries_;
        for (const std::int32_t block : pivots_[f]) add_rows(block);
        front.n_pivots = static_cast<std::int32_t>(tree_.rows_.size() - front.first_row);
        for (const std::int32_t place : touched_[f]) add_rows(pivots_.items[at(place)]);
        front.n_rows = static_cast<std::int32_t>(tree_.rows_.size() - front.first_row);
        tree_.n_entries_ += at(front.n_rows) * at(front.n_pivots);
        tree_.n_operations_ += elimination_work(front.n_pivots, front.n_rows);
    }
    void add_rows(std::int32_t block)
    {
        for (std::int32_t i = blocks_.first[at(block)]; i < blocks_.first[at(block) + 1]; ++i) tree_.rows_.push_back(i);
    }

    /// The front that eliminates the first of what is left.
    void join_parent(std::int32_t f)
    {
        if (touched_[f].empty()) return;
        Front& front = tree_.fronts_[at(f)];
        front.parent = front_of_[at(pivots_.items[at(touched_[f].front())])];
        front.next_sibling = std::exchange(tree_.fronts_[at(front.parent)].first_child, f);
    }

    FrontTree& tree_;
    const ColumnBlocks blocks_;
    std::vector<std::int32_t> front_of_; ///< of each block
    std::vector<std::int32_t> place_;    ///< of each block in the order of elimination
    Lists pivots_;                       ///< blocks of each front
    Lists touched_;                      ///< of each front: places of blocks
    std::vector<std::int32_t> seen_by_;  ///< by place: the last front that touched it
};

FrontTree::FrontTree(const LowerPattern& pattern) : n_equations_(pattern.n())
{
    const Builder built(*this, pattern);
    find_places();
}

void FrontTree::find_places()
{
    places_.resize(rows_.size());
    std::vector<std::int32_t> place(n_equations_);
    for (const Front& front : fronts_) {
        for (std::int32_t i = 0; i < front.n_rows; ++i) place[at(rows(front)[at(i)])] = i;
        for (std::int32_t child = front.first_child; child != none; child = fronts_[at(child)].next_sibling) {
            const std::size_t begin = fronts_[at(child)].first_row;
            for (std::int32_t i = fronts_[at(child)].n_pivots; i < fronts_[at(child)].n_rows; ++i)
                places_[begin + at(i)] = place[at(rows_[begin + at(i)])];
        }
    }
}

} // namespace femoop
