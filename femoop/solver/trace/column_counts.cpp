#include "femoop/solver/trace/column_counts.h"

#include <numeric>

#include "femoop/solver/index.h"
#include "femoop/solver/ordering.h"

namespace femoop {

namespace {

constexpr std::int32_t no_column = -1;

/// Follows the row subtrees through the tree in postorder.
class Counter {
public:
    Counter(const OrderedGraph& graph, const std::vector<std::int32_t>& parent)
        : graph_(graph),
          parent_(parent),
          first_(parent.size(), no_column),
          latest_(parent.size(), no_column),
          leaf_(parent.size(), no_column),
          ancestor_(parent.size()),
          counts_(parent.size(), 0)
    {
        std::iota(ancestor_.begin(), ancestor_.end(), 0);
    }

    std::vector<std::int64_t> run()
    {
        std::vector<std::int32_t> places(parent_.size());
        std::iota(places.begin(), places.end(), 0);
        const std::vector<std::int32_t> tree_order = postordered(places, parent_);
        find_first_descendants(tree_order);
        for (const std::int32_t j : tree_order) visit(j);
        for (std::int32_t j = 0; j < graph_.n(); ++j)
            if (parent_[at(j)] != no_column) counts_[at(parent_[at(j)])] += counts_[at(j)];
        return counts_;
    }

private:
    void find_first_descendants(const std::vector<std::int32_t>& tree_order)
    {
        for (std::int32_t k = 0; k < graph_.n(); ++k) {
            const std::int32_t leaf = tree_order[at(k)];
            if (first_[at(leaf)] == no_column) counts_[at(leaf)] = graph_.sizes[at(leaf)];
            for (std::int32_t j = leaf; j != no_column && first_[at(j)] == no_column; j = parent_[at(j)])
                first_[at(j)] = k;
        }
    }

    void visit(std::int32_t j)
    {
        if (parent_[at(j)] != no_column) counts_[at(parent_[at(j)])] -= graph_.sizes[at(j)];
        for (const std::int32_t i : graph_.neighbours[at(j)]) {
            // A leaf of row subtree i has no descendant that was in it before.
            if (i <= j || first_[at(j)] <= latest_[at(i)]) continue;
            latest_[at(i)] = first_[at(j)];
            counts_[at(j)] += graph_.sizes[at(i)];
            if (leaf_[at(i)] != no_column) counts_[at(meeting(leaf_[at(i)]))] -= graph_.sizes[at(i)];
            leaf_[at(i)] = j;
        }
        if (parent_[at(j)] != no_column) ancestor_[at(j)] = parent_[at(j)];
    }

    /// Where the paths of the last leaf and of this one meet: counted twice otherwise.
    std::int32_t meeting(std::int32_t leaf)
    {
        std::int32_t root = leaf;
        while (ancestor_[at(root)] != root) root = ancestor_[at(root)];
        while (leaf != root) {
            const std::int32_t next = ancestor_[at(leaf)];
            ancestor_[at(leaf)] = root;
            leaf = next;
        }
        return root;
    }

    const OrderedGraph& graph_;
    const std::vector<std::int32_t>& parent_;
    std::vector<std::int32_t> first_;    ///< the earliest descendant in postorder
    std::vector<std::int32_t> latest_;   ///< of each row: the largest `first` of its leaves so far
    std::vector<std::int32_t> leaf_;     ///< of each row: the last leaf
    std::vector<std::int32_t> ancestor_; ///< towards the root, shortened
    std::vector<std::int64_t> counts_;   ///< differences to the children's sums, at first
};

} // namespace

std::vector<std::int64_t> column_counts(const OrderedGraph& graph, const std::vector<std::int32_t>& parent)
{
    return Counter(graph, parent).run();
}

} // namespace femoop
