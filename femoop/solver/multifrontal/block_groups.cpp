#include "femoop/solver/multifrontal/block_groups.h"

#include <algorithm>
#include <functional>
#include <numeric>
#include <utility>

#include "femoop/solver/index.h"

namespace femoop {

namespace {

constexpr std::int32_t no_group = BlockGroups::none;

double entries(double n_pivots, double n_rows) { return n_pivots * n_rows - 0.5 * n_pivots * (n_pivots - 1.0); }

bool is_worth(std::int32_t pivots, double share_of_zeros)
{
    if (pivots <= 16) return share_of_zeros < 0.6;
    if (pivots <= 48) return share_of_zeros < 0.2;
    return share_of_zeros < 0.05;
}

} // namespace

BlockGroups::BlockGroups(const ColumnBlocks& blocks, const BlockElimination& elimination)
{
    gather(blocks, elimination);
    merge();
    for (std::int32_t group = n(); group-- > 0;) head_[at(group)] = head(head(group));
}

std::int32_t BlockGroups::parent(std::int32_t head_group) const
{
    const std::int32_t above = parent_[at(head_group)];
    return above == no_group ? no_group : head(above);
}

/// Those that follow one another with the same rows below.
void BlockGroups::gather(const ColumnBlocks& blocks, const BlockElimination& elimination)
{
    for (std::int32_t block = 0; block < blocks.n(); ++block) {
        const bool is_first = block == 0 || elimination.parent[at(block - 1)] != block ||
                              elimination.n_rows[at(block - 1)] - blocks.size(block - 1) !=
                                  elimination.n_rows[at(block)];
        if (is_first) {
            n_pivots_.push_back(0);
            n_rows_.push_back(elimination.n_rows[at(block)]);
        }
        n_pivots_.back() += blocks.size(block);
        group_of_.push_back(n() - 1);
    }
    parent_.assign(at(n()), no_group);
    for (std::int32_t block = 0; block < blocks.n(); ++block)
        if (const std::int32_t above = elimination.parent[at(block)];
            above != no_group && group_of_[at(above)] != group_of_[at(block)])
            parent_[at(group_of_[at(block)])] = group_of_[at(above)];
}

/// Takes children into their parent, where this stores few zeros: those first that have most rows.
void BlockGroups::merge()
{
    head_.resize(at(n()));
    std::iota(head_.begin(), head_.end(), 0);
    zeros_.assign(at(n()), 0.0);
    const Lists children = this->children();
    std::vector<std::int32_t> candidates;
    for (std::int32_t group = 0; group < n(); ++group) {
        candidates.assign(children[group].begin(), children[group].end());
        std::ranges::stable_sort(candidates, std::greater<>(), [&](std::int32_t c) { return n_rows_[at(c)]; });
        for (const std::int32_t child : candidates) merge(child, group);
    }
}

Lists BlockGroups::children() const
{
    Lists parent;
    for (std::int32_t group = 0; group < n(); ++group) {
        if (parent_[at(group)] != no_group) parent.items.push_back(parent_[at(group)]);
        parent.close();
    }
    return transposed(parent, at(n()));
}

void BlockGroups::merge(std::int32_t child, std::int32_t group)
{
    const std::int32_t pivots = n_pivots_[at(child)] + n_pivots_[at(group)];
    const std::int32_t rows = n_pivots_[at(child)] + n_rows_[at(group)];
    const double all = entries(pivots, rows);
    const double zeros = zeros_[at(child)] + zeros_[at(group)] + all -
                         entries(n_pivots_[at(child)], n_rows_[at(child)]) -
                         entries(n_pivots_[at(group)], n_rows_[at(group)]);
    if (!is_worth(pivots, zeros / all)) return;
    head_[at(child)] = group;
    n_pivots_[at(group)] = pivots;
    n_rows_[at(group)] = rows;
    zeros_[at(group)] = zeros;
}

namespace {

class Postorder {
public:
    explicit Postorder(const BlockGroups& groups) : groups_(groups), children_(at(groups.n()) + 1)
    {
        need_.assign(at(groups.n()), 0.0);
        for (std::int32_t head = 0; head < groups.n(); ++head)
            if (groups.is_head(head)) arrange(head);
        for (const std::int32_t root : children_.back()) visit(root);
    }
    std::vector<std::int32_t> take() { return std::move(order_); }

private:
    double left(std::int32_t head) const
    {
        const double n = groups_.n_rows(head) - groups_.n_pivots(head);
        return n * n;
    }
    void arrange(std::int32_t head)
    {
        std::vector<std::int32_t>& children = children_[at(head)];
        std::ranges::stable_sort(children, std::greater<>(), [&](std::int32_t c) { return need_[at(c)] - left(c); });
        double held = 0.0, need = 0.0;
        for (const std::int32_t child : children) {
            need = std::max(need, held + need_[at(child)]);
            held += left(child);
        }
        need_[at(head)] = std::max(need, held + left(head));
        const std::int32_t parent = groups_.parent(head);
        children_[parent == no_group ? children_.size() - 1 : at(parent)].push_back(head);
    }
    void visit(std::int32_t root)
    {
        std::vector<std::pair<std::int32_t, std::size_t>> path{{root, 0}};
        while (!path.empty()) {
            auto& [head, next] = path.back();
            if (next < children_[at(head)].size()) {
                const std::int32_t child = children_[at(head)][next++];
                path.emplace_back(child, 0);
            } else {
                order_.push_back(head);
                path.pop_back();
            }
        }
    }

    const BlockGroups& groups_;
    std::vector<std::vector<std::int32_t>> children_; ///< of each head, and the roots
    std::vector<double> need_;                        ///< numbers held at a time
    std::vector<std::int32_t> order_;
};

} // namespace

std::vector<std::int32_t> postorder(const BlockGroups& groups) { return Postorder(groups).take(); }

} // namespace femoop
