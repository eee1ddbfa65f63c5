#include "femoop/solver/ordering.h"

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include "femoop/solver/elimination_tree.h"
#include "femoop/solver/geometric_dissection.h"
#include "femoop/solver/index.h"
#include "femoop/solver/metis_ordering.h"

namespace femoop {

namespace {

constexpr std::int32_t no_block = -1;

struct Named {
    Ordering ordering;
    std::string_view name;
};
constexpr std::array names{Named{Ordering::Natural, "natural"}, Named{Ordering::CuthillMcKee, "cuthill-mckee"},
                           Named{Ordering::MinimumDegree, "minimum-degree"},
                           Named{Ordering::NestedDissection, "nested-dissection"}};

std::vector<std::int32_t> natural(std::size_t n)
{
    std::vector<std::int32_t> order(n);
    std::iota(order.begin(), order.end(), 0);
    return order;
}

/// Breadth-first levels from a block: appends the blocks reached to `queue` (fewest neighbours first among those that
/// one block discovers) and returns where the last level starts.
std::size_t walk_levels(const BlockAdjacency& adjacency, std::int32_t root, std::vector<std::int32_t>& seen,
                        std::int32_t mark, std::vector<std::int32_t>& queue)
{
    const auto degree = [&](std::int32_t block) { return adjacency.of(block).size(); };
    std::size_t level = queue.size();
    queue.push_back(root);
    seen[at(root)] = mark;
    for (std::size_t next = level, end = queue.size(); next < queue.size(); ++next) {
        if (next == end) {
            level = next;
            end = queue.size();
        }
        const std::size_t first_found = queue.size();
        for (const std::int32_t b : adjacency.of(queue[next]))
            if (seen[at(b)] != mark) {
                seen[at(b)] = mark;
                queue.push_back(b);
            }
        std::sort(
            queue.begin() + static_cast<std::ptrdiff_t>(first_found), queue.end(),
            [&](std::int32_t a, std::int32_t b) { return degree(a) != degree(b) ? degree(a) < degree(b) : a < b; });
    }
    return level;
}

/// Reverse Cuthill-McKee, each connected part from a block at its far end.
std::vector<std::int32_t> cuthill_mckee(const BlockAdjacency& adjacency)
{
    const std::size_t n = adjacency.n_blocks();
    std::vector<std::int32_t> order;
    std::vector<std::int32_t> seen(n, no_block);
    order.reserve(n);
    std::int32_t mark = 0;
    for (std::size_t block = 0; block < n; ++block) {
        if (seen[block] != no_block) continue;
        const std::size_t first = order.size();
        auto root = static_cast<std::int32_t>(block);
        constexpr int passes = 3; // the far end of the far end is far enough; the last pass is the order
        for (int pass = 0; pass < passes; ++pass) {
            order.resize(first);
            const std::size_t last_level = walk_levels(adjacency, root, seen, mark++, order);
            if (pass + 1 < passes) root = order[last_level];
        }
    }
    std::reverse(order.begin(), order.end());
    return order;
}

/// Approximate minimum degree by Eigen, which takes both triangles and the diagonal.
std::vector<std::int32_t> minimum_degree(const BlockAdjacency& adjacency)
{
    const auto n = static_cast<std::int32_t>(adjacency.n_blocks());
    Eigen::SparseMatrix<double> both(n, n);
    both.resizeNonZeros(static_cast<Eigen::Index>(adjacency.neighbours.size() + adjacency.n_blocks()));
    std::int32_t* next = both.innerIndexPtr();
    for (std::int32_t block = 0; block < n; ++block) {
        *next++ = block;
        next = std::copy(adjacency.of(block).begin(), adjacency.of(block).end(), next);
        both.outerIndexPtr()[block + 1] = static_cast<std::int32_t>(next - both.innerIndexPtr());
    }
    Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, std::int32_t> order;
    Eigen::AMDOrdering<std::int32_t>()(both.selfadjointView<Eigen::Lower>(), order);
    return {order.indices().data(), order.indices().data() + n};
}

std::vector<std::int32_t> inverse(const std::vector<std::int32_t>& order)
{
    std::vector<std::int32_t> position(order.size());
    for (std::size_t i = 0; i < order.size(); ++i) position[at(order[i])] = static_cast<std::int32_t>(i);
    return position;
}

/// The neighbours of a place in an order, as places.
auto places_beside(const BlockAdjacency& adjacency, const std::vector<std::int32_t>& order)
{
    return [&adjacency, &order, position = inverse(order)](std::int32_t k, const auto& visit) {
        for (const std::int32_t neighbour : adjacency.of(order[at(k)])) visit(position[at(neighbour)]);
    };
}

} // namespace

std::vector<std::int32_t> postordered(const std::vector<std::int32_t>& order, const std::vector<std::int32_t>& parent)
{
    const std::size_t n = order.size();
    std::vector<std::int32_t> first_child(n + 1, no_block); // of n: the roots
    std::vector<std::int32_t> next_sibling(n, no_block);
    for (std::size_t i = n; i-- > 0;) {
        const std::size_t p = parent[i] == no_block ? n : at(parent[i]);
        next_sibling[i] = first_child[p];
        first_child[p] = static_cast<std::int32_t>(i);
    }
    std::vector<std::int32_t> result;
    result.reserve(n);
    std::vector<std::int32_t> path;
    for (std::int32_t root = first_child[n]; root != no_block; root = next_sibling[at(root)]) {
        path.push_back(root);
        while (!path.empty()) {
            const std::int32_t node = path.back();
            if (const std::int32_t child = first_child[at(node)]; child != no_block) {
                first_child[at(node)] = next_sibling[at(child)];
                path.push_back(child);
            } else {
                result.push_back(order[at(node)]);
                path.pop_back();
            }
        }
    }
    return result;
}

std::vector<std::int32_t> elimination_tree(const BlockAdjacency& adjacency, const std::vector<std::int32_t>& order)
{
    return grown_tree(order.size(), places_beside(adjacency, order));
}

double elimination_cost(const BlockAdjacency& adjacency, const std::vector<std::int32_t>& order)
{
    const auto neighbours = places_beside(adjacency, order);
    std::vector<std::int32_t> count(order.size(), 1);
    visit_factor(grown_tree(order.size(), neighbours), neighbours,
                 [&](std::int32_t, std::int32_t i) { ++count[at(i)]; });
    const auto add_square = [](double sum, std::int32_t c) { return sum + static_cast<double>(c) * c; };
    return std::accumulate(count.begin(), count.end(), 0.0, add_square);
}

namespace {

/// The order that is predicted to cost least of those that are worth their own time: dissection in space; minimum
/// degree where it is quickly found, or the structure is a tower, which is better peeled from its ends; METIS where
/// positions say little about what is joined to what, so that cuts in space are wide.
std::vector<std::int32_t> dissected(const BlockAdjacency& adjacency, std::span<const Eigen::Vector3d> positions)
{
    constexpr double few = 4000.0; // blocks
    const auto n = static_cast<double>(adjacency.n_blocks());
    std::vector<std::vector<std::int32_t>> candidates;
    bool is_slender = false, is_wide = true;
    if (!positions.empty()) {
        Dissection in_space = geometric_dissection(adjacency, positions);
        const auto width = static_cast<double>(in_space.first_cut);
        is_slender = n > 2.5 * width * width;
        is_wide = width > 2.0 * std::cbrt(n * n);
        candidates.push_back(std::move(in_space.order));
    }
    if (is_slender || is_wide || n <= few) candidates.push_back(minimum_degree(adjacency));
    if (is_wide) candidates.push_back(metis_order(adjacency));
    std::erase_if(candidates, [](const auto& order) { return order.empty(); });
    if (candidates.size() == 1) return std::move(candidates.front());
    std::vector<double> costs;
    for (const auto& order : candidates) costs.push_back(elimination_cost(adjacency, order));
    return candidates[static_cast<std::size_t>(std::min_element(costs.begin(), costs.end()) - costs.begin())];
}

} // namespace

std::string_view name(Ordering ordering) { return std::ranges::find(names, ordering, &Named::ordering)->name; }

std::optional<Ordering> ordering_named(std::string_view name)
{
    const auto* const found = std::ranges::find(names, name, &Named::name);
    return found == names.end() ? std::nullopt : std::optional(found->ordering);
}

std::vector<std::int32_t> elimination_order(const BlockAdjacency& adjacency, Ordering ordering,
                                            std::span<const Eigen::Vector3d> positions)
{
    if (adjacency.n_blocks() == 0) return {};
    if (ordering == Ordering::Natural) return natural(adjacency.n_blocks());
    if (ordering == Ordering::CuthillMcKee) return cuthill_mckee(adjacency);
    const std::vector<std::int32_t> order = ordering == Ordering::NestedDissection ? dissected(adjacency, positions)
                                                                                   : minimum_degree(adjacency);
    return postordered(order, elimination_tree(adjacency, order));
}

} // namespace femoop
